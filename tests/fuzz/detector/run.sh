#!/usr/bin/env bash
# Runs the fuzzer of the detector. Any bytes are a frame with marks in it, so that it needs no seeds.
#   run.sh FUZZ_DETECTOR RUNS [SEED]
# Exit code 77 (skipped) when the program has not been built. New inputs are forgotten, an input that breaks a law stays
# in the folder it was run in.
set -euo pipefail
program=$1 runs=$2 seed=${3:-1}
if [ ! -x "$program" ]; then
  echo "skipped: $program is not built; it needs Clang, tools/test.sh builds it"
  exit 77
fi
found=$(mktemp -d)
trap 'rm -rf "$found"' EXIT
# A hang is ten seconds: the slowest frame takes a hundredth of one, but machines may be busy. libFuzzer's own exit code
# for a finding is 77, too.
"$program" "$found" -runs="$runs" -seed="$seed" -timeout=10 -max_len=1024 -len_control=0 -rss_limit_mb=2048 \
  -error_exitcode=1 -print_final_stats=1 -verbosity=0
