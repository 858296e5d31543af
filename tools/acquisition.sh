#!/usr/bin/env bash
# Renders random views of the printer and finds it in each, without being told where to look.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/acquisition.sh [VIEWS]

Builds core_tracker_test with the preset host-release and runs its acquisition of rendered views on VIEWS (default
2000): all markers in view, 0.4 to 1.5 m, tilt to 60 degrees. Prints every view that was not right, and fails if one was
wrong and yet sure, or if fewer than 99.5 % were right.
END
    exit 0 ;;
esac

tools/quietly.sh "Building core_tracker_test" tools/build_preset.sh host-release --target core_tracker_test
ARTICAM_VIEWS="${1:-2000}" build/host-release/bin/core_tracker_test --gtest_filter='AcquisitionOfRenderedViews.*'
