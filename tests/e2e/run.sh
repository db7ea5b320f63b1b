#!/usr/bin/env bash
# The real processes, played to by lcm-logplayer and recorded by lcm-logger, in a network of their
# own: run.sh BIN_FOLDER E2E_TOOL
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

fail() {
  echo "e2e: $*" >&2
  exit 1
}

enter_private_network "$@" || ip route get 239.255.76.67 >/dev/null 2>&1 || fail "no multicast" \
  "route and no right to make a network namespace; mend it with: sudo ip route add 224.0.0.0/4 dev lo"

bin=$1
tool=$2
detector=$bin/quadrille-detector
planner=$bin/quadrille-grasp-planner
url="udpm://239.255.76.67:7667?ttl=0"
# Whoever does not obey --lcm-url ends up where no one listens.
export LCM_DEFAULT_URL="udpm://239.255.76.68:7668?ttl=0"
make_work_folder

# wait_until SECONDS COMMAND…: until the command succeeds.
wait_until() {
  local tries=$(($1 * 20))
  shift
  until "$@"; do
    ((tries-- > 0)) || return 1
    sleep 0.05
  done
}

# Sockets bound to the port 7667.
enough_listeners() { [[ $(grep -c ':1DF3 ' /proc/net/udp) -ge $1 ]]; }

# expect_exit STATUS TEXT COMMAND…: the command ends with that status and says the text on stderr.
expect_exit() {
  local wanted=$1 text=$2 status=0
  shift 2
  "$@" 2>"$work/stderr" >/dev/null || status=$?
  [[ $status -eq $wanted ]] || fail "exit $status instead of $wanted: $* ($(<"$work/stderr"))"
  [[ -z $text ]] || grep -qF -- "$text" "$work/stderr" || fail "no '$text' from: $* ($(<"$work/stderr"))"
}

# expect_end PROCESS NAME: it ends with status 0.
expect_end() {
  local status=0
  wait "$1" || status=$?
  [[ $status -eq 0 ]] || fail "$2 ended with $status: $(<"$work/$2.stderr")"
}

check_without_route() {
  if [[ ${QUADRILLE_PRIVATE_NETWORK:-} != yes ]]; then
    echo "e2e: skipped: a missing multicast route, which needs the right to make a network" \
      "namespace (root, or unprivileged user namespaces)"
    return 0
  fi
  expect_exit 1 "ip route add 224.0.0.0/4 dev lo" "$detector" --lcm-url "$url"
  expect_exit 1 "ip route add 224.0.0.0/4 dev lo" "$planner" --lcm-url "$url"
  ip link set lo up
  ip route add 224.0.0.0/4 dev lo
}

check_command_lines() {
  for program in "$detector" "$planner"; do
    expect_exit 0 "" "$program" --help
    [[ $("$program" --version) =~ ^${program##*/}\ [0-9]+\.[0-9]+\.[0-9]+$ ]] || fail "no version"
    expect_exit 2 "" "$program" --no-such-option
    expect_exit 2 "--out-log" "$program" --in-log "$work/clouds.lcm"
    expect_exit 1 "no such file" "$program" --in-log "$work/none.lcm" --out-log "$work/o.lcm"
    expect_exit 1 "is not an LCM log" "$program" --in-log "$0" --out-log "$work/o.lcm"
    expect_exit 1 "name another one" "$program" --in-log "$work/clouds.lcm" \
      --out-log "$work/clouds.lcm"
    expect_exit 1 "lcm-tcpq-server" "$program" --lcm-url tcpq://127.0.0.1:9
    expect_exit 2 "LCM has no 'pigeon'" "$program" --lcm-url pigeon://
    expect_exit 2 "no multicast address" "$program" --lcm-url udpm://10.0.0.1:7667
    # What no restart mends is not tried again.
    expect_exit 1 "/none/s.prom: cannot be" "$program" --lcm-url "$url" --respawn --stats-file /none/s.prom
    expect_exit 1 "/none/s.prom: cannot be" "$program" --lcm-url "$url" --stats-file /none/s.prom
    if grep -q "listening" "$work/stderr"; then fail "$program listens before it looks at its files"; fi
    expect_exit 2 "memq reaches no other process" "$program" --lcm-url memq://
    for ttl in 300 -1; do
      expect_exit 2 "ttl = '$ttl' must be" "$program" --lcm-url "${url%0}$ttl"
    done
  done
  expect_exit 2 "no multicast address" \
    "$bin/quadrille" merge --shards 2 --lcm-url udpm://10.0.0.1:7667
  expect_exit 2 "the types are" "$detector" --only torus
  expect_exit 2 "--unknown: 'x' is none of: obstacle, target-shadow, free; see" \
    "$planner" --unknown x
  expect_exit 2 "'0' is none of" "$planner" --unknown 0
  expect_exit 2 "'A' is the channel of --in-channel too" \
    "$detector" --in-channel A --out-channel A
  expect_exit 2 "'QUADRICS' is the channel of --out-channel too" \
    "$detector" --status-channel QUADRICS
  expect_exit 2 "channel 'A B'" "$detector" --in-channel "A B"
}

run_offline() {
  "$detector" --in-log "$work/clouds.lcm" --out-log "$work/quadrics.lcm" --copy-input
  "$planner" --in-log "$work/quadrics.lcm" --out-log "$work/grasps.lcm"
  "$tool" check-quadrics "$work/quadrics.lcm"
}

# What the processes make of a scene is what the command makes of its file.
check_plan() {
  for seed in 1 2 3; do
    "$bin/quadrille" scene "$work/scene.ply" --family tabletop --seed "$seed" >/dev/null
    "$bin/quadrille" plan "$work/scene.ply" --gripper franka --unknown free \
      --json "$work/plan.json" >/dev/null 2>&1
    "$bin/quadrille" log "$work/scene.lcm" "$work/scene.ply" >/dev/null
    "$detector" --in-log "$work/scene.lcm" --out-log "$work/found.lcm" --copy-input 2>/dev/null
    "$planner" --unknown free --in-log "$work/found.lcm" --out-log "$work/planned.lcm" \
      --copy-input 2>/dev/null
    "$tool" check-plan "$work/planned.lcm" "$work/plan.json"
  done
}

# Results that a log holds already are not mixed with new ones.
check_mixed_results() {
  local held="on QUADRICS (6; --out-channel), BOXES (6; --boxes-channel), QUADRILLE_DETECTOR_STATUS"
  cp "$work/grasps.lcm" "$work/kept.lcm"
  expect_exit 1 "$held" "$detector" --in-log "$work/quadrics.lcm" --out-log "$work/kept.lcm" --copy-input
  cmp "$work/grasps.lcm" "$work/kept.lcm" || fail "a refused replay has touched its output"
  expect_exit 0 "clouds in: 6" \
    "$detector" --in-log "$work/quadrics.lcm" --out-log "$work/o.lcm"
  expect_exit 0 "clouds in: 6" \
    "$detector" --in-log "$work/quadrics.lcm" --out-log "$work/o.lcm" --copy-input \
    --out-channel Q2 --boxes-channel B2 --status-channel S2
  "$planner" --in-log "$work/quadrics.lcm" --out-log "$work/planned.lcm" --copy-input 2>/dev/null
  expect_exit 1 "on GRASPS (6; --grasps-channel), COLLISION_SHAPES (6; --shapes-channel)" \
    "$planner" --in-log "$work/planned.lcm" --out-log "$work/o.lcm" --copy-input
}

# A channel that is named wrong is told from one on which nothing can be found.
check_channels() {
  expect_exit 0 "no event on CAMERA; the log holds POINT_CLOUD (6); name the channel with --in-" \
    "$detector" --in-channel CAMERA --in-log "$work/clouds.lcm" --out-log "$work/o.lcm"
  expect_exit 0 "clouds in: 0, none refused; quadrics out: 0" \
    "$detector" --in-channel CAMERA --in-log "$work/clouds.lcm" --out-log "$work/o.lcm"
  expect_exit 0 "CAMREA: cloud 500000 is not tracked: no pose has come; is --pose-channel right" \
    "$detector" --pose-channel CAMREA --in-log "$work/clouds.lcm" --out-log "$work/o.lcm"
  expect_exit 0 "no event on QUADRICS; the log holds POINT_CLOUD (6)" \
    "$planner" --in-log "$work/clouds.lcm" --out-log "$work/o.lcm"
  expect_exit 0 "clouds in: 6, none refused; messages of quadrics in: 6, none refused; pairs: 6;" \
    "$planner" --in-log "$work/quadrics.lcm" --out-log "$work/o.lcm"
  expect_exit 0 "clouds in: 15, 9 refused (unknown_type 2, cut_short 1, " \
    "$detector" --in-log "$work/hostile.lcm" --out-log "$work/o.lcm"
}

# A log that was cut short gives its whole clouds, and says so.
check_cut_log() {
  head -c 200000 "$work/clouds.lcm" >"$work/cut.lcm"
  expect_exit 0 "cut short at byte" "$detector" --in-log "$work/cut.lcm" --out-log "$work/o.lcm"
  [[ $(grep -c QUADRICS "$work/o.lcm" -a) -ge 1 ]] || fail "nothing from a log cut short"
}

# A replay that is interrupted is no success.
check_interrupted_replay() {
  local status=0 process
  for _ in {1..100}; do cat "$work/clouds.lcm"; done >"$work/long.lcm"
  "$detector" -v --in-log "$work/long.lcm" --out-log "$work/o.lcm" 2>"$work/stderr" &
  process=$!
  started=("$process")
  wait_until 20 grep -q "cloud " "$work/stderr" || fail "no cloud of the long log"
  kill -INT "$process"
  wait "$process" || status=$?
  started=()
  [[ $status -eq 1 ]] || fail "an interrupted replay ended with $status"
  grep -qE "stopped before the end of the log, after [0-9]+ of 600 events" "$work/stderr" ||
    fail "an interrupted replay does not say so: $(<"$work/stderr")"
}

# What `quadrille log` writes, as each message type, is what the detector replays.
check_log_command() {
  printf '%s\n' ply "format ascii 1.0" "element vertex 3" "property float x" "property float y" \
    "property float z" end_header "0 0 1" "0.1 0 1" "0 0.1 1" >"$work/three.ply"
  for type in drake pointcloud2 pointcloud; do
    "$bin/quadrille" log "$work/three.lcm" "$work/three.ply" "$work/three.ply" --rate 20 \
      --channel THREE --as "$type" >/dev/null
    "$detector" -v --in-channel THREE --in-log "$work/three.lcm" --out-log "$work/o.lcm" \
      2>"$work/stderr"
    [[ $(grep -c " of 3 points" "$work/stderr") -eq 2 ]] || fail "not 2 clouds as $type"
  done
  expect_exit 2 "" "$bin/quadrille" log "$work/three.lcm" "$work/three.ply" --as png
  expect_exit 1 "none.ply" "$bin/quadrille" log "$work/none.lcm" "$work/none.ply"
  [[ ! -e $work/none.lcm ]] || fail "a log without clouds was left behind"
}

# run_live LOG RECORDED: plays the log to both processes.
run_live() {
  lcm-logger --lcm-url="$url" "$2" >"$work/logger.stdout" 2>"$work/logger.stderr" &
  local logger=$!
  "$detector" -v --lcm-url "$url" 2>"$work/detector.stderr" &
  local detector_process=$!
  "$planner" -v --occupancy-period 0 --lcm-url "$url" 2>"$work/planner.stderr" &
  local planner_process=$!
  started=("$logger" "$detector_process" "$planner_process")
  wait_until 20 enough_listeners 3 || fail "no one listens: $(cat "$work"/*.stderr)"
  lcm-logplayer --lcm-url="$url" "$1" >/dev/null
  # The last cloud has to pass through both; then each tells its last status.
  wait_until 20 grep -q "cloud 3000000: " "$work/planner.stderr" ||
    fail "no grasps for the last cloud: $(cat "$work"/*.stderr)"
  peak=$(awk '/VmHWM/ {print $2}' "/proc/$detector_process/status")
  kill -TERM "$detector_process"
  expect_end "$detector_process" detector
  kill -INT "$planner_process"
  expect_end "$planner_process" planner
  sleep 0.3
  kill -INT "$logger"
  wait "$logger" || fail "lcm-logger failed: $(<"$work/logger.stderr")"
  started=()
}

compare_with_offline() {
  "$tool" check-same "$1" "$work/quadrics.lcm" QUADRICS
  for channel in GRASPS COLLISION_SHAPES OCCUPANCY; do
    "$tool" check-same "$1" "$work/grasps.lcm" "$channel"
  done
}

# Two who ask at once, many times in a row, get each answer; nothing else is planned.
check_requests() {
  local ask=$bin/examples/06_ask_for_grasps askers=()
  lcm-logger --lcm-url="$url" "$work/asked.lcm" >/dev/null 2>"$work/logger.stderr" &
  local logger=$!
  "$detector" --lcm-url "$url" 2>"$work/detector.stderr" &
  local detector_process=$!
  "$planner" -v --on-request --unknown free --lcm-url "$url" 2>"$work/planner.stderr" &
  local planner_process=$!
  started=("$logger" "$detector_process" "$planner_process")
  wait_until 20 enough_listeners 3 || fail "no one listens: $(cat "$work"/*.stderr)"
  "$ask" 0 0 0.8 1 "$url" | grep -q "no cloud has come" || fail "an answer before any cloud"
  lcm-logplayer --lcm-url="$url" "$work/scene.lcm" >/dev/null
  wait_until 20 grep -qa QUADRICS "$work/asked.lcm" || fail "no quadrics of the scene"
  for x in -0.1 0.1; do
    "$ask" "$x" 0 0.8 20 "$url" >"$work/asked$x.txt" &
    askers+=("$!")
  done
  for asker in "${askers[@]}"; do wait "$asker" || fail "a request was not answered"; done
  for x in -0.1 0.1; do
    [[ $(grep -c "grasps:  on " "$work/asked$x.txt") -eq 20 ]] ||
      fail "not 20 answers with grasps: $(<"$work/asked$x.txt")"
  done
  kill -INT "$planner_process" "$detector_process" "$logger"
  expect_end "$planner_process" planner
  grep -q "requests: 41, none refused, unmet: 1" "$work/planner.stderr" ||
    fail "requests are not counted: $(tail -2 "$work/planner.stderr")"
  wait "$detector_process" "$logger" || fail "the detector or lcm-logger failed"
  started=()
}

# A detector that a pattern gives its cameras, and one more on the same channel of status.
check_cameras() {
  "$tool" rename-channel "$work/clouds.lcm" "$work/camera.lcm" POINT_CLOUD CAM_A
  lcm-logger --lcm-url="$url" "$work/seen.lcm" >/dev/null 2>"$work/logger.stderr" &
  local logger=$!
  "$detector" -v --in-channel "CAM_(A|B)" --lcm-url "$url" 2>"$work/detector.stderr" &
  local detector_process=$!
  "$detector" --in-channel OTHER --out-channel O --boxes-channel B --lcm-url "$url" \
    2>"$work/other.stderr" &
  local other=$!
  started=("$logger" "$detector_process" "$other")
  wait_until 20 enough_listeners 3 || fail "no one listens: $(cat "$work"/*.stderr)"
  lcm-logplayer --lcm-url="$url" "$work/camera.lcm" >/dev/null
  wait_until 20 grep -q "cloud 3000000: " "$work/detector.stderr" || fail "no last cloud"
  for name in detector other; do
    wait_until 20 grep -q " publishes on QUADRILLE_DETECTOR_STATUS too" "$work/$name.stderr" ||
      fail "$name does not tell of the other detector"
  done
  kill -INT "$detector_process" "$other"
  expect_end "$detector_process" detector
  expect_end "$other" other
  sleep 0.3
  kill -INT "$logger"
  wait "$logger" || fail "lcm-logger failed: $(<"$work/logger.stderr")"
  started=()
  "$detector" --in-log "$work/camera.lcm" --in-channel "CAM_(A|B)" --out-log "$work/o.lcm" 2>/dev/null
  for log in seen o; do
    "$bin/quadrille" show "$work/$log.lcm" --channel QUADRICS_CAM_A >"$work/$log.txt"
  done
  [[ -s $work/o.txt ]] || fail "no quadrics of a camera of a pattern"
  cmp "$work/seen.txt" "$work/o.txt" || fail "a camera of a pattern gets other quadrics live"
}

"$tool" make-logs "$work"
check_without_route
check_command_lines
run_offline
check_plan
check_mixed_results
check_channels
check_cut_log
check_interrupted_replay
check_log_command
check_requests
check_cameras

run_live "$work/clouds.lcm" "$work/live.lcm"
"$tool" check-status "$work/live.lcm"
compare_with_offline "$work/live.lcm"

# The hostile log carries the clouds as another type, with a seq of their own.
# Its garbage on QUADRICS counts as results; live the detector's would come among it too.
expect_exit 1 "mixed with new results on QUADRICS (" \
  "$detector" --in-log "$work/hostile.lcm" --out-log "$work/o.lcm" --copy-input
"$detector" --in-log "$work/hostile.lcm" --out-log "$work/found.lcm" --copy-input \
  --out-channel FOUND 2>/dev/null
"$tool" rename-channel "$work/found.lcm" "$work/quadrics.lcm" FOUND QUADRICS
"$planner" --in-log "$work/quadrics.lcm" --out-log "$work/grasps.lcm" --copy-input 2>/dev/null
"$tool" check-copy "$work/hostile.lcm" "$work/quadrics.lcm"
"$tool" check-copy "$work/quadrics.lcm" "$work/grasps.lcm"
run_live "$work/hostile.lcm" "$work/live_hostile.lcm"
"$tool" check-hostile-status "$work/live_hostile.lcm"
compare_with_offline "$work/live_hostile.lcm"
grep -q "refused a message" "$work/detector.stderr" || fail "garbage is not logged"
((peak < 400000)) || fail "the detector took $peak kB on small messages"
echo "e2e: all well"
