#!/usr/bin/env bash
# What the detector and the solver cost, as ratios to floors of the same run, beside what is asked for.
set -euo pipefail
cd "$(dirname "$0")/.."

repetitions=25
case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/bench_table.sh [--repetitions N]

Builds articam-bench, runs each benchmark N times (25), all of them interleaved, and prints as markdown the least time
of each, its ratio to the least of its floor, and the ratio that is asked for. Others' load on the machine only ever
adds to a time, so the least is the program's own. Half a minute.
Exit codes: 0 all targets are met, 1 some are not, 2 wrong usage.
Example:  tools/bench_table.sh --repetitions 50 > table.md
END
    exit 0 ;;
  --repetitions) repetitions=${2-} ;;
  ?*) echo "bench_table.sh: unknown option $1; see --help" >&2; exit 2 ;;
esac
[[ $repetitions =~ ^[1-9][0-9]*$ ]] || { echo "bench_table.sh: --repetitions takes a number; see --help" >&2; exit 2; }

# benchmark, floor, most
targets='detect/full/0 floor/frame_pass 15
detect/full/1 floor/frame_pass 15
detect/full/6 floor/frame_pass 20
detect/full/20 floor/frame_pass 28
detect/full/checker floor/frame_pass 10
detect/full/worst floor/frame_pass 100
detect/tracked/6 floor/frame_pass 4
detect/tracked_window/6 floor/frame_pass 7
acquire/PrinterDrawer floor/frame_pass 150
step/PrinterDrawer floor/frame_pass 6
vvs/iteration/PrinterDrawer/double floor/vvs_generic 0.45
vvs/iteration/PrinterDrawer/float floor/vvs_generic 0.45'

tools/quietly.sh "Building articam-bench" tools/build_preset.sh host-release --tests ON --target articam-bench >&2
names=$(cut -d' ' -f1,2 <<<"$targets" | tr ' ' '\n' | sort -u | paste -sd'|')
build/host-release/bin/articam-bench --benchmark_filter="^($names)\$" --benchmark_repetitions="$repetitions" \
  --benchmark_enable_random_interleaving=true --benchmark_min_time=0.02 --benchmark_format=json |
  awk -F': ' -v targets="$targets" '
    { gsub(/[",]/, "") }
    $1 ~ /^ *name$/ { name = $2 }
    $1 ~ /^ *run_type$/ { repetition = $2 == "iteration" }
    $1 ~ /^ *cpu_time$/ && repetition && (!(name in least) || $2 + 0 < least[name]) { least[name] = $2 + 0 }
    END {
      print "| benchmark | least us | floor | ratio | at most | |\n|---|---|---|---|---|---|"
      failed = 0
      rows = split(targets, row, "\n")
      for (i = 1; i <= rows; ++i) {
        split(row[i], t, " ")
        ratio = least[t[1]] / least[t[2]]
        verdict = ratio <= t[3] ? "pass" : "fail"
        if (verdict == "fail") failed = 1
        printf "| %s | %.3g | %s | %.2f | %s | %s |\n", t[1], least[t[1]] / 1000, t[2], ratio, t[3], verdict
      }
      exit failed
    }'
