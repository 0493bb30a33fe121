#!/usr/bin/env bash
# Writes test/data/viz_*: messages, a log and packets made by liblcm and the code of lcm-gen, for the tests of codecs in
# other languages. Needs lcm_peer (scripts/build_native.sh release), python3, and what scripts/loopback.sh needs.
set -euo pipefail
cd "$(dirname "$0")/../../../.."
peer=_build/native/bin/lcm_peer
data=test/data
seed=20210 count=12 objects=1000
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$peer" fingerprints >"$work/types.json"
"$peer" messages $seed $count >"$work/messages"
"$peer" log "$work/viz_messages.lcm" $seed $count

# What liblcm sends, packet by packet, in a namespace that has a loopback interface only.
cat >"$work/record.py" <<'PYTHON'
import json, socket, struct, subprocess, sys
group, port = '239.255.76.67', 7667
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
s.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
s.bind((group, port))
s.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP,
             struct.pack('4s4s', socket.inet_aton(group), socket.inet_aton('127.0.0.1')))
subprocess.run(sys.argv[1:], check=True)
s.settimeout(1)
packets = []
try:
    while True:
        packets.append(s.recv(65536).hex())
except TimeoutError:
    pass
print(json.dumps(packets, indent=0))
PYTHON
scripts/loopback.sh \
  python3 "$work/record.py" "$peer" publish 'udpm://239.255.76.67:7667?ttl=0' $seed 1 $objects >"$work/packets.json"

python3 - "$work" <<'PYTHON' >"$work/viz_messages.json"
import json, sys
work = sys.argv[1]
lines = [line.rstrip('\n') for line in open(work + '/messages', encoding='utf-8')]
types = json.load(open(work + '/types.json'))['types']
packets = json.load(open(work + '/packets.json'))
print('{"types": ' + json.dumps(types) + ',')
print('"messages": [\n' + ',\n'.join(lines) + '],')
print('"packets": [\n' + ',\n'.join(json.dumps(p) for p in packets) + ']}')
PYTHON
gzip -9nc "$work/viz_messages.json" >"$data/viz_messages.json.gz"
gzip -9nc "$work/viz_messages.lcm" >"$data/viz_messages.lcm.gz"
ls -l "$data"/viz_*
