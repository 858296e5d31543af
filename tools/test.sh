#!/usr/bin/env bash
# Installs what is missing, builds with GCC, Clang and cross compilers, and runs every test that this machine can run.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -gt 0 ]; then
  cat <<'END'
Usage: tools/test.sh

Installs missing packages (root or sudo), builds preset host-release with GCC into build/host-release, the programs
that compute with Clang into build/host-release-clang, and runs all tests; some hold the two builds against each other:
both compute the same bits. Where the cross compilers are (tools/setup_cross.sh installs them), it builds for cortex-m7
and aarch64, too, and runs their tests under emulators: of aarch64 the board's program, the link and the tests of core,
hal and the bits. (`cmake --build --preset aarch64 && ctest --preset aarch64` is all of them.) GCC on this machine
compiles the firmware for all static models, the other compilers for three: the paper's printer, one with mimic joints
and dots, and the one with the most joints. (`cmake --preset PRESET` gives a build all of them again.) Prints failures
and ctest's summaries; the whole logs are build/PRESET/tests.log.

Exit codes: 0 all passed, 1 something failed, 2 wrong usage.
END
  case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
fi

# What passed is not worth a line; what failed, what was skipped and the summary are.
failed=0
run_tests() {  # PRESET [CTEST_OPTION...]
  local log=build/$1/tests.log
  echo "Tests of $1"
  ctest --preset "$1" -j "$(nproc)" "${@:2}" >"$log" 2>&1 || failed=1
  grep -vE '^ *Start +[0-9]+:|Passed +[0-9.]+ sec$|^Test project|^$' "$log" || true
}

there() { for program; do command -v "$program" >/dev/null || return 1; done; }

tools/install_packages.sh clang libbenchmark-dev libgtest-dev libopencv-dev \
  libclang-rt-dev `# what fuzzers include and link` \
  libkdl-parser-dev liborocos-kdl-dev liburdfdom-dev `# another opinion on URDF and on its mechanics` \
  coinor-libclp-dev `# another opinion on quadratic programs` \
  librsvg2-bin poppler-utils `# other eyes on what articam-markers draws` \
  dpkg-dev file `# cpack`
CXX=g++ tools/quietly.sh "Building with GCC" tools/build_preset.sh host-release --tests ON
# Each model costs a compiler about 15 s.
firmware=(--firmware 'PrinterDrawer;SwitchPanel;Stress24')
computing=(--target articam-bits --target articam-board --target articam-listen --target articam-modelgen
  --target articam-sim --target fuzz_detector --target fuzz_modelgen)
# The URDF corpus is not part of the repository; without it the build has no such targets.
corpus=()
if [ -d ../shared/urdf_corpus ]; then corpus=(--target corpus_verdicts); fi
CXX=clang++ tools/quietly.sh "Building with Clang" tools/build_preset.sh host-release --tests ON \
  --into build/host-release-clang "${firmware[@]}" "${computing[@]}" "${corpus[@]}"
run_tests host-release

if there arm-none-eabi-g++ qemu-system-arm; then
  tools/quietly.sh "Building for Cortex-M7" tools/build_preset.sh cortex-m7 --tests ON "${firmware[@]}"
  run_tests cortex-m7
else
  echo "Cortex-M7 is not tested: no cross compiler or emulator here (tools/setup_cross.sh cortex-m7)"
fi

if there aarch64-linux-gnu-g++ qemu-aarch64 && [ -e build/sysroot-aarch64 ]; then
  of_the_board=()
  for target in articam-{bits,board} core_{math,model,tracker}_test vision_geometry_test hal_test board_test wire_test \
    packet_{inlet,link}_test receiver_test authentication_test hal_{libcamera,supervision,v4l2}_test bits_test \
    articam_firmware planted_{allowed,forbidden} articam-stack receiver_example; do
    of_the_board+=(--target "$target")
  done
  if [ ${#corpus[@]} -gt 0 ]; then of_the_board+=(--target corpus_test); fi
  tools/quietly.sh "Building for aarch64" tools/build_preset.sh aarch64 --tests ON "${firmware[@]}" "${of_the_board[@]}"
  run_tests aarch64 --exclude-regex '_NOT_BUILT|^(FuzzLink|MustNotCompile|SameBits)'
else
  echo "aarch64 is not tested: no cross compiler, emulator or libraries here (tools/setup_cross.sh aarch64)"
fi
exit "$failed"
