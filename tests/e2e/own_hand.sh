#!/usr/bin/env bash
# The robot's own hand in the pictures of a camera at its wrist: own_hand.sh BIN_FOLDER E2E_TOOL
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

begin_alone "$@"

bin=$1
tool=$2
"$bin/quadrille" scene "$work/path.lcm" --path 3 --rate 1 --family tabletop --seed 4 --hand franka >/dev/null

# run NAME [OPTION…]: what both processes make of the log.
run() {
  local name=$1
  shift
  "$bin/quadrille-detector" --pose-channel CAMERA_POSE "$@" --in-log "$work/path.lcm" \
    --out-log "$work/quadrics.lcm" --copy-input 2>"$work/detector.log"
  "$bin/quadrille-grasp-planner" --pose-channel CAMERA_POSE --no-occupancy "$@" \
    --in-log "$work/quadrics.lcm" --out-log "$work/$name.lcm" --copy-input 2>"$work/planner.log"
}

run told
run untold --robot-channel NOBODY
"$tool" check-own-hand "$work/told.lcm" "$work/untold.lcm"
echo "own_hand: all well"
