#!/usr/bin/env bash
# Unpacks Debian packages into a new folder that can stand for the root of a machine, without their documentation.
#   tools/unpack_packages.sh FOLDER FILE.deb...
set -euo pipefail
[ $# -ge 2 ] || { sed -n '2,3s/^# //p' "$0" >&2; exit 2; }
folder=$1
shift

# One place for libraries, whether a package says /lib or /usr/lib, as on the machines that the packages are made for.
mkdir -p "$folder/usr/lib"
ln -s usr/lib "$folder/lib"
for deb in "$@"; do
  dpkg-deb --fsys-tarfile "$deb" | tar -x -C "$folder" --keep-directory-symlink --no-same-owner \
    --exclude='./usr/share/doc/*' --exclude='./usr/share/man/*' --exclude='./usr/share/locale/*'
done

# An absolute link would lead out of the folder, to this machine's own files.
find "$folder" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
  ln -sfn "$(realpath -ms --relative-to="$(dirname "$link")" "$folder$(readlink "$link")")" "$link"
done
