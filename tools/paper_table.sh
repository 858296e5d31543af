#!/usr/bin/env bash
# The scenario `drawer` on several seeds and in both modes, as one table.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/paper_table.sh [SEEDS]

Runs `articam-sim drawer` (60 s, noise 4 grey levels, blur 0.7 px) with seeds 1 to SEEDS (default 5) in the modes
default and paper, results in out/paper_table, and prints for each: frames tracked, drawer error (RMS), its lag
(slope of the error on the velocity) and the fitted rate of convergence, both with 95 % intervals. Needs a built
preset host-release (tools/demo.sh or tools/test.sh build it). Takes about 10 s a run.
END
    exit 0 ;;
  '' | [1-9] | [1-9][0-9]) seeds=${1:-5} ;;
  *) echo "tools/paper_table.sh: SEEDS is a number from 1 to 99" >&2; exit 2 ;;
esac

sim=build/host-release/bin/articam-sim
[ -x "$sim" ] || { echo "tools/paper_table.sh: $sim is missing; run tools/demo.sh first" >&2; exit 1; }

format='%-8s %4s  %-12s %-12s %-32s %s\n'
printf "$format" mode seed tracked 'drawer RMS' 'lag (95 %)' 'convergence (95 %)'
for mode in default paper; do
  for ((seed = 1; seed <= seeds; ++seed)); do
    folder=out/paper_table/$mode-$seed
    mkdir -p "$folder"
    "$sim" drawer --mode "$mode" --seed "$seed" --out "$folder" >"$folder/summary.txt"
    printf "$format" "$mode" "$seed" \
      "$(sed -n 's/^  frames tracked *\([0-9]*\) of \([0-9]*\)$/\1\/\2/p' "$folder/summary.txt")" \
      "$(sed -n 's/^  drawer_slide *RMS \([^,]*\).*/\1/p' "$folder/summary.txt")" \
      "$(sed -n 's/^  drawer_slide.*lag //p' "$folder/summary.txt")" \
      "$(sed -n 's/^  convergence *//p' "$folder/summary.txt")"
  done
done
