#!/usr/bin/env bash
# Fuzzes the decoders of the link under the address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/fuzz_link.sh [INPUTS [SEED]]

Builds articam-fuzz-link with the preset sanitize and runs it on INPUTS damaged packets, messages and serial streams
(default 1000000, seed 1). Ends with an error at the first broken law or read out of bounds, and names seed and input.
END
    exit 0 ;;
esac

tools/quietly.sh "Building articam-fuzz-link" tools/build_preset.sh sanitize --target articam-fuzz-link
time build/sanitize/bin/articam-fuzz-link --inputs "${1:-1000000}" --seed "${2:-1}"
