#!/usr/bin/env bash
# Packs a program of the board, with the shared libraries that it needs, into the file system of a virtual board.
#   tools/vm/make_initramfs.sh KERNEL SYSROOT OUT PROGRAM [ARGUMENT...]
# KERNEL is the folder of make_kernel.sh, SYSROOT that of cross_sysroot.sh, OUT the file to write.
set -euo pipefail
[ $# -ge 4 ] || { sed -n '2,/^set/s/^# //p' "$0" >&2; exit 2; }
kernel=$1 sysroot=$2 out=$3 program=$4
shift 4
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT

cp -r "$kernel/root/." "$root"
cp -r "$kernel/modules" "$root"
cp "$(dirname "$0")/init" "$root/init"
cp "$program" "$root/program"
echo "$@" >"$root/arguments"
chmod +x "$root/init" "$root/program"
ln -s usr/lib "$root/lib"
ln -s bin "$root/sbin"

# What a file names as needed, and what that needs in turn, until nothing is new. The loader has a place of its own.
triplet=$(basename "$(dirname "$(find "$sysroot/usr/lib" -maxdepth 2 -name 'libc.so.6')")")
libraries=$root/usr/lib/$triplet
mkdir -p "$libraries"
cp "$sysroot"/lib/ld-linux-*.so.1 "$root/lib"
pending=("$root/program" "$libraries"/libcamera/*)
while [ ${#pending[@]} -gt 0 ]; do
  mapfile -t needed < <(readelf -d "${pending[@]}" 2>/dev/null | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | sort -u)
  pending=()
  for name in "${needed[@]}"; do
    if [ -e "$libraries/$name" ] || [ -e "$root/lib/$name" ]; then continue; fi
    if [ ! -e "$sysroot/usr/lib/$triplet/$name" ]; then
      echo "$(basename "$program") needs $name, which is not in $sysroot" >&2
      exit 1
    fi
    cp "$sysroot/usr/lib/$triplet/$name" "$libraries"
    pending+=("$libraries/$name")
  done
done

(cd "$root" && find . | sort | cpio --quiet -o -H newc -R 0:0) | gzip -1 >"$out.part"
mv "$out.part" "$out"
