#!/usr/bin/env bash
# Installs into a folder beside PREFIX, then moves it there: nothing installed may know where it was put first.
#   into_moved_prefix.sh CMAKE BUILD PREFIX COMPONENT...
set -euo pipefail
cmake=$1 build=$2 prefix=$3
rm -rf "$prefix" "$prefix.first"
for component in "${@:4}"; do
  "$cmake" --install "$build" --prefix "$prefix.first" --component "$component"
done
mv "$prefix.first" "$prefix"
