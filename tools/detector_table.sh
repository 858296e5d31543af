#!/usr/bin/env bash
# How well the detector finds and measures rings, as markdown tables beside what is asked for.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/detector_table.sh [OPTION...]

Builds articam-detector-table and runs it: rendered rings of 72 to 12 px, tilted by 0 to 70 deg, under blur, clutter,
uneven light and motion, then frames of what is no ring. Some minutes. Options are the program's:
  --marks N          marks in a cell, at least (400)
  --false-frames N   frames of what is no ring (200)
  --seed N           of places, tilts, clutter and noise (7)
Exit codes: 0 all targets are met, 1 some are not, 2 wrong usage.
Example:  tools/detector_table.sh --marks 1000 > table.md
END
    exit 0 ;;
esac

tools/quietly.sh "Building articam-detector-table" tools/build_preset.sh host-release --tests ON \
  --target articam-detector-table >&2
exec build/host-release/bin/articam-detector-table "$@"
