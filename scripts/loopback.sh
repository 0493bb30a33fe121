#!/usr/bin/env bash
# Runs a command where the only network interface is the loopback, so that nothing can leave the host:
#
#   scripts/loopback.sh COMMAND [ARGUMENT...]
#
# Multicast is routed to the loopback there, as the programs of LCM need it. Works as root, as a user who may make
# namespaces, and as one who may sudo without a password. Exit status: the command's; 3 when none of these is allowed.
set -euo pipefail
[ $# -gt 0 ] || { sed -n '4s/^# *//p' "$0" >&2; exit 2; }
command -v ip >/dev/null || { echo "loopback: ip is missing; run: scripts/setup.sh test" >&2; exit 2; }

network='ip link set lo up && ip route add 239.0.0.0/8 dev lo src 127.0.0.1 &&'
if [ "$(id -u)" = 0 ]; then
  exec unshare --net -- bash -c "$network exec \"\$@\"" loopback "$@"
elif unshare --user --map-root-user --net -- true 2>/dev/null; then
  exec unshare --user --map-root-user --net -- bash -c "$network exec \"\$@\"" loopback "$@"
elif sudo -n true 2>/dev/null; then
  # As root for the network only; the command runs as who called, with the same environment.
  exec sudo -n --preserve-env unshare --net -- bash -c "$network exec setpriv --reuid=$(id -u) --regid=$(id -g) \
    --init-groups env HOME=$(printf %q "$HOME") PATH=$(printf %q "$PATH") \"\$@\"" loopback "$@"
fi
echo "loopback: needs root, user namespaces or sudo without a password" >&2
exit 3
