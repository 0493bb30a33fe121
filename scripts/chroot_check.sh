#!/usr/bin/env bash
# Tries the repository's last commit as a new user would, in a fresh Debian:
#
#   scripts/chroot_check.sh bookworm|trixie [demo|test|all] [user|root|both]
#
# First an ordinary user without sudo (must be told in one line what is missing), then an ordinary user with sudo, then
# root. Each works in a new clone; the first finds nothing installed, so its time includes set-up. Needs root and
# debootstrap. Kept between runs in FAULTCHECK_CHROOTS (default /var/tmp/faultcheck-chroot): the debootstrapped base and
# the packages fetched. MIRROR names another package mirror. Mounts and processes live in namespaces of their own, so
# they are gone whichever way this script ends.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
usage() { sed -n '4s/^# *//p' "$0" >&2; exit 2; }

suite=${1:-}
what=${2:-all}
who=${3:-both}
case "$suite" in bookworm | trixie) ;; *) usage ;; esac
case "$what" in demo | test | all) ;; *) usage ;; esac
case "$who" in user | root | both) ;; *) usage ;; esac
[ "$(id -u)" = 0 ] || { echo "chroot_check: must be run as root" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "chroot_check: debootstrap is missing; install it" >&2; exit 2; }

store=${FAULTCHECK_CHROOTS:-${TMPDIR:-/var/tmp}/faultcheck-chroot}
base="$store/$suite-base"
packages="$store/$suite-packages"

# The second life of this script: inside namespaces of its own, where mounts end with it.
if [ "${FC_CHROOT_INSIDE:-}" != yes ]; then
  mkdir -p "$packages/partial"
  if [ ! -f "$base/.complete" ]; then
    echo "chroot_check: making the base of $suite in $base"
    rm -rf --one-file-system "$base"
    debootstrap --variant=minbase --include=ca-certificates,git,make,sudo "$suite" "$base" ${MIRROR:+"$MIRROR"} \
      >"$store/$suite-debootstrap.log" 2>&1 || { tail -n 5 "$store/$suite-debootstrap.log" >&2; exit 3; }
    touch "$base/.complete"
  fi
  top=$(mktemp -d "$store/$suite-XXXXXX")
  trap 'rm -rf --one-file-system "$top"' EXIT
  FC_CHROOT_INSIDE=yes FC_CHROOT_TOP=$top unshare --mount --pid --fork --kill-child \
    bash "$0" "$suite" "$what" "$who" </dev/null &
  inner=$!
  # Everything inside dies with the first process of its PID namespace.
  trap 'kill -KILL $inner 2>/dev/null; exit 130' INT TERM
  wait $inner
  exit
fi

top=$FC_CHROOT_TOP
cp -a "$base/." "$top/"
mount --make-rprivate /
mount -t proc proc "$top/proc"
mount --rbind /dev "$top/dev"
mount --bind "$packages" "$top/var/cache/apt/archives"
cp /etc/resolv.conf "$top/etc/resolv.conf"
[ -e "$top/etc/hosts" ] || echo '127.0.0.1 localhost' >"$top/etc/hosts" # as every installed Debian has
# Behind a proxy with a certificate of its own npm has to know it.
certificates=
if [ -n "${NODE_EXTRA_CA_CERTS:-}" ]; then
  certificates=/etc/ssl/extra-certificates.pem
  cp "$NODE_EXTRA_CA_CERTS" "$top$certificates"
fi
echo 'APT::Keep-Downloaded-Packages "true";' >"$top/etc/apt/apt.conf.d/90keep"

inside() { # inside USER COMMAND: in the user's home, with nothing of this shell's environment
  local home=/home/$1
  [ "$1" = root ] && home=/root
  chroot --userspec="$1:$1" "$top" /usr/bin/env -i HOME="$home" USER="$1" LOGNAME="$1" CI=true LANG=C.UTF-8 TERM=dumb \
    NODE_EXTRA_CA_CERTS="$certificates" \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin bash -c "cd $home && $2"
}
clone_for() {
  local home=/home/$1
  [ "$1" = root ] && home=/root
  git clone -q --no-local "$root" "$top$home/faultcheck"
  chroot "$top" chown -R "$1:$1" "$home/faultcheck"
}

failures=0
step() { # step TEXT LIMIT_SECONDS USER COMMAND
  local before=$SECONDS status=0 took
  inside "$3" "$4" >"$top/step.log" 2>&1 || status=$?
  took=$((SECONDS - before))
  if [ $status -eq 0 ] && [ $took -le "$2" ]; then
    printf 'ok      %-52s %4d s\n' "$1" $took
  else
    failures=$((failures + 1))
    printf 'FAILED  %-52s %4d s (limit %d s, status %d)\n' "$1" $took "$2" $status
    tail -n 60 "$top/step.log" | sed 's/^/    /'
  fi
  cp "$top/step.log" "$store/$suite-${1//[^a-z]/_}.log"
}

for user in tester plain; do
  chroot "$top" useradd --create-home --shell /bin/bash "$user"
done
echo 'tester ALL=(ALL) NOPASSWD: ALL' >"$top/etc/sudoers.d/tester"

echo "== $suite: $(git -C "$root" log -1 --format='%h %s')"
clone_for plain
mv "$top/usr/bin/sudo" "$top/usr/bin/sudo.away"
step "user without sudo is told what to run" 10 plain \
  'cd faultcheck; out=$(make demo 2>&1); status=$?; echo "$out"; [ $status = 2 ] && grep -q "apt-get install" <<<"$out"'
mv "$top/usr/bin/sudo.away" "$top/usr/bin/sudo"

for user in tester root; do
  case "$who:$user" in user:root | root:tester) continue ;; esac
  clone_for "$user"
  if [ "$what" != test ]; then
    step "$user: make demo with set-up" 600 "$user" 'cd faultcheck && make demo'
    step "$user: make demo when built" 15 "$user" 'cd faultcheck && make demo'
  fi
  if [ "$what" != demo ]; then step "$user: make test" 1500 "$user" 'cd faultcheck && make test'; fi
  if [ "$what" = all ]; then
    step "$user: make coverage" 600 "$user" 'cd faultcheck && make coverage'
    step "$user: make bench" 600 "$user" 'cd faultcheck && make bench'
  fi
done
[ $failures -eq 0 ]
