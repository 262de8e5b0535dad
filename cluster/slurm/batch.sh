#!/bin/bash
# Scenes as a Slurm job array: each task makes one chunk of the scenes in scenes.jsonl, one process a scene.
# `fastscene batch --engine slurm` wrote this file. Change what you need, and submit it again: sbatch THIS-FILE
#
# --status and --cancel find the tasks by this name.
#SBATCH --job-name=@NAME@
#SBATCH --array=@ARRAY@
#SBATCH --output="@FOLDER@/slurm/%A_%a.out"
#SBATCH --open-mode=append
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=@CORES@
#SBATCH --mem=@MEMORY_MIB@M
#SBATCH --time=@MINUTES@
# A task that loses its node or is preempted starts again, and goes on with what is not finished.
#SBATCH --requeue
# The script is warned two minutes before the time limit, so that the task can go on in a further run.
#SBATCH --signal=B:USR1@120
@EXTRA@
program=@PROGRAM@
folder=@FOLDER_QUOTED@
# A disk of the node's own, where scenes are made before they are moved to the folder. Empty: made in the folder.
scratch="@SCRATCH@"
# A task that needs more runs than this is given up.
most_requeues=20

child=
stop() { [ -n "$child" ] && kill -TERM "$child" 2>/dev/null && wait "$child"; }
near_limit() {
  echo "$(hostname): the time limit is near; what is finished stays" >&2
  stop
  if [ "${SLURM_RESTART_COUNT:-0}" -ge "$most_requeues" ]; then
    echo "given up after $most_requeues requeues: the time limit is too short for one step (--time)" >&2
    exit 1
  fi
  echo "$(date -Is) $(hostname)" >>"$folder/tasks/$SLURM_ARRAY_TASK_ID.requeues"
  # Not by SLURM_JOB_ID: the last task's is the whole array's.
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
  exit 0
}
trap near_limit USR1
trap 'stop; exit 143' TERM

if [ ! -x "$program" ]; then
  echo "$(hostname): $program: expected fastscene, found no such program on this node" >&2
  exit 1
fi
"$program" batch --chunk "$SLURM_ARRAY_TASK_ID" -o "$folder" ${scratch:+--scratch "$scratch"} \
  --threads "${SLURM_CPUS_PER_TASK:-1}" --progress none &
child=$!
wait "$child"
