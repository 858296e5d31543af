#!/usr/bin/env bash
# Runs a command and keeps its output to itself, unless the command fails.
#   tools/quietly.sh WHAT COMMAND [ARGUMENT...]
set -u
what=$1
shift
log=$(mktemp)
trap 'rm -f "$log"' EXIT
SECONDS=0
printf '%-42s' "$what"
if "$@" >"$log" 2>&1; then
  printf '%4d s\n' "$SECONDS"
else
  printf 'failed\n'
  cat "$log" >&2
  exit 1
fi
