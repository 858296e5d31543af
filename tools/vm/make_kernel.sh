#!/usr/bin/env bash
# Gets Debian's arm64 kernel and builds for it vimc, the kernel's virtual camera, which Debian does not ship.
#   tools/vm/make_kernel.sh FOLDER
# FOLDER then holds
#   vmlinuz    the kernel
#   modules/   vimc and the modules that it needs, named in the order in which to load them
#   root/      busybox, and the parts of libcamera that it looks for while it runs
# Nothing is installed. Needs 1 GB beside FOLDER while it works. Quick when FOLDER is there; to have a newer kernel,
# delete it.
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,/^set/s/^# //p' "$0" >&2; exit 2; }
folder=$(realpath -m "$1")
tools=$(realpath "$(dirname "$0")/..")
[ ! -e "$folder" ] || exit 0

part=$folder.part
rm -rf "$part"
mkdir -p "$part/packages" "$part/new/modules" "$part/new/root"
trap 'rm -rf "$part"' EXIT

# The board's architecture, and this machine's: the programs that build a module must run here.
board() { "$tools/foreign_apt.sh" arm64 "$part/apt-board" "$@"; }
here() { "$tools/foreign_apt.sh" "$(dpkg --print-architecture)" "$part/apt-here" "$@"; }
board apt-get update || true  # one list that is missing may not matter: the packages decide
here apt-get update || true
version=$(board apt-cache depends linux-image-arm64 | sed -n 's/^ *Depends: linux-image-//p')
[ -n "$version" ] || { echo "The package sources of this machine give no linux-image-arm64" >&2; exit 1; }
series=${version%.0-*}

cd "$part/packages"
board apt-get download "linux-image-$version" "linux-headers-$version" "linux-headers-${version%-arm64}-common" \
  "linux-source-$series" busybox-static libcamera-ipa
here apt-get download "linux-kbuild-$series"
cd "$part"
"$tools/unpack_packages.sh" all packages/*.deb

vimc=linux-source-$series/drivers/media/test-drivers/vimc
headers=all/usr/src/linux-headers-$version
tar -xf "all/usr/src/linux-source-$series.tar.xz" "$vimc"
sed -i 's|/usr/src/|../|' "$headers/Makefile"  # it expects to be installed; its neighbour lies beside it here too
make -C "$headers" ARCH=arm64 CROSS_COMPILE=aarch64-linux-gnu- CONFIG_VIDEO_VIMC=m M="$part/$vimc" modules
install -D -t "all/lib/modules/$version/extra" "$vimc/vimc.ko"

PATH=$PATH:/sbin
depmod -b all "$version"
number=10
for module in $(modprobe -d "$part/all" -S "$version" --show-depends vimc | sed 's/^insmod //'); do
  cp "$module" "new/modules/$number-$(basename "$module")"
  number=$((number + 1))
done
cp "all/boot/vmlinuz-$version" new/vmlinuz
(cd all && cp -r --parents bin/busybox usr/lib/*/libcamera usr/share/libcamera "$part/new/root")
mv new "$folder"
