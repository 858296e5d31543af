#!/usr/bin/env bash
# Runs the board's program on an emulated board with an emulated camera, through the real libcamera.
set -euo pipefail
called_from=$PWD
cd "$(dirname "$0")/.."

usage() {
  cat <<'END'
Usage: tools/vm_camera_test.sh [--frames N] [--program FILE]

Boots Debian's arm64 kernel in qemu (machine virt, Cortex-A72) with vimc, the kernel's virtual camera, and lets the
cross-compiled articam-board take N frames (60) through libcamera. vimc shows a test pattern without a marker: every
frame must become one output with status lost or initialising, with rising sequence and monotonic time.

    tools/vm_camera_test.sh --frames 300

FILE is another program of the same options. Its camera file must be of a size that libcamera offers for vimc: width
and height are multiples of 6, hence not 640 x 480; the default is built for 384 x 288. Its shared libraries come from
build/sysroot-aarch64. The first time it fetches about 300 MB of packages; what it makes of them is kept in build/vm,
the console in build/vm/log.txt.

Exit codes: 0 passed, 1 failed, 2 wrong usage.
END
}

frames=60
program=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --frames | --program)
      [ $# -ge 2 ] || { echo "tools/vm_camera_test.sh: $1 needs a value" >&2; exit 2; }
      if [ "$1" = --frames ]; then frames=$2; else program=$(cd "$called_from" && realpath -m "$2"); fi
      shift ;;
    *) echo "tools/vm_camera_test.sh: what is '$1'?" >&2; usage >&2; exit 2 ;;
  esac
  shift
done
[[ $frames =~ ^[1-9][0-9]{0,4}$ ]] || { echo "--frames: 1 to 99999, not '$frames'" >&2; exit 2; }

tools/setup_cross.sh aarch64
tools/install_packages.sh cpio gcc-aarch64-linux-gnu kmod make qemu-system-arm xz-utils
if [ -z "$program" ]; then
  program=build/aarch64/bin/articam-board-384x288
  tools/quietly.sh "Building the board's program" \
    tools/build_preset.sh aarch64 --target articam-board-384x288
fi
[ -x "$program" ] || { echo "$program is no program" >&2; exit 1; }

vm=build/vm
tools/quietly.sh "Kernel and its virtual camera" tools/vm/make_kernel.sh "$vm/kernel"
# vimc cannot be told a rate. A low one keeps the loop from calling an emulated camera silent.
tools/quietly.sh "File system of the board" tools/vm/make_initramfs.sh \
  "$vm/kernel" build/sysroot-aarch64 "$vm/initramfs.gz" "$program" \
  --camera libcamera --rate 5 --frames "$frames" --link stdout

# A board that hangs must not hang the test; the slowest machine emulates a frame a second.
echo "Emulating the board, for at most $((120 + frames)) s"
timeout $((120 + frames)) qemu-system-aarch64 -machine virt -cpu cortex-a72 -smp 2 -m 512 -nodefaults -no-reboot \
  -display none -serial stdio -kernel "$vm/kernel/vmlinuz" -initrd "$vm/initramfs.gz" \
  -append "console=ttyAMA0 quiet panic=-1" >"$vm/log.txt" 2>&1 </dev/null || true  # the console tells
if ! awk -v wanted="$frames" -f tools/vm/check_log.awk "$vm/log.txt"; then
  echo "The board's console is in $vm/log.txt" >&2
  exit 1
fi
