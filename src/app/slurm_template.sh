#!/bin/bash
# Carries out a plan as {{jobs}} jobs of one core each, and joins what they stored in campaign/:
#   sbatch THIS_SCRIPT
# Where it was interrupted, submit it again: finished runs are kept.
{{notes}}#SBATCH --job-name=ricochet
#SBATCH --array=1-{{jobs}}
#SBATCH --cpus-per-task=1
#SBATCH --time={{hours}}:00:00
set -eu
plan={{plan}}
ricochet=${RICOCHET:-ricochet}
part=campaign/part-$SLURM_ARRAY_TASK_ID
"$ricochet" run "$plan" --shard "$SLURM_ARRAY_TASK_ID/{{jobs}}" --jobs 1 --resume{{allow}} --out "$part"
# The last one to end joins all; one at a time looks whether it is the last.
(
  flock 9
  touch "$part/finished"
  if [ "$(ls campaign/part-*/finished | wc -l)" -eq {{jobs}} ] && [ ! -e campaign/runs.sqlite ]; then
    "$ricochet" merge campaign/runs.sqlite campaign/part-*/runs.sqlite
  fi
) 9>campaign/lock
