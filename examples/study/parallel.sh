#!/usr/bin/env bash
# A study on all cores of this machine, or of several, as jobs of GNU parallel.
#
# usage: parallel.sh [FOLDER [JOBS [OPTION…]]]
#
# Each job takes every JOBS-th scene. Run it again after a stop: what is finished is not done again.
# For more machines add -S HOST1,HOST2 to parallel's options, with the folder on all of them.
set -euo pipefail

folder=${1:-out/study}
jobs=${2:-$(nproc)}
options=("${@:3}")
((${#options[@]} > 0)) || options=(--scenes 100 --seed 1 --gripper franka)

command -v parallel >/dev/null || {
  echo "parallel.sh: no GNU parallel; install the package parallel" >&2
  exit 1
}
command -v quadrille >/dev/null || {
  echo "parallel.sh: no quadrille; put the folder bin of the build into PATH" >&2
  exit 1
}

mkdir -p "$folder"
# One scene at a time in each job: the jobs are what runs side by side.
seq "$jobs" | parallel --will-cite --jobs "$jobs" --halt soon,fail=1 --quote \
  quadrille study grasps "${options[@]}" --threads 1 \
  --shard "{}/$jobs" --csv "$folder/shard_{}.csv" >/dev/null

tables=()
for ((shard = 1; shard <= jobs; ++shard)); do tables+=("$folder/shard_$shard.csv"); done
quadrille study summary "${tables[@]}" --plot "$folder/study.svg"
