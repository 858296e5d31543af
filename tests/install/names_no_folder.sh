#!/usr/bin/env bash
# No file below FOLDER holds the name of one of the others: what is installed is the same wherever it was built.
#   names_no_folder.sh FOLDER NAME...
set -euo pipefail
folder=$1
patterns=()
for name in "${@:2}"; do patterns+=(-e "$name"); done
[ -n "$(find "$folder" -type f -print -quit)" ] || { echo "$folder is empty"; exit 1; }
if grep -rlF "${patterns[@]}" "$folder"; then
  echo "these files name ${*:2}"
  exit 1
fi
