#!/usr/bin/env bash
# Two cameras on hosts of their own, and both processes on a third, on one network of namespaces:
# cameras.sh BIN_FOLDER E2E_TOOL
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

begin_alone "$@"

bin=$1
tool=$2
url="udpm://239.255.76.67:7667?ttl=1"

# The network: the host of the processes is a switch too.
ip link set lo up
ip link add switch type bridge mcast_snooping 0
ip address add 10.9.0.1/24 dev switch
ip link set switch up
ip route add 224.0.0.0/4 dev switch
hosts=()
for i in 1 2; do
  unshare --net sleep 600 &
  hosts+=("$!")
  started+=("$!")
  ip link add "wire$i" type veth peer name "camera$i"
  wait_until 20 has_own_network "${hosts[i - 1]}" || fail "no network for camera $i"
  ip link set "camera$i" netns "${hosts[i - 1]}"
  ip link set "wire$i" master switch up
  nsenter -t "${hosts[i - 1]}" -n bash -c "ip address add 10.9.0.1$i/24 dev camera$i &&
    ip link set camera$i up && ip route add 224.0.0.0/4 dev camera$i"
done
on_host() { nsenter -t "${hosts[$1 - 1]}" -n "${@:2}"; }

# Tracks are those of the first camera, so they would differ.
printf '[track]\nenabled = false\n' >"$work/c.toml"
options=(--pose-channel POSE --config "$work/c.toml")
"$tool" make-cameras "$work"

echo "one camera that was at both places"
"$bin/quadrille-detector" "${options[@]}" --in-log "$work/one.lcm" --out-log "$work/quadrics.lcm" \
  --copy-input 2>"$work/detector.log"
"$bin/quadrille-grasp-planner" "${options[@]}" --no-occupancy --in-log "$work/quadrics.lcm" \
  --out-log "$work/grasps.lcm" --copy-input 2>"$work/planner.log"

echo "two cameras"
options+=(--view-camera SIDE=SIDE_POSE --lcm-url "$url" -v)
lcm-logger --lcm-url="$url" "$work/live.lcm" >/dev/null 2>"$work/logger.log" &
logger=$!
"$bin/quadrille-detector" "${options[@]}" --stats-file "$work/detector.prom" 2>"$work/detector.log" &
detector=$!
"$bin/quadrille-grasp-planner" "${options[@]}" --no-occupancy --deadline-ms 0 \
  --stats-file "$work/planner.prom" 2>"$work/planner.log" &
planner=$!
started+=("$logger" "$detector" "$planner")
wait_until 20 has_listeners 3 || fail "no one listens"

# remembers PROCESS: the process has told that it remembers a view.
remembers() { grep -q "^quadrille_$1_views_remembered{.*} 1$" "$work/$1.prom"; }
on_host 1 lcm-logplayer --lcm-url="$url" "$work/side.lcm" >/dev/null
for name in detector planner; do
  wait_until 20 remembers "$name" || fail "the $name has not seen the view of the second camera"
done
on_host 2 lcm-logplayer --lcm-url="$url" "$work/front.lcm" >/dev/null
wait_until 20 grep -q "cloud 2000000: " "$work/planner.log" || fail "no grasps"
kill -INT "$detector" "$planner"
for process in "$detector" "$planner"; do wait "$process" || fail "a process failed"; done
sleep 0.3
kill -INT "$logger"
wait "$logger" || fail "lcm-logger failed"
"$tool" check-cameras "$work/live.lcm" "$work/grasps.lcm"
echo "cameras: all well"
