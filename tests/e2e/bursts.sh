#!/usr/bin/env bash
# Clouds in bursts and in a row, in a network of their own: bursts.sh BIN_FOLDER E2E_TOOL [CLOUDS]
# CLOUDS, 400 by default, are sent in a row while memory and descriptors are watched.
set -euo pipefail
# shellcheck source=tests/shell/private_network.sh
source "$(dirname "${BASH_SOURCE[0]}")/../shell/private_network.sh"

begin_alone "$@"
carry_multicast

bin=$1
tool=$2
clouds=${3:-400}
slowed=false

start_detector() {
  "$bin/quadrille-detector" --lcm-url "$1" --stats-file "$work/detector.prom" "${@:2}" \
    2>"$work/stderr" &
  detector=$!
  started=("$detector")
}

stop_detector() {
  local status=0
  kill -INT "$detector"
  wait "$detector" || status=$?
  started=()
  [[ $status -eq 0 ]] || fail "the detector ended with $status: $(<"$work/stderr")"
}

# What the file of statistics says.
statistic() { awk -v name="quadrille_detector_$1{" 'index($1, name) == 1 {print $2}' "$work/detector.prom"; }

# Where the kernel grants no buffer that holds a burst, the network is slowed until it needs none.
slow_down_if_needed() {
  if grep -q "would lose clouds" "$work/stderr"; then
    tc qdisc add dev lo root tbf rate 400mbit burst 128k latency 4s || fail "no tc"
    slowed=true
  fi
}

check_bursts() {
  start_detector "$url"
  sleep 0.5
  slow_down_if_needed
  "$tool" load "$url" "$work/numbered.lcm" 5 60 2 >"$work/stdout" || fail "$(<"$work/stdout")"
  stop_detector
  if $slowed; then tc qdisc del dev lo root; fi
  [[ $(statistic clouds_received_total) -eq 300 ]] || fail "not 300 clouds: $(<"$work/stdout")"
  [[ $(statistic dropped_messages_total) -eq 0 ]] || fail "messages were driven out"
}

# A buffer of the stock size overflows: each lost cloud is counted, and the cure is printed.
check_losses() {
  start_detector "$url&recv_buf_size=212992"
  "$tool" load "$url" "$work/numbered.lcm" 3 60 2 lossy >"$work/stdout" || fail "$(<"$work/stdout")"
  [[ $(statistic clouds_missing_total) -gt 0 ]] || fail "nothing was lost: $(<"$work/stdout")"
  [[ $(statistic dropped_datagrams_total) -gt 0 ]] || fail "no dropped datagram is counted"
  [[ $(statistic warnings) -ge 1 ]] || fail "the status does not warn"
  stop_detector
  local said="were lost because the receive buffer of 212992 bytes was full"
  [[ $(grep -c "$said" "$work/stderr") -eq 2 ]] ||
    fail "losses are not told at once and at the end, or too often: $(<"$work/stderr")"
  grep "$said" "$work/stderr" | grep -q "mend it with: .*recv_buf_size=67108864 in the LCM address" ||
    fail "no cure for losses: $(<"$work/stderr")"
}

# Memory and descriptors after a quarter of the clouds and after all.
check_soak() {
  local before_kb before_files after_kb after_files
  start_detector "$url"
  sleep 0.5
  slow_down_if_needed
  "$tool" load "$url" "$work/numbered.lcm" $((clouds / 4)) 1 60 >"$work/stdout" ||
    fail "$(<"$work/stdout")"
  before_kb=$(awk '/VmRSS/ {print $2}' "/proc/$detector/status")
  before_files=$(find "/proc/$detector/fd" -mindepth 1 | wc -l)
  "$tool" load "$url" "$work/numbered.lcm" $((clouds * 3 / 4)) 1 60 >"$work/stdout" ||
    fail "$(<"$work/stdout")"
  after_kb=$(awk '/VmRSS/ {print $2}' "/proc/$detector/status")
  after_files=$(find "/proc/$detector/fd" -mindepth 1 | wc -l)
  stop_detector
  echo "soak: $clouds clouds; $before_kb, then $after_kb kB;" \
    "$before_files, then $after_files descriptors; $(tail -1 "$work/stdout")"
  ((after_kb < before_kb + 5120)) || fail "memory grew from $before_kb to $after_kb kB"
  ((after_files == before_files)) || fail "descriptors grew from $before_files to $after_files"
}

"$tool" make-logs "$work"
check_bursts
check_losses
check_soak
echo "bursts: all well"
