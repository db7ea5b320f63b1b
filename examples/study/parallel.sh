#!/usr/bin/env bash
# Runs a study on all cores of one or several machines, as jobs of GNU parallel.
#
# usage: parallel.sh [FOLDER [JOBS [OPTION…]]]
#
# Each job takes every JOBS-th scene. If it was stopped, run it again: finished scenes are skipped.
# For more machines, which must have the folder, add -S HOST1,HOST2 to parallel's options.
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
# Each job computes one scene at a time, since the jobs themselves run in parallel.
seq "$jobs" | parallel --will-cite --jobs "$jobs" --halt soon,fail=1 --quote \
  quadrille study grasps "${options[@]}" --threads 1 \
  --shard "{}/$jobs" --csv "$folder/shard_{}.csv" >/dev/null

tables=()
for ((shard = 1; shard <= jobs; ++shard)); do tables+=("$folder/shard_$shard.csv"); done
quadrille study summary "${tables[@]}" --plot "$folder/study.svg"
