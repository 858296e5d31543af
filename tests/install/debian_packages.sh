#!/usr/bin/env bash
# Makes the packages twice and looks into them.
#   debian_packages.sh CPACK BUILD FOLDER VERSION SOURCE
set -euo pipefail
cpack=$1 build=$2 folder=$3 version=$4 source=$5
here=$(dirname "$0")
export SOURCE_DATE_EPOCH=1700000000  # also where there is no git to ask
fail() { echo "$*"; exit 1; }

rm -rf "$folder"
mkdir -p "$folder/first" "$folder/second"
for run in first second; do
  "$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$folder/$run" >"$folder/log" 2>&1 ||
    { cat "$folder/log"; exit 1; }
done
for deb in "$folder"/first/*.deb; do
  cmp "$deb" "$folder/second/$(basename "$deb")"
done

find_deb() { ls "$folder/first/$1_$version"_*.deb; }
field() { dpkg-deb --field "$(find_deb "$1")" "$2"; }
holds() {  # PACKAGE FILE...
  local list
  list=$(dpkg-deb --contents "$(find_deb "$1")" | awk '{ print substr($6, 2) }')
  if grep -vE '^/(usr/.*)?$' <<<"$list"; then fail "$1 has files outside of /usr"; fi
  for file in "${@:2}"; do grep -qxF "$file" <<<"$list" || fail "$1 does not hold $file"; done
}
holds articam-tools /usr/bin/articam-{board,detect,listen,markers,modelgen,probe,replay,sim} \
  /usr/share/doc/articam-tools/copyright /usr/share/man/man1/articam-modelgen.1.gz
holds articam-dev /usr/include/articam/core/tracker/tracker.hpp /usr/include/articam/hal/receiver/receiver.hpp \
  /usr/lib/libarticam_board.a /usr/lib/cmake/articam/articamConfig.cmake /usr/share/articam/articam-board.service \
  /usr/share/articam/examples/outside_project/CMakeLists.txt /usr/share/doc/articam-dev/copyright
[[ $(field articam-tools Depends) == *libc6*libtinyxml2* ]] || fail "articam-tools lacks its libraries"
[[ $(field articam-dev Depends) == *"articam-tools (= $version)"*libeigen3-dev* ]] || fail "articam-dev lacks packages"

for name in tools dev; do dpkg-deb --extract "$(find_deb "articam-$name")" "$folder/root"; done
"$here/names_no_folder.sh" "$folder/root" "$source" "$build"
"$here/includes_are_there.sh" "$folder/root/usr/include/articam"
"$folder/root/usr/bin/articam-modelgen" --version | grep -qxF "articam-modelgen $version"
