#!/usr/bin/env bash
# job.sh FOLDER STEP: a step as a job of Slurm; of an array, the shard of its number. Where the step was killed or could not
# do its work (exit 4 and more) it asks for another try, at most three times; bad input is not tried again.
set -u
here=$(dirname "$(readlink -f "$0")")
echo "$2 ${SLURM_ARRAY_TASK_ID:-} on ${SLURMD_NODENAME:-this machine}, restart ${SLURM_RESTART_COUNT:-0}"
"$here/step.sh" "$1" "$2" ${SLURM_ARRAY_TASK_ID:+"$SLURM_ARRAY_TASK_ID"}
code=$?
if [ $code -ge 4 ] && [ "${SLURM_RESTART_COUNT:-0}" -lt 3 ]; then
  echo "exit $code: again"
  scontrol requeue "${SLURM_ARRAY_JOB_ID:-$SLURM_JOB_ID}${SLURM_ARRAY_TASK_ID:+_$SLURM_ARRAY_TASK_ID}"
fi
exit $code
