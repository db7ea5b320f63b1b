#!/usr/bin/env bash
# What the processes remember of the clouds of a moving camera: remembers.sh BIN_FOLDER E2E_TOOL
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

begin_alone "$@"

bin=$1
tool=$2
"$bin/quadrille" scene "$work/path.lcm" --path 30 --family tabletop >/dev/null
printf '[views]\nremember = 0.0\n' >"$work/forgetful.toml"
: >"$work/remembering.toml"

# detect NAME: what the detector finds in the log with NAME.toml.
detect() {
  "$bin/quadrille-detector" --pose-channel CAMERA_POSE --config "$work/$1.toml" \
    --in-log "$work/path.lcm" --out-log "$work/quadrics.lcm" --copy-input 2>"$work/detector.stderr"
}

# plan NAME PASS: what the planner makes of it with NAME.toml.
plan() {
  "$bin/quadrille-grasp-planner" --pose-channel CAMERA_POSE --unknown obstacle --no-occupancy \
    --config "$work/$1.toml" --in-log "$work/quadrics.lcm" --out-log "$work/$1$2.lcm" \
    --copy-input 2>"$work/planner.stderr"
}

detect remembering
plan remembering 1
plan remembering 2
detect forgetful
plan forgetful 1
"$tool" check-equal "$work/remembering1.lcm" "$work/remembering2.lcm"
# The command makes the same of the log's last cloud and those before it, in the fixed frame.
"$bin/quadrille" plan "$work/path.lcm#30" --scene --pose-channel CAMERA_POSE --gripper franka \
  --unknown obstacle --json "$work/plan.json" >/dev/null 2>&1
"$tool" check-plan-elsewhere "$work/remembering1.lcm" "$work/plan.json"
"$bin/quadrille" plan "$work/path.lcm#30" --pose-channel CAMERA_POSE --gripper franka \
  --unknown obstacle --json "$work/plan.json" >/dev/null 2>&1
"$tool" check-plan-elsewhere "$work/forgetful1.lcm" "$work/plan.json"
"$tool" check-remembered "$work/remembering1.lcm" "$work/forgetful1.lcm"
echo "remembers: all well"
