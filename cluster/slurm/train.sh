#!/bin/bash
# One training on several nodes. Copy this file, change what you need, and submit it with a command of fastscene:
#
#   sbatch train.sh depth train --data /shared/rooms -o /shared/net
#   sbatch --nodes=8 train.sh inpaint train /shared/holes -o /shared/inpainter
#
# Data, the folder of the training and the program must have the same paths on all nodes.
#SBATCH --job-name=fastscene-train
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=16
#SBATCH --time=24:00:00
#SBATCH --output=train-%j.out
#SBATCH --open-mode=append
# A node that is lost does not end the job: the other nodes go on. One that takes the first process with it does, and
# the job starts again from the last checkpoint.
#SBATCH --no-kill
#SBATCH --requeue
# The script is warned two minutes before the time limit, so that the training can go on in a further run.
#SBATCH --signal=B:USR1@120
program=${FASTSCENE:-fastscene}
most_requeues=20    # a training that needs more runs than this is given up
most_restarts=5     # of one process that is killed

# The first process is on the first node. By the address that Slurm itself uses: names of nodes need not resolve.
first=$(scontrol show hostnames "$SLURM_JOB_NODELIST" | head -n 1)
export MASTER_ADDR=$(scontrol --oneliner show node "$first" | grep -oP ' NodeAddr=\K\S+')
export MASTER_PORT=$((20000 + SLURM_JOB_ID % 10000))

requeue() {
  if [ "${SLURM_RESTART_COUNT:-0}" -ge "$most_requeues" ]; then
    echo "given up after $most_requeues requeues" >&2
    exit 1
  fi
  echo "$(date -Is) $1; requeued" >&2
  scontrol requeue "$SLURM_JOB_ID"
  exit 0
}
child=
# srun passes TERM on; the training saves a checkpoint.
stop() { [ -n "$child" ] && kill -TERM "$child" 2>/dev/null && wait "$child"; }
trap 'stop; requeue "the time limit is near"' USR1
trap 'stop; exit 143' TERM

# A process that is killed, by a lack of memory for instance, is started again and joins the others, which went on
# without it. Not the first one: it is what they meet at. Its exit code decides what becomes of the job.
result=$(mktemp -u "${SLURM_SUBMIT_DIR:-.}/.train-$SLURM_JOB_ID.XXXXXX")
task='
export RANK=$SLURM_PROCID WORLD_SIZE=$SLURM_NTASKS
for ((run = 0; ; ++run)); do
  "$@"
  code=$?
  [ "$SLURM_PROCID" != 0 ] && [ "$code" -gt 128 ] && [ "$code" != 143 ] && [ "$run" -lt "$MOST_RESTARTS" ] || break
  echo "$(hostname): process $SLURM_PROCID was killed, and starts again" >&2
  sleep 1
done
[ "$SLURM_PROCID" != 0 ] || echo "$code" >"$RESULT"
exit "$code"'
RESULT=$result MOST_RESTARTS=$most_restarts srun --cpus-per-task="${SLURM_CPUS_PER_TASK:-1}" \
  --no-kill --kill-on-bad-exit=0 --wait=0 --unbuffered \
  bash -c "$task" fastscene-train "$program" "$@" --threads "${SLURM_CPUS_PER_TASK:-1}" &
child=$!
wait "$child"

code=$(cat "$result" 2>/dev/null)
rm -f "$result"
case ${code:-lost} in
  0) exit 0 ;;
  lost | 129 | 13[0-9] | 14[0-2]) requeue "the first process was lost" ;;
esac
exit "$code"
