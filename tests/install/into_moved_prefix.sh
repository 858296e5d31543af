#!/usr/bin/env bash
# Installs into a folder beside PREFIX, then moves it there: nothing installed may know where it was put first. What
# lies in PREFIX/lib is also found in PREFIX.linked, as /lib is a link to /usr/lib.
#   into_moved_prefix.sh CMAKE BUILD PREFIX COMPONENT...
set -euo pipefail
cmake=$1 build=$2 prefix=$3
rm -rf "$prefix" "$prefix.first"
for component in "${@:4}"; do
  "$cmake" --install "$build" --prefix "$prefix.first" --component "$component"
done
mv "$prefix.first" "$prefix"
mkdir -p "$prefix.linked"
for folder in "$prefix"/lib*; do ln -sfn "$folder" "$prefix.linked/"; done
