# shellcheck shell=bash disable=SC2154,SC2034
# Sourced by run.sh: command lines, and what the processes make of logs.

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
    expect_exit 1 "/none/s.prom: cannot be" "$program" --lcm-url "$url" --stats-file /none/s.prom
    if grep -q "listening" "$work/stderr"; then fail "$program listens before it looks at its files"; fi
    expect_exit 2 "memq reaches no other process" "$program" --lcm-url memq://
    for ttl in 300 -1; do
      expect_exit 2 "ttl = '$ttl' must be" "$program" --lcm-url "${url%0}$ttl"
    done
  done
  expect_exit 2 "the types are" "$detector" --only torus
  expect_exit 2 "--unknown: 'x' is none of: weighed, obstacle, target-shadow, free; see" \
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
  local held="on QUADRICS (6; --out-channel), BOXES (6; --boxes-channel), BODIES (6; --bodies-channel), BODY_TRACKS (6; --body-tracks-channel), QUADRILLE_DETECTOR_STATUS"
  cp "$work/grasps.lcm" "$work/kept.lcm"
  expect_exit 1 "$held" "$detector" --in-log "$work/quadrics.lcm" --out-log "$work/kept.lcm" --copy-input
  cmp "$work/grasps.lcm" "$work/kept.lcm" || fail "a refused replay has touched its output"
  expect_exit 0 "clouds in: 6" \
    "$detector" --in-log "$work/quadrics.lcm" --out-log "$work/o.lcm"
  expect_exit 0 "clouds in: 6" \
    "$detector" --in-log "$work/quadrics.lcm" --out-log "$work/o.lcm" --copy-input \
    --out-channel Q2 --boxes-channel B2 --bodies-channel N2 --body-tracks-channel T2 \
    --status-channel S2
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
