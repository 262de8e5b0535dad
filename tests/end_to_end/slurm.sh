# Scenes on a real Slurm cluster of this machine: munged, slurmctld and three slurmd. A node is lost in the middle, a
# task meets its time limit, and the bytes are those of a local run.
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$(dirname "$0")/lib.sh"

export PATH=$PATH:/usr/sbin:/sbin
for program in munged mungekey slurmctld slurmd sbatch squeue scontrol scancel; do
  command -v $program >/dev/null || { echo "skipped: no $program; packaging/apt-test.txt names Slurm's packages"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: slurmd starts jobs as root only"; exit 77; }

# Sockets have short paths only.
cluster=$(mktemp -d /tmp/fastscene-slurm.XXXXXX)
chmod 755 "$cluster"
# Processes with this in their environment: daemons and jobs have SLURM_CONF, and nothing else has.
ours() {
  local files
  files=$(grep -lzxF -- "SLURM_CONF=$cluster/slurm.conf" /proc/[0-9]*/environ 2>/dev/null)
  [ -z "${1-}" ] || files=$(grep -lzxF -- "$1" $files /dev/null 2>/dev/null)
  grep -oE '[0-9]+' <<<"$files"
}
clean_up() {
  local pids
  pids=$(ours)
  [ -z "$pids" ] || kill -9 $pids 2>/dev/null
  rm -rf "$cluster"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

# What there is to read about a failure: the queue, the daemons, the jobs' processes, and the training.
evidence() {
  squeue
  tail -n 15 "$cluster"/*.log
  ps -o pid,ppid,stat,etime,time,wchan:20,args -p "$(ours | paste -sd,)"
  for file in train.out net/curves.csv; do [ ! -f $file ] || tail -v -n 80 $file; done
}
# wait_for SECONDS COMMAND…: until it succeeds.
wait_for() {
  local end=$((SECONDS + $1)); shift
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || { evidence >&2; fail "waited in vain: $*"; }
    sleep 0.3
  done
}

# Ports that nobody listens at.
free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }
host=$(hostname -s)
cat > "$cluster/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmUser=root
AuthType=auth/munge
CredType=cred/munge
# A requeued job waits as long as its old credential is good for.
AuthInfo=socket=$cluster/munge.socket,cred_expire=5
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool.%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
KillWait=2
CompleteWait=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
SlurmdParameters=config_overrides
MaxArraySize=4
$(for node in 0 1 2; do
  echo "NodeName=node$node NodeHostname=$host NodeAddr=127.0.0.1 Port=$(free_port) CPUs=1 RealMemory=8000"
done)
PartitionName=all Nodes=node[0-2] Default=YES MaxTime=60 State=UP
CONF
export SLURM_CONF=$cluster/slurm.conf
mkdir "$cluster/state"
mungekey --create --keyfile "$cluster/munge.key"
start() { "$@" >>"$cluster/start.log" 2>&1 || { cat "$cluster/start.log" >&2; fail "cannot be started: $*"; }; }
start munged --key-file="$cluster/munge.key" --socket="$cluster/munge.socket" --pid-file="$cluster/munged.pid" \
  --log-file="$cluster/munged.log" --seed-file="$cluster/munge.seed" --num-threads=2
start slurmctld -c
for node in 0 1 2; do start slurmd -N node$node; done
all_idle() { [ "$(sinfo --noheader --Node --format=%T 2>/dev/null | grep -cx idle)" = 3 ]; }
wait_for 60 all_idle

# Six scenes, panoramas alone; the first of every task takes some seconds, so that something is lost with a node.
small=(--stage panorama --quality draft --panorama-width 128 --panorama-cell 0.25 --panorama-cell-samples 8 --panorama-pixel-samples 2 --panorama-outside-detail 0)
for i in 0 1 2 3 4 5; do
  slow=; [ $((i % 2)) = 1 ] || slow=', "flags": ["--panorama-pixel-samples", "300"]'
  echo "{\"prompt\": \"a small study with a desk\", \"seed\": $i, \"name\": \"study-$i\"$slow}"
done > list.jsonl
expect 0 "$fastscene" batch list.jsonl -o alone "${small[@]}" --threads 2
batch=("$fastscene" batch list.jsonl -o set "${small[@]}" --engine slurm --threads 1 --scratch "$cluster/scratch")

# What cannot be submitted is not.
PATH=/nowhere expect 1 "$fastscene" batch list.jsonl -o none "${small[@]}" --engine slurm
says "expected Slurm's programs on PATH, found no scontrol"
expect 2 "${batch[@]}" --chunk-scenes 1
says "--chunk-scenes: expected at least 2, found 1: 6 scenes, and an array of at most 3 tasks"
expect 1 "${batch[@]}" --slurm-args --time=soon
says "sbatch: "
says "time"
expect 2 "${batch[@]}" --slurm-args 60
says '--slurm-args: expected flags of sbatch'
expect 2 "$fastscene" batch set --cancel
says "expected a batch that was submitted"

# Three tasks of two scenes, three nodes.
expect 0 "${batch[@]}" --parallel 3 --slurm-args "--partition=all --time=10"
prints "6 scenes in 3 tasks"
grep -q '^#SBATCH --array=0-2%3$' set/slurm/batch.sh || fail "the script does not limit the tasks at a time"
expect 1 "${batch[@]}"
says "tasks of this batch are pending or running in Slurm"
expect 1 "$fastscene" batch list.jsonl -o set "${small[@]}"
says "tasks of this batch are pending or running in Slurm"

# A node dies with all that runs on it.
on_node() { tasks=$(squeue --noheader --states=R --nodelist=$1 --format=%i); [ -n "$tasks" ] && [ -n "$(ours SLURMD_NODENAME=$1)" ]; }
wait_for 30 on_node node1
lost=$tasks
for pid in $(ours SLURMD_NODENAME=node1); do
  parent=$(sed -n 's/^PPid:\s*//p' "/proc/$pid/status" 2>/dev/null)
  case $(tr '\0' ' ' <"/proc/${parent:-none}/cmdline" 2>/dev/null) in slurmstepd*) kill -9 "$parent" ;; esac
  kill -9 "$pid" 2>/dev/null
done
kill -9 "$(cat "$cluster/slurmd.node1.pid")"
scontrol update nodename=node1 state=down reason=test
requeued() { squeue --noheader --array --format='%i %T' | grep -qE "^$lost (PENDING|RUNNING)" && ! squeue --noheader --nodelist=node1 --states=R | grep -q .; }
wait_for 20 requeued

# Another meets its time limit: the script is told as Slurm tells it.
wait_for 30 on_node node2
scancel --signal=USR1 --batch "$(echo $tasks | head -n 1)"
has_requeue() { grep -q node2 set/tasks/*.requeues 2>/dev/null || grep -q . set/tasks/*.requeues 2>/dev/null; }
wait_for 20 has_requeue
expect 0 "$fastscene" batch set --status --json
prints '"source": "squeue"'
prints '"requeues": 1'

ended() { [ -z "$(squeue --noheader)" ]; }
wait_for 120 ended
expect 0 "$fastscene" batch set --status
prints "6 of 6 scenes done, 0 failed"
prints "requeued 1 times"
for i in 0 1 2 3 4 5; do
  same "alone/study-$i" "set/study-$i"
done
no_rest set
has set/index.html
[ -z "$(ls "$cluster/scratch")" ] || fail "scenes are left on the node's own disk"

# Nothing is left to do; the journals of the tasks become one.
expect 0 "${batch[@]}"
prints "nothing to do"
lacks set/tasks/000000.jsonl
[ "$(wc -l < set/batch.jsonl)" = 6 ] || fail "the journal lacks scenes"

# Another version of the program is refused.
expect 0 "$fastscene" batch list.jsonl -o chunks "${small[@]}" --engine manual --chunk-scenes 5
prints "6 scenes in 2 chunks"
expect 2 "$fastscene" batch --chunk 2 -o chunks
says "--chunk: expected a number below 2"
expect 0 "$fastscene" batch --chunk 1 -o chunks --threads 1
same alone/study-5 chunks/study-5
sed -i 's/"version": "[^"]*"/"version": "0.0.1"/' chunks/batch.json
expect 1 "$fastscene" batch --chunk 0 -o chunks
says "expected version 0.0.1 of fastscene"

# Cancelled, and what was finished stays.
sed -i 's/"name": "/"name": "again-/' list.jsonl
expect 0 "$fastscene" batch list.jsonl -o set "${small[@]}" --engine slurm --threads 1
wait_for 30 on_node node0
expect 0 "$fastscene" batch set --cancel
prints "tasks cancelled"
wait_for 30 ended

# A data set by several tasks at once, and the bytes of one process.
set_flags=(--count 6 --views 2 --size 64x32 --cell 0.4 --cell-samples 2 --pixel-samples 1 --outside-detail 0)
expect 0 "$fastscene" rooms dataset "${set_flags[@]}" -o rooms_alone
FASTSCENE=$fastscene expect 0 sbatch --array=0-1 --cpus-per-task=1 --mem=1G --time=10 --wait \
  "$(dirname "$0")/../../cluster/slurm/dataset.sh" "${set_flags[@]}" -o "$work/rooms_together"
FASTSCENE=$fastscene expect 0 sbatch --array=0 --cpus-per-task=1 --mem=1G --time=10 --wait \
  "$(dirname "$0")/../../cluster/slurm/dataset.sh" "${set_flags[@]}" -o "$work/rooms_together"
diff -r rooms_alone rooms_together >log || fail "a data set made by tasks differs"

# One training on two nodes. A process is killed and comes back, its node is lost and the other goes on, the first
# process is killed and the job starts again, from the last checkpoint and with another node.
scontrol update nodename=node1 state=resume
start slurmd -N node1
wait_for 60 all_idle
train=(sbatch --parsable --nodes=2 --cpus-per-task=1 --time=10 --output=train.out "$root/cluster/slurm/train.sh" depth train
  -o net --painted 1 --height 32 --channels 4 --batch 1 --eval-steps 100000 --log-steps 10 --checkpoint-minutes 0.02)
export FASTSCENE=$fastscene
job=$("${train[@]}" --steps 100000)
last_step() { tail -n 1 net/curves.csv 2>/dev/null | grep -oE '^[0-9]+' || echo 0; }
is_past() { [ "$(last_step)" -gt "$1" ]; }
logged() { grep -qE -- "$1" train.out; }
ranked() { for pid in $(ours "RANK=$1"); do [ "$(readlink "/proc/$pid/exe")" != "$fastscene" ] || echo "$pid"; done; }
wait_for 180 is_past 20
kill -9 $(ranked 1)
wait_for 120 logged 'process 1 was killed, and starts again'
wait_for 120 logged 'process 1 takes part again|a process was lost and is back'
step=$(last_step)
wait_for 120 is_past $((step + 20))

second=$(scontrol show hostnames "$(squeue --noheader --job="$job" --format=%N)" | tail -n 1)
for pid in $(ours SLURMD_NODENAME="$second"); do kill -9 "$(sed -n 's/^PPid:\s*//p' "/proc/$pid/status")" "$pid" 2>/dev/null; done
kill -9 "$(cat "$cluster/slurmd.$second.pid")"
scontrol update nodename="$second" state=down reason=test
wait_for 120 logged 'process 1 is gone; going on after step [0-9]+ with 1 of 2 processes'
step=$(last_step)
wait_for 120 is_past $((step + 20))

kill -9 $(ranked 0)
wait_for 120 logged 'the first process was lost; requeued'
wait_for 120 logged 'training: resuming after step'
step=$(last_step)
wait_for 120 is_past $((step + 20))
squeue --noheader --job="$job" --format=%N | grep -q "$second" && fail "the job runs on the node that was lost"
scancel "$job"
wait_for 60 ended
sbatch --wait "${train[@]:2}" --steps $(($(last_step) + 20)) >out 2>log || fail "$(tail -n 3 train.out)"
logged 'training: 2 processes' || fail "the last run is not one of two processes"
awk -F, 'NR > 2 && $1 + 0 <= last { bad = 1 } NR > 1 { last = $1 + 0 } END { exit bad }' net/curves.csv || fail "steps do not increase"
