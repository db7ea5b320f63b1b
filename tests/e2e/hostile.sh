#!/usr/bin/env bash
# Hostile messages to both processes, in a network of their own: hostile.sh BIN_FOLDER E2E_TOOL [MESSAGES [SEED]]
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

begin_alone "$@"
carry_multicast

bin=$1
tool=$2
messages=${3:-10000}
seed=${4:-1}

# Samples of all messages that the processes take.
"$tool" make-logs "$work"
"$bin/quadrille-detector" --in-log "$work/clouds.lcm" --out-log "$work/quadrics.lcm" --copy-input 2>"$work/stderr" ||
  fail "$(<"$work/stderr")"

"$bin/quadrille-detector" --lcm-url "$url" --pose-channel POSE --stats-file "$work/detector.prom" 2>"$work/detector" &
detector=$!
"$bin/quadrille-grasp-planner" --lcm-url "$url" --stats-file "$work/planner.prom" 2>"$work/planner" &
planner=$!
started=("$detector" "$planner")
sleep 0.5

status=0
"$tool" hostile "$url" "$work/quadrics.lcm" "$messages" "$seed" >"$work/stdout" 2>&1 || status=$?
tail -1 "$work/stdout"
for process in detector planner; do
  kill -INT "${!process}" 2>/dev/null ||
    { grep -vE '\[warning\]|\[info\]' "$work/$process" | tail -30 >&2; fail "the $process has died"; }
  ended=0
  wait "${!process}" || ended=$?
  [[ $ended -eq 0 ]] || { tail -5 "$work/$process" >&2; fail "the $process ended with $ended"; }
done
started=()
[[ $status -eq 0 ]] || fail "a good cloud was not answered"

# statistic PROCESS NAME: the sum of a count over its labels.
statistic() { awk -v name="$2{" 'index($1, name) == 1 { sum += $2 } END { print sum + 0 }' "$work/$1.prom"; }
received=$(statistic detector quadrille_detector_clouds_received_total)
decoded=$(statistic detector quadrille_detector_clouds_decoded_total)
published=$(statistic detector quadrille_detector_quadrics_published_total)
superseded=$(statistic detector quadrille_detector_clouds_superseded_total)
failed=$(statistic detector quadrille_detector_clouds_failed_total)
echo "the detector: received $received, decoded $decoded, answered $published, superseded $superseded, failed $failed"
((decoded == published + superseded + failed)) || fail "clouds are neither answered nor counted"
((failed == 0)) || fail "$failed clouds failed: $(grep error "$work/detector" | head -3)"
echo "hostile: all well"
