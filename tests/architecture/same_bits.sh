#!/usr/bin/env bash
# The same seed gives the same bytes: in two runs, and from two compilers.
#   same_bits.sh BIN OTHER_BIN MODELS     folders of programs, and the folder static_models
# Exit code 77 (skipped) when OTHER_BIN, the other compiler's, has not been built.
set -euo pipefail
bin=$1 other_bin=$2 models=$3
if [ ! -x "$other_bin/articam-sim" ] || [ ! -x "$other_bin/articam-modelgen" ]; then
  echo "skipped: $other_bin is not built; tools/test.sh builds it"
  exit 77
fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# From 15 s on the robot is in control, from 17 s on it pulls.
for mode in default paper; do
  simulate() { "$1/articam-sim" paper --mode "$mode" --duration 19 --out "$out/$mode/$2" >"$out/log"; }
  simulate "$bin" first
  simulate "$bin" second
  simulate "$other_bin" other
  for file in estimates.csv truth.csv control.csv; do
    cmp "$out/$mode/first/$file" "$out/$mode/second/$file"
    cmp "$out/$mode/first/$file" "$out/$mode/other/$file"
  done
done

"$bin/articam-bits" >"$out/bits"
"$other_bin/articam-bits" | cmp "$out/bits" -

if [ -x "$bin/corpus_verdicts" ]; then  # where the URDF corpus lies beside the repository
  "$bin/corpus_verdicts" >"$out/corpus"
  "$other_bin/corpus_verdicts" | cmp "$out/corpus" -
fi

compared=0
for header in "$models"/*/*.hpp; do
  stem=${header%.hpp}
  name=$(sed -n 's/^struct \([A-Za-z0-9]*\).*/\1/p; s/.*constexpr CameraParameters k\([A-Za-z0-9]*\).*/\1/p' "$header")
  sources=(--urdf "$stem.urdf" --markers "$stem.markers.yaml")
  [ -e "$stem.urdf" ] || sources=(--camera "$stem.yaml")
  for programs in "$bin" "$other_bin"; do
    "$programs/articam-modelgen" "${sources[@]}" --name "$name" -o "$out/generated.hpp"
    cmp "$header" "$out/generated.hpp"
  done
  compared=$((compared + 1))
done
[ "$compared" -gt 0 ]
