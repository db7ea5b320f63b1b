#!/usr/bin/env bash
#SBATCH --job-name=quadrille-logs
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --mem=2G
#SBATCH --time=01:00:00
#SBATCH --output=logs_%a.log
#SBATCH --requeue
# Detects and plans on many LCM logs as a Slurm array: each task takes every N-th log, and resumes
# if it is stopped and requeued.
#
#   sbatch slurm.sh FOLDER LOG…                    8 tasks
#   sbatch --array=1-100 slurm.sh FOLDER LOG…
#
# Slurm runs a copy of this script, so EXAMPLES must name the folder that contains one_log.sh.
set -euo pipefail

folder=${1:?usage: sbatch slurm.sh FOLDER LOG…}
shift
examples=${EXAMPLES:-${SLURM_SUBMIT_DIR:?this is a job for sbatch}}
twice=$(for log in "$@"; do basename "$log"; done | sort | uniq -d)
if [[ -n $twice ]]; then
  echo "slurm.sh: several logs are called $twice, as their results would be; rename them" >&2
  exit 1
fi
mkdir -p "$folder"
for ((i = SLURM_ARRAY_TASK_ID; i <= $#; i += SLURM_ARRAY_TASK_COUNT)); do
  "$examples/one_log.sh" "$folder" "${!i}"
done
