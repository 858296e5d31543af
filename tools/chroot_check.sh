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
this checkout into it, and runs there, unattended: tools/test.sh and tools/demo.sh, then tools/setup_cross.sh for
aarch64 and cortex-m7 and the tests again, those of the boards included. The packages come from where this machine has
them for that suite. Needs root, debootstrap, git and about 6 GB under TMPDIR; takes three quarters of an hour on two
cores. The output is also kept in out/chroot_check.log.

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
  umount "$root/proc" 2>/dev/null || true
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
cp /etc/resolv.conf "$root/etc/resolv.conf"
apt-config dump | grep -E '^Acquire::https?::(Proxy|CAInfo)' >"$root/etc/apt/apt.conf.d/90from-the-host" || true
# Ubuntu keeps some of the packages in universe; Debian has no such component.
if grep -qi ubuntu "$root/etc/os-release"; then sed -i 's/ main$/ main universe/' "$root/etc/apt/sources.list"; fi

phase "the checkout: what git knows or would add"
mkdir "$root/articam"
git -c safe.directory="$PWD" ls-files -z --cached --others --exclude-standard |
  tar --create --null --files-from=- --ignore-failed-read | tar --extract --no-same-owner --directory "$root/articam"

failed=0
for job in tools/test.sh tools/demo.sh tools/demo.sh "tools/setup_cross.sh aarch64 cortex-m7" tools/test.sh; do
  phase "$job"
  read -ra words <<<"$job"
  inside "/articam/${words[0]}" "${words[@]:1}" </dev/null || { failed=1; echo "$job failed"; }
done
phase "done"
exit "$failed"
