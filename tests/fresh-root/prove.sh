#!/bin/sh
# Proves that both README commands work on a bare machine: makes a minimal Debian or Ubuntu with debootstrap, puts a
# clean checkout of HEAD into it and runs ./test, ./run without a display, and ./run a second time. Needs root,
# debootstrap, about 3 GB of disk and the network; not part of ./test.
#   tests/fresh-root/prove.sh [SUITE] [DIR]      e.g. bookworm /var/tmp/agv-root (made anew)
# SUITE: bookworm, trixie, noble, or another that debootstrap knows. For Ubuntu on a Debian machine KEYRING names the
# file ubuntu-archive-keyring.gpg of the package ubuntu-keyring.
set -eu
suite="${1:-bookworm}"
root="${2:-/var/tmp/agv-fresh-$suite}"
case "$suite" in
jammy | noble | oracular | plucky) mirror="${MIRROR:-http://archive.ubuntu.com/ubuntu}" components=main,universe ;;
*) mirror="${MIRROR:-http://deb.debian.org/debian}" components=main ;;
esac
source_dir="$(git -C "$(dirname "$0")" rev-parse --show-toplevel)"

step() { printf '\n=== %s (%s)\n' "$1" "$(date -u +%H:%M:%S)"; }
leave() { umount "$root/proc" "$root/dev/pts" "$root/dev" 2>/dev/null || true; }
trap leave EXIT

[ -e "$root" ] && { echo "$root exists; remove it or name another directory" >&2; exit 2; }
step "debootstrap --variant=minbase $suite"
debootstrap --variant=minbase --components="$components" ${KEYRING:+--keyring="$KEYRING"} "$suite" "$root" "$mirror" \
    >"$root.log" 2>&1 || { tail "$root.log" >&2; exit 1; }
mount --bind /dev "$root/dev"
# A bind does not take what is mounted below along; the virtual COM port of the tests is a pseudo terminal.
mount --bind /dev/pts "$root/dev/pts"
mount -t proc proc "$root/proc"
[ -f /etc/resolv.conf ] && cp /etc/resolv.conf "$root/etc/resolv.conf"
[ -d /etc/apt/apt.conf.d ] && cp -n /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
mkdir -p "$root/root/agv-console"
git -C "$source_dir" archive HEAD | tar x -C "$root/root/agv-console"

inside() { env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 chroot "$root" sh -c "cd /root/agv-console && $1"; }

step "./test from nothing"
started=$(date +%s)
inside ./test
echo "./test took $(($(date +%s) - started)) s"

step "./run without a display"
started=$(date +%s)
inside './run --robot 1 --seed 7'
echo "./run took $(($(date +%s) - started)) s"

step "a second ./run, to its --version"
inside 'date +%s.%N; ./run --version; date +%s.%N'
step "all proved in $root"
