#!/usr/bin/env bash
# Two probes answer alike, byte by byte.
#   same_answers.sh "PROBE WORD..." OTHER_PROBE
set -euo pipefail
lines=$'0 0.1\n0.08 0.12\n0.35 -0.3'
expected=$($1 <<<"$lines")
[ "$(grep -c '^end$' <<<"$expected")" -eq 3 ]
diff <(echo "$expected") <("$2" <<<"$lines")
