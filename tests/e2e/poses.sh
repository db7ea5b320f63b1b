#!/usr/bin/env bash
# Poses that come late or out of order, from a log and on the bus, in a network of their own:
# poses.sh BIN_FOLDER E2E_TOOL
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

begin_alone "$@"
carry_multicast

bin=$1
tool=$2
frames=(--pose-channel POSE --result-frame world)

# replay LOG PLACED REFUSED: what both processes make of a log, twice with the same bytes.
replay() {
  local process
  local pass
  for pass in 1 2; do
    "$bin/quadrille-detector" "${frames[@]}" --config "$work/c.toml" --in-log "$1" \
      --out-log "$work/quadrics.lcm" --copy-input 2>"$work/detector.stderr"
    "$bin/quadrille-grasp-planner" "${frames[@]}" --config "$work/c.toml" --no-occupancy \
      --in-log "$work/quadrics.lcm" --out-log "$work/out$pass.lcm" --copy-input 2>"$work/planner.stderr"
    "$tool" check-poses "$work/out$pass.lcm" "$2" "$3"
  done
  "$tool" check-equal "$work/out1.lcm" "$work/out2.lcm"
}

# play LOG PLACED REFUSED: what both processes make of it on the bus.
play() {
  local process
  rm -f "$work/live.lcm"
  lcm-logger --lcm-url="$url" "$work/live.lcm" >/dev/null 2>"$work/logger.stderr" &
  local logger=$!
  "$bin/quadrille-detector" "${frames[@]}" --config "$work/c.toml" --lcm-url "$url" \
    --stats-file "$work/detector.prom" 2>"$work/detector.stderr" &
  local detector=$!
  "$bin/quadrille-grasp-planner" "${frames[@]}" --config "$work/c.toml" --no-occupancy --deadline-ms 0 \
    --lcm-url "$url" --stats-file "$work/planner.prom" 2>"$work/planner.stderr" &
  local planner=$!
  started=("$logger" "$detector" "$planner")
  wait_until 20 has_listeners 3 || fail "no one listens: $(cat "$work"/*.stderr)"
  lcm-logplayer --lcm-url="$url" "$1" >/dev/null
  sleep 1
  kill -INT "$detector" "$planner"
  for process in "$detector" "$planner"; do
    wait "$process" || fail "a process failed: $(cat "$work"/*.stderr)"
  done
  sleep 0.3
  kill -INT "$logger"
  wait "$logger" || fail "lcm-logger failed: $(<"$work/logger.stderr")"
  started=()
  "$tool" check-poses "$work/live.lcm" "$2" "$3"
}

# expect_said TEXT: both processes have logged it.
expect_said() {
  for name in detector planner; do
    grep -qF -- "$1" "$work/$name.stderr" ||
      fail "the $name does not say '$1': $(<"$work/$name.stderr")"
  done
}

# expect_counted PROCESS COUNTER: its statistics count 20 clouds whose poses were late, and tell that
# the newest pose was between 0.1 and 0.2 s from the last cloud.
expect_counted() {
  grep -q "^quadrille_$1_$2_total{.*reason=\"late_pose\"} 20$" "$work/$1.prom" ||
    fail "the $1 does not count 20 late poses: $(grep "$2" "$work/$1.prom")"
  grep -q "^quadrille_$1_pose_age_seconds{.*} 0\.1" "$work/$1.prom" ||
    fail "the $1 does not tell the age of the poses: $(grep pose_age "$work/$1.prom")"
}

: >"$work/c.toml"
echo "poses out of order, clouds 100 ms late"
"$tool" make-poses "$work/disordered.lcm" 40 5 0 100
replay "$work/disordered.lcm" 40 0
play "$work/disordered.lcm" 40 0
"$tool" check-equal "$work/live.lcm" "$work/out1.lcm"

echo "poses 200 ms late"
"$tool" make-poses "$work/late.lcm" 20 0 200 0
replay "$work/late.lcm" 0 20
expect_said "the newest pose is 154 ms older; at 0.50 m/s that is up to 77 mm, and none after"
expect_said "the cloud came within track.pose_wait = 0.05 s; raise that, or publish poses faster"
play "$work/late.lcm" 0 20
expect_said "track.pose_wait"
expect_counted detector clouds_untracked
expect_counted planner clouds_unplaced

echo "poses 200 ms late, for which clouds wait"
printf '[track]\npose_wait = 0.3\n' >"$work/c.toml"
replay "$work/late.lcm" 20 0
play "$work/late.lcm" 20 0
"$tool" check-equal "$work/live.lcm" "$work/out1.lcm"
echo "poses: all well"
