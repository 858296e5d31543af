#!/usr/bin/env bash
# Fuzzes the model compiler and its report with libFuzzer, under the address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/fuzz_modelgen.sh [RUNS [SEED]]

Builds fuzz_modelgen with Clang and runs it RUNS times (default 1000000, seed 1) on mutations of the seeds in
tests/fuzz/modelgen/seeds and of the URDF corpus at ../shared/urdf_corpus, if it is there. Ends with an error at the
first crash, leak, run of more than a second or broken law, and leaves the input in the folder (crash-..., timeout-...).
END
    exit 0 ;;
esac

CXX=clang++ tools/quietly.sh "Building fuzz_modelgen" tools/build_preset.sh host-release --tests ON \
  --into build/host-release-clang --target fuzz_modelgen
time tests/fuzz/modelgen/run.sh build/host-release-clang/bin/fuzz_modelgen "${1:-1000000}" "${2:-1}"
