#!/usr/bin/env bash
# Instructions of one iteration of the solver by callgrind, held against bounds:
#   count_iterations.sh PROGRAM
# PROGRAM is count_iterations. Exit code 77, and a word, where valgrind is not installed.
set -euo pipefail
program=$1
command -v valgrind >/dev/null || { echo "skipped: valgrind is not installed"; exit 77; }

count() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="count_$1" "$program" 2>&1 |
    awk '/Collected/ { print $NF }'
}

failed=0
# hold NAME INSTRUCTIONS FLOOR PERCENT
hold() {
  local name=$1 instructions=$2 floor=$3 percent=$4
  echo "$name $instructions, at most $percent % of $floor"
  if ((instructions == 0 || instructions * 100 > floor * percent)); then echo "FAILED: $name" && failed=1; fi
}

generic=$(count generic)
double=$(count double)
full=$(count full_double)
generic_chains=$(count generic_24x48)
float=$(count float)
hold "iteration, double:" "$double" "$generic" 45
hold "iteration, float:" "$float" "$generic" 45
hold "iteration, double:" "$double" 3000 100
hold "iteration, float:" "$float" 3000 100
hold "full iteration, double:" "$full" "$double" 300
hold "full iteration, float:" "$(count full_float)" "$double" 300
hold "48 markers:" "$(count 48)" "$double" 800
hold "24 joints, 48 markers:" "$(count 24x48)" "$generic_chains" 80
exit $failed
