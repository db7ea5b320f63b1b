#!/usr/bin/env bash
# Detects and plans on one LCM log: one_log.sh FOLDER LOG. A result appears once it is complete.
set -euo pipefail

folder=$1 log=$2
result=$folder/$(basename "$log")
[[ ! -e $result ]] || exit 0
work=$(mktemp -d "$folder/.work.XXXXXX")
trap 'rm -rf "$work"' EXIT
read -r -a options <<<"${PLANNER_OPTIONS:-}"
quadrille-detector --threads 1 --in-log "$log" --out-log "$work/quadrics.lcm" --copy-input
quadrille-grasp-planner "${options[@]}" --in-log "$work/quadrics.lcm" --out-log "$work/grasps.lcm" \
  --copy-input
mv "$work/grasps.lcm" "$result"
