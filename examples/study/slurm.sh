#!/usr/bin/env bash
#SBATCH --job-name=quadrille-study
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --mem=1G
#SBATCH --time=01:00:00
#SBATCH --output=study_%a.log
#SBATCH --requeue
# Runs a study as a Slurm array: each task takes its share of the scenes, and resumes if it is stopped
# and requeued.
#
#   sbatch slurm.sh FOLDER [OPTION…]              8 tasks
#   sbatch --array=1-100 slurm.sh FOLDER [OPTION…]
#   SHARDS=100 sbatch --array=7,9 slurm.sh FOLDER [OPTION…]    two of the 100 again
#   quadrille study summary FOLDER/shard_*.csv    once all are done
set -euo pipefail

folder=${1:?usage: sbatch slurm.sh FOLDER [OPTION…]}
options=("${@:2}")
((${#options[@]} > 0)) || options=(--scenes 1000 --seed 1 --gripper franka)

# The array must count from 1, and covers the whole study unless SHARDS says that there are more.
shard=${SLURM_ARRAY_TASK_ID:?this is a job for sbatch} shards=${SHARDS:-$SLURM_ARRAY_TASK_COUNT}

mkdir -p "$folder"
exec quadrille study grasps "${options[@]}" --threads "${SLURM_CPUS_PER_TASK:-1}" \
  --shard "$shard/$shards" --csv "$folder/shard_$shard.csv"
