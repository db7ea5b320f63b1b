#!/usr/bin/env bash
# Two detectors share a stream, live, in a private network: shards.sh BIN_FOLDER E2E_TOOL
set -euo pipefail

fail() {
  echo "shards: $*: $(tail -qn 3 "${work:-/nonexistent}"/*.log 2>/dev/null)" >&2
  exit 1
}

if [[ -z ${QUADRILLE_SHARDS_PRIVATE:-} ]]; then
  QUADRILLE_SHARDS_PRIVATE=yes exec "$(dirname "$0")/../../tools/private_network" "$0" "$@"
fi

bin=$1 tool=$2
url="udpm://239.255.76.67:7667?ttl=0"
work=$(mktemp -d)
started=()
clean_up() {
  # One that has ended by itself cannot be ended again.
  for process in "${started[@]}"; do kill -KILL "$process" 2>/dev/null || true; done
  rm -rf "$work"
}
trap clean_up EXIT

# start NAME COMMAND…: its records go to NAME.log. Waits until it listens, 20 s at most.
start() {
  local name=$1 tries=400
  shift
  "$@" --lcm-url "$url" 2>"$work/$name.log" &
  started+=("$!")
  until grep -qs "listening to" "$work/$name.log"; do
    ((tries-- > 0)) || fail "$name does not listen"
    sleep 0.05
  done
}
start_shard() { start "$1" "$bin/quadrille-detector" --threads 1 --shard "$2"; }
# stop PROCESS SIGNAL
stop() {
  kill "-$2" "$1"
  wait "$1" 2>/dev/null || true
}
says() { grep -q "$1" "$work/$2.log" || fail "$2 does not say: $1"; }
says_not() { ! grep -q "$1" "$work/$2.log" || fail "$2 says: $1"; }

# A result that waited for the patience would not be here in time.
start patient "$bin/quadrille" merge --shards 2 --patience 60000
merge=${started[-1]}
start_shard one 1/2
start_shard two 2/2
two=${started[-1]}
"$tool" stream "$url" 60 10 timed 60
"$tool" stream "$url" 60 10 timeless 60
stop "$merge" TERM
says "stopped: 120 results merged, 0 late" patient
says_not "shard " patient

# One shard is lost and comes back, and one is of another number.
start merge "$bin/quadrille" merge --shards 2 --patience 300 --stats-file "$work/merge.prom"
merge=${started[-1]}
"$tool" stream "$url" 10 10 timeless 5
stop "$two" KILL
"$tool" stream "$url" 30 10 timeless 5
says "shard 2/2 is silent on QUADRICS_2" merge
[[ $(grep -c "shard 2/2 is silent" "$work/merge.log") -eq 1 ]] || fail "silence is told again and again"
grep -q '^quadrille_merger_shard_works{.*,shard="2"} 0' "$work/merge.prom" || fail "shard 2 works"
start_shard again 2/2
again=${started[-1]}
"$tool" stream "$url" 30 10 timeless 25
says "shard 2/2 is back" merge
grep -q '^quadrille_merger_shard_works{.*,shard="2"} 1' "$work/merge.prom" || fail "shard 2 does not work"
says_not "has --shard" merge
stop "$again" TERM
start_shard wrong 2/3
# In which order its results come is nobody's promise.
"$tool" stream "$url" 10 10 timed 0 || true
says "the detector on QUADRICS_2 has --shard 2/3, where --shards 2 expects 2/2" merge
echo "shards: all well"
