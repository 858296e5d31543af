#!/usr/bin/env bash
# Configures and builds one preset.
#   [CXX=COMPILER] tools/build_preset.sh PRESET [--into FOLDER] [--tests ON|OFF] [--firmware MODEL[;MODEL]...]
#     [--target NAME]...
# CXX counts for a new folder only: to change the compiler of a configured one, cmake would forget the preset.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
folder=build/$preset
configure=()
targets=()
while [ $# -gt 0 ]; do
  case $1 in
    --into) folder=$2 ;;
    --tests) configure+=("-DARTICAM_TESTS=$2") ;;
    --firmware) configure+=("-DARTICAM_FIRMWARE_MODELS=$2") ;;
    --target) targets+=(--target "$2") ;;
    *) echo "tools/build_preset.sh: what is '$1'?" >&2; exit 2 ;;
  esac
  shift 2
done

# A build folder that was made elsewhere, for example copied with the checkout, cannot be used on.
cache=$folder/CMakeCache.txt
if [ -e "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$cache"; then configure+=(--fresh); fi

cmake --preset "$preset" -B "$folder" "${configure[@]}"
cmake --build "$folder" "${targets[@]}"
