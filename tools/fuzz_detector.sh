#!/usr/bin/env bash
# Fuzzes the detector with libFuzzer, under the address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/fuzz_detector.sh [RUNS [SEED]]

Builds fuzz_detector with Clang and runs it RUNS times (default 1000000, seed 1) on odd frames: soft rings and dots,
texture, damage, sizes and strides, options, windows and expected marks that mean something or nothing. Ends with an
error at the first crash, leak, run of more than ten seconds or broken law, and leaves the input in the folder
(crash-..., timeout-...).
END
    exit 0 ;;
esac

CXX=clang++ tools/quietly.sh "Building fuzz_detector" tools/build_preset.sh host-release --tests ON \
  --into build/host-release-clang --target fuzz_detector
time tests/fuzz/detector/run.sh build/host-release-clang/bin/fuzz_detector "${1:-1000000}" "${2:-1}"
