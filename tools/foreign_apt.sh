#!/usr/bin/env bash
# Runs apt-get or apt-cache for another architecture with a state of its own.
#   tools/foreign_apt.sh ARCH STATE apt-get update
#   tools/foreign_apt.sh ARCH STATE apt-get download busybox-static
# The package sources are the machine's, and so are its keys and proxies. What is installed, known and cached lies in
# the folder STATE, where nothing counts as installed: the machine's own packages stay untouched, and no root is needed.
set -euo pipefail

[ $# -ge 4 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
arch=$1
mkdir -p "$2/lists/partial" "$2/archives/partial"
state=$(realpath "$2")
shift 2
[ -e "$state/status" ] || : >"$state/status"

exec "$@" \
  -o APT::Architecture="$arch" -o APT::Architectures= -o APT::Architectures::="$arch" -o APT::Sandbox::User=root \
  -o Dir::State="$state" -o Dir::State::status="$state/status" -o Dir::Cache="$state" -o Acquire::Retries=3
