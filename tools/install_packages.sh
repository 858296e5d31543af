#!/usr/bin/env bash
# Installs the Debian or Ubuntu packages that the build and the demo use, where they are missing.
#   tools/install_packages.sh [PACKAGE...]   the names given are wanted too, such as those of the tests
# Asks nothing. Needs root or sudo only when something is missing.
set -euo pipefail

wanted=(
  # compilers and build
  g++ cmake ninja-build pkg-config
  # core
  libeigen3-dev
  # host programs
  libcairo2-dev libcli11-dev libfmt-dev libmd-dev libtinyxml2-dev libyaml-cpp-dev nlohmann-json3-dev
  # the link to a controller, and its authentication
  nanopb libnanopb-dev libsodium-dev
  # articam-listen: the link's messages, and ROS 2's
  libfastcdr-dev libprotobuf-dev protobuf-compiler
  # the board's program: cameras
  libcamera-dev
  # the figures of the report, and real frames
  gnuplot-nox visp-images-data
  "$@"
)

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "These packages are missing, and without root or sudo they cannot be installed: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
as_root+=(env DEBIAN_FRONTEND=noninteractive)
apt=(apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)

"$(dirname "$0")/quietly.sh" "Package lists" "${as_root[@]}" "${apt[@]}" update
"$(dirname "$0")/quietly.sh" "Installing ${#missing[@]} packages" \
  "${as_root[@]}" "${apt[@]}" install --yes --no-install-recommends "${missing[@]}"
