#!/usr/bin/env bash
# Installs the cross compilers and emulators, and gathers the libraries of Linux boards.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<'END'
Usage: tools/setup_cross.sh [PRESET...]

Prepares this machine to build and test for other processors: aarch64 and armhf (boards with Linux), cortex-m7,
cortex-m4f and cortex-m3 (boards without an operating system). Without a PRESET: all of them. Then, for example,
    cmake --preset aarch64 && cmake --build --preset aarch64 && ctest --preset aarch64
Compilers and emulators are packages of this machine (root or sudo). The libraries of Linux boards are unpacked into
build/sysroot-PRESET and not installed. Quick when all is there.

Exit codes: 0 ready, 1 something is missing, 2 wrong usage.
END
}

presets=()
for word in "$@"; do
  case $word in
    -h | --help) usage; exit 0 ;;
    aarch64 | armhf | cortex-m7 | cortex-m4f | cortex-m3) presets+=("$word") ;;
    *) echo "tools/setup_cross.sh: '$word' is no preset of a board" >&2; usage >&2; exit 2 ;;
  esac
done
[ ${#presets[@]} -gt 0 ] || presets=(aarch64 armhf cortex-m7 cortex-m4f cortex-m3)

# What a board's program and the tests link; the list is the same for both Linux boards.
libraries=(
  libbenchmark-dev libc6-dev libcairo2-dev libcamera-dev libcli11-dev libeigen3-dev libfastcdr-dev libfmt-dev
  libgtest-dev libmd-dev libnanopb-dev libprotobuf-dev libsodium-dev libtinyxml2-dev libyaml-cpp-dev
  nlohmann-json3-dev)

packages=()
for preset in "${presets[@]}"; do
  case $preset in
    aarch64) packages+=(g++-aarch64-linux-gnu qemu-user) ;;
    armhf) packages+=(g++-arm-linux-gnueabihf qemu-user) ;;
    cortex-*) packages+=(gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm) ;;
  esac
done
tools/install_packages.sh "${packages[@]}"

for preset in "${presets[@]}"; do
  case $preset in
    aarch64) tools/cross_sysroot.sh arm64 build/sysroot-aarch64 "${libraries[@]}" ;;
    armhf) tools/cross_sysroot.sh armhf build/sysroot-armhf "${libraries[@]}" ;;
  esac
done
