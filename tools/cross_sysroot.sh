#!/usr/bin/env bash
# Makes a folder of another architecture's libraries and headers, to compile and to emulate programs against.
#   tools/cross_sysroot.sh ARCH FOLDER PACKAGE...
# ARCH is Debian's word: arm64, armhf. The packages and all that they depend on are downloaded from the package sources
# of this machine and unpacked, never installed: no root, no foreign architecture added, nothing changed outside FOLDER
# and FOLDER.apt (lists and downloads, which may be deleted). Quick when FOLDER holds these very packages already; to
# have newer ones, delete it. Exit codes: 0 the folder is there, 1 it could not be made, 2 wrong usage. Example:
#   tools/cross_sysroot.sh arm64 build/sysroot-aarch64 libcamera-dev
#   aarch64-linux-gnu-g++ --sysroot=build/sysroot-aarch64 program.cpp -lcamera
#   qemu-aarch64 -L build/sysroot-aarch64 a.out
set -euo pipefail

usage() { sed -n '2,/^set/s/^# //p' "$0"; }
case ${1:-} in -h | --help) usage; exit 0 ;; esac
[ $# -ge 3 ] || { usage >&2; exit 2; }
arch=$1 folder=${2%/}
shift 2
here=$(dirname "$0")
wanted="$arch $*"
[ "$(cat "$folder/.packages" 2>/dev/null)" != "$wanted" ] || exit 0
if [ -e "$folder" ] && [ ! -e "$folder/.packages" ]; then
  echo "$folder exists and is no folder of this script: name another" >&2
  exit 1
fi

apt=("$here/foreign_apt.sh" "$arch" "$folder.apt")
mkdir -p "$folder.apt"
# A source of this machine that does not know the architecture is no reason to stop: the packages decide.
"${apt[@]}" apt-get update >"$folder.apt/update.log" 2>&1 ||
  echo "Not all package lists of $arch could be had (why: $folder.apt/update.log); going on with the others"
unknown=()
for package in "$@"; do
  "${apt[@]}" apt-cache show "$package" >/dev/null 2>&1 || unknown+=("$package")
done
if [ ${#unknown[@]} -gt 0 ]; then
  echo "The package sources of this machine have for $arch no ${unknown[*]}" >&2
  exit 1
fi

rm -f "$folder.apt"/archives/*.deb
"$here/quietly.sh" "Downloading the packages of $arch" \
  "${apt[@]}" apt-get install --yes --download-only --no-install-recommends "$@"
rm -rf "$folder.part"
"$here/quietly.sh" "Unpacking into $folder" \
  "$here/unpack_packages.sh" "$folder.part" "$folder.apt"/archives/*.deb
echo "$wanted" >"$folder.part/.packages"
rm -rf "$folder"
mv "$folder.part" "$folder"
