#!/usr/bin/env bash
# Every #include "..." below FOLDER names a file of FOLDER.
#   includes_are_there.sh FOLDER
set -euo pipefail
cd "$1"
grep -rhoP '^\s*#\s*include "\K[^"]+' . | sort -u >../includes.txt
[ -s ../includes.txt ]
missing=0
while read -r header; do
  [ -e "$header" ] || { echo "not installed: $header"; missing=1; }
done <../includes.txt
rm ../includes.txt
exit "$missing"
