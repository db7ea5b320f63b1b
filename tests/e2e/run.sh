#!/usr/bin/env bash
# The real processes, played to by lcm-logplayer and recorded by lcm-logger, in a network of their
# own: run.sh BIN_FOLDER E2E_TOOL
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

begin_alone "$@"

bin=$1
tool=$2
detector=$bin/quadrille-detector
planner=$bin/quadrille-grasp-planner
# Whoever does not obey --lcm-url ends up where no one listens.
export LCM_DEFAULT_URL="udpm://239.255.76.68:7668?ttl=0"

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
  expect_exit 1 "ip route add 224.0.0.0/4 dev lo" "$detector" --lcm-url "$url"
  expect_exit 1 "ip route add 224.0.0.0/4 dev lo" "$planner" --lcm-url "$url"
  carry_multicast
}

# shellcheck source=tests/e2e/replays.sh
source "$(dirname "${BASH_SOURCE[0]}")/replays.sh"
# shellcheck source=tests/e2e/live.sh
source "$(dirname "${BASH_SOURCE[0]}")/live.sh"

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
