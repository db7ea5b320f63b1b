#!/usr/bin/env bash
# Detects and plans on many LCM logs, as jobs of GNU parallel on all cores of this machine.
#
# usage: parallel.sh FOLDER LOG…
#
# The results of NAME.lcm, with its clouds, are written to FOLDER/NAME.lcm. If the script was stopped,
# run it again: finished logs are skipped. PLANNER_OPTIONS holds options of the planner, such as
# "--gripper wsg50". For more machines, which must have the folders, add -S HOST1,HOST2 to parallel's
# options.
set -euo pipefail

folder=${1:?usage: parallel.sh FOLDER LOG…}
shift
for program in parallel quadrille-detector; do
  command -v "$program" >/dev/null || {
    echo "parallel.sh: no $program; install the package parallel, put the build's bin into PATH" >&2
    exit 1
  }
done
twice=$(for log in "$@"; do basename "$log"; done | sort | uniq -d)
if [[ -n $twice ]]; then
  echo "parallel.sh: several logs are called $twice, as their results would be; rename them" >&2
  exit 1
fi
mkdir -p "$folder"
printf '%s\n' "$@" | parallel --will-cite --halt soon,fail=1 --quote \
  "$(dirname "${BASH_SOURCE[0]}")/one_log.sh" "$folder" {}
