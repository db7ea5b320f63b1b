# shellcheck shell=bash disable=SC2154,SC2034
# Sourced by run.sh: the processes on the bus, with lcm-logplayer and lcm-logger.

# run_live LOG RECORDED: plays the log to both processes.
run_live() {
  lcm-logger --lcm-url="$url" "$2" >"$work/logger.stdout" 2>"$work/logger.stderr" &
  local logger=$!
  "$detector" -v --lcm-url "$url" 2>"$work/detector.stderr" &
  local detector_process=$!
  "$planner" -v --occupancy-period 0 --deadline-ms 0 --lcm-url "$url" 2>"$work/planner.stderr" &
  local planner_process=$!
  started=("$logger" "$detector_process" "$planner_process")
  wait_until 20 has_listeners 3 || fail "no one listens: $(cat "$work"/*.stderr)"
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
  wait_until 20 has_listeners 3 || fail "no one listens: $(cat "$work"/*.stderr)"
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
  wait_until 20 has_listeners 3 || fail "no one listens: $(cat "$work"/*.stderr)"
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
