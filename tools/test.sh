#!/usr/bin/env bash
# Installs what is missing, builds with GCC and with Clang, and runs every test that this machine can run.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -gt 0 ]; then
  cat <<'END'
Usage: tools/test.sh

Installs missing packages (root or sudo), builds preset host-release with GCC into build/host-release and
with Clang into build/host-release-clang, and runs all tests. Some tests hold the two builds against each
other: both compute the same bits. Prints failures and ctest's summary; the whole log is
build/host-release/tests.log.

Exit codes: 0 all passed, 1 something failed, 2 wrong usage.
END
  case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
fi

tools/install_packages.sh clang libbenchmark-dev libgtest-dev libopencv-dev libprotobuf-dev protobuf-compiler
CXX=g++ tools/quietly.sh "Building with GCC" tools/build_preset.sh host-release --tests ON
CXX=clang++ tools/quietly.sh "Building with Clang" tools/build_preset.sh host-release --tests ON \
  --into build/host-release-clang

# What passed is not worth a line; what failed, what was skipped and the summary are.
log=build/host-release/tests.log
failed=0
ctest --preset host-release -j "$(nproc)" >"$log" 2>&1 || failed=1
grep -vE '^ *Start +[0-9]+:|Passed +[0-9.]+ sec$' "$log" || true
exit "$failed"
