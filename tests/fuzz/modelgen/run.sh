#!/usr/bin/env bash
# Runs the fuzzer of the model compiler from the seeds here, and from the URDF corpus if it lies beside the repository.
#   run.sh FUZZ_MODELGEN RUNS [SEED]
# Exit code 77 (skipped) when the program has not been built. New inputs are forgotten, an input that breaks a law stays
# in the folder it was run in.
set -euo pipefail
program=$1 runs=$2 seed=${3:-1}
if [ ! -x "$program" ]; then
  echo "skipped: $program is not built; it needs Clang, tools/test.sh builds it"
  exit 77
fi
here=$(cd "$(dirname "$0")" && pwd)
found=$(mktemp -d)
trap 'rm -rf "$found"' EXIT
folders=("$found" "$here/seeds")
outside=$here/../../../../shared/urdf_corpus
if [ -d "$outside" ]; then folders+=("$outside"); fi
# A hang is a second; memory for what libFuzzer itself keeps comes on top of the compiler's own 64 MiB. libFuzzer's own
# exit code for a finding is 77, too.
"$program" "${folders[@]}" -dict="$here/urdf.dict" -runs="$runs" -seed="$seed" -timeout=1 -max_len=65536 \
  -rss_limit_mb=2048 -malloc_limit_mb=64 -error_exitcode=1 -print_final_stats=1 -verbosity=0
