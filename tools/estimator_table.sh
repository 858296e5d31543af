#!/usr/bin/env bash
# How well the estimator does what is asked of it, as markdown tables beside the targets.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1-} in
  -h | --help)
    cat <<'END'
Usage: tools/estimator_table.sh [OPTION...]

Builds articam-estimator-table and runs it: errors against the Cramer-Rao bound, covariance, marks that lie, starts that
converge, hidden marks, flips, a moving drawer, size and shape. Half a minute. Options are the program's:
  --only NAME    crb, nees, outliers, convergence, hidden, flips, moving or shape; may be given again
  --trials N     of crb; the other items take their part of it (20000)
  --seed N       of noise, starts and views (1)
Exit codes: 0 all targets are met, 1 some are not, 2 wrong usage.
Example:  tools/estimator_table.sh --only crb > table.md
END
    exit 0 ;;
esac

tools/quietly.sh "Building articam-estimator-table" tools/build_preset.sh host-release --tests ON \
  --target articam-estimator-table >&2
exec build/host-release/bin/articam-estimator-table "$@"
