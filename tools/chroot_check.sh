#!/usr/bin/env bash
# A campaign apart from the tests: do both scripts work on a machine that has nothing but the system?
set -euo pipefail
cd "$(dirname "$0")/.."

suite=bookworm
case ${1-} in
  '') ;;
  -h | --help | -*)
    cat <<'END'
Usage: tools/chroot_check.sh [SUITE]

Makes a minimal Debian (default bookworm) or Ubuntu in a temporary folder with debootstrap, puts the files of
this checkout into it, and runs there, unattended, what the README says: tools/demo.sh; tools/setup_cross.sh for
aarch64 and cortex-m7; tools/test.sh; tools/demo.sh again; then the board's program and all of its tests under the
emulator. The packages come from where this machine has them for that suite. Needs root, debootstrap, git and about
6 GB under TMPDIR; takes an hour on two cores. The output is also kept in out/chroot_check.log.

Exit codes: 0 all of it passed, 1 some of it failed, 2 wrong usage.
END
    case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
    ;;
  *) suite=$1 ;;
esac

fail() { echo "tools/chroot_check.sh: $*" >&2; exit 1; }
[ "$(id -u)" -eq 0 ] || fail "needs root"
command -v debootstrap >/dev/null || fail "needs debootstrap (apt-get install debootstrap)"
mirror=$(apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(SITE)' |
  awk -v suite="$suite" '$1 == suite && $2 == "main" { print $3; exit }')
[ -n "$mirror" ] || fail "this machine's apt sources do not offer $suite"

root=$(mktemp -d)
cleanup() {
  umount "$root/proc" "$root/dev/pts" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap cleanup EXIT

mkdir -p out
exec > >(tee out/chroot_check.log) 2>&1
SECONDS=0
phase() { printf '\n== %s (at %d s)\n' "$*" "$SECONDS"; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp TERM=dumb "$@"; }

phase "minimal $suite"
tools/quietly.sh "debootstrap" debootstrap --variant=minbase "$suite" "$root" "$mirror"
mount -t proc proc "$root/proc"
mount --bind /dev/pts "$root/dev/pts"  # serial lines are tested on pseudo terminals
cp /etc/resolv.conf "$root/etc/resolv.conf"
apt-config dump | grep -E '^Acquire::https?::(Proxy|CAInfo)' >"$root/etc/apt/apt.conf.d/90from-the-host" || true
# Ubuntu keeps some of the packages in universe; Debian has no such component.
if grep -qi ubuntu "$root/etc/os-release"; then sed -i 's/ main$/ main universe/' "$root/etc/apt/sources.list"; fi

phase "the checkout: what git knows or would add"
checkout=/usr/src/articam
mkdir -p "$root$checkout"
git -c safe.directory="$PWD" ls-files -z --cached --others --exclude-standard |
  tar --create --null --files-from=- --ignore-failed-read | tar --extract --no-same-owner --directory "$root$checkout"

failed=0
while read -r job; do
  phase "$job"
  inside bash -o pipefail -c "cd $checkout && $job" </dev/null || { failed=1; echo "failed: $job"; }
done <<'END'
tools/demo.sh
tools/setup_cross.sh aarch64 cortex-m7
tools/test.sh
tools/demo.sh
cmake --preset aarch64 >out/aarch64.log && cmake --build --preset aarch64 --target articam-board >>out/aarch64.log
cmake --build --preset aarch64 >>out/aarch64.log && ctest --preset aarch64 --output-on-failure | tail -n 40
END
phase "done"
exit "$failed"
