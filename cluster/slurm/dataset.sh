#!/bin/bash
# A data set as a Slurm job array. Every task runs the same command, and takes rooms that no other one works on; the set
# has the bytes of one process. Change what you need, and submit it with the flags of `fastscene rooms dataset`:
#   sbatch --array=0-63 cluster/slurm/dataset.sh --count 100000 --size 512x256 -o /shared/rooms
#
# More tasks may be submitted for the same folder at any time, and again after a failure.
#SBATCH --job-name=fastscene-dataset
#SBATCH --array=0-7
#SBATCH --output=%x-%A_%a.out
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=4
# A process takes 0.4 GiB at 512x256.
#SBATCH --mem=1G
#SBATCH --time=08:00:00
# A task that loses its node or is preempted starts again. Its room is taken over by another one after --stale-minutes.
#SBATCH --requeue
# A minute before the time limit the task is told to stop: it gives its room back, and all that is finished stays.
#SBATCH --signal=B:TERM@60

# The built program, by its full path where it is not on PATH.
program=${FASTSCENE:-fastscene}
exec "$program" rooms dataset "$@" --threads "${SLURM_CPUS_PER_TASK:-1}" --progress none
