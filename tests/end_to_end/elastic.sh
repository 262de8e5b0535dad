# A training of several processes loses some, and takes some back. Kill -9, a machine that falls silent, the first one.
. "$(dirname "$0")/lib.sh"

trap 'kill -9 $(jobs -p) 2>/dev/null' EXIT
new_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }
small=(--painted 1 --height 32 --channels 4 --batch 1 --eval-steps 100000 --log-steps 10 --checkpoint-minutes 0.02 --threads 1)
# train NUMBER FLAGS…: one process in the background, its words in NUMBER.log.
train() { local k=$1; shift; "$fastscene" depth train "${small[@]}" --process "$k" "$@" >>"$k.out" 2>>"$k.log" </dev/null & }
# wait_for SECONDS COMMAND…: until it succeeds.
wait_for() {
  local end=$((SECONDS + $1)); shift
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || { tail -n 40 ./*.log ./*/curves.csv >&2; ps -o pid,stat,etime,time,wchan:20,args -p "$(jobs -p | paste -sd,)" >&2; fail "waited in vain: $*"; }
    sleep 0.1
  done
}
logged() { grep -qE -- "$2" "$1.log"; }
last_step() { tail -n 1 "$1/curves.csv" 2>/dev/null | grep -oE '^[0-9]+' || echo 0; }
is_past() { [ "$(last_step "$1")" -gt "$2" ]; }
monotone() { awk -F, 'NR > 2 && $1 + 0 <= last { bad = 1 } NR > 1 { last = $1 + 0 } END { exit bad }' "$1/curves.csv" || fail "steps of $1/curves.csv do not increase"; }

# Three processes; two are killed, one after the other, and one comes back.
port=$(new_port)
three=(-o net --processes 3 --meet "localhost:$port" --minutes 5 --steps 100000)
for k in 0 1 2; do train "$k" "${three[@]}"; pids[k]=$!; done
wait_for 180 is_past net 20
kill -9 "${pids[2]}"
wait_for 180 logged 0 'warning.*process 2 is gone; going on after step [0-9]+ with 2 of 3 processes'
step=$(last_step net)
wait_for 180 is_past net $((step + 20))
kill -9 "${pids[1]}"
wait_for 180 logged 0 'process 1 is gone; going on after step [0-9]+ with 1 of 3 processes'
train 2 "${three[@]}"; pids[2]=$!
wait_for 180 logged 0 'process 2 takes part again; going on after step [0-9]+ with 2 of 3 processes'
step=$(last_step net)
wait_for 180 is_past net $((step + 20))
kill -TERM "${pids[0]}"
wait "${pids[0]}"; [ $? = 143 ] || fail "the first process was not stopped"
wait "${pids[2]}"
logged 0 'MB of gradients' || fail "nothing is said of what the exchange costs"
monotone net
has net/checkpoint.safetensors

# The same command ends what was begun, with all three; the first one lost ends them all.
last=$(last_step net)
three=(-o net --processes 3 --meet "localhost:$port" --steps $((last + 100000)))
rm -f ./*.log
for k in 0 1 2; do train "$k" "${three[@]}"; pids[k]=$!; done
wait_for 180 is_past net $((last + 20))
logged 0 "resuming after step" || fail "the training began anew"
kill -9 "${pids[0]}"
for k in 1 2; do
  wait "${pids[k]}" && fail "process $k ends well without the first"
  logged "$k" 'expected process 0 at localhost:[0-9]+, found it gone' || fail "process $k says: $(tail -n 2 "$k.log")"
done
three=(-o net --processes 3 --meet "localhost:$port" --steps $(($(last_step net) + 30)))
for k in 0 1 2; do train "$k" "${three[@]}"; pids[k]=$!; done
for k in 0 1 2; do wait "${pids[k]}" || fail "process $k: $(tail -n 3 "$k.log")"; done
monotone net

# A launcher's environment instead of flags.
port=$(new_port)
for k in 0 1; do
  RANK=$k WORLD_SIZE=2 MASTER_ADDR=localhost MASTER_PORT=$port "$fastscene" depth train "${small[@]}" --steps 4 -o two >"$k.out" 2>"$k.log" </dev/null & pids[k]=$!
done
for k in 0 1; do wait "${pids[k]}" || fail "process $k: $(tail -n 3 "$k.log")"; done
logged 0 'training: 2 processes' || fail "the launcher's environment is not read"

# A machine that falls silent: two networks of this machine, and the cable between them is pulled.
if ! unshare -n true 2>/dev/null || ! command -v ip >/dev/null; then
  echo "not tested: a machine that falls silent (needs root and ip)"
  exit 0
fi
rm -f ./*.log
unshare -n sleep 600 & near=$!
unshare -n sleep 600 & far=$!
in_net() { nsenter -t "$1" -n "${@:2}"; }
separate() { [ "$(readlink "/proc/$1/ns/net")" != "$(readlink /proc/self/ns/net)" ]; }
wait_for 10 separate "$near"; wait_for 10 separate "$far"
in_net "$near" ip link add cable type veth peer name cable netns "/proc/$far/ns/net"
in_net "$near" ip address add 10.46.0.1/24 dev cable
in_net "$far" ip address add 10.46.0.2/24 dev cable
for net in "$near" "$far"; do in_net "$net" ip link set lo up; in_net "$net" ip link set cable up; done
apart=(-o apart --processes 2 --meet 10.46.0.1:20046 --steps 100000)
for k in 0 1; do
  net=$near; [ $k = 0 ] || net=$far
  in_net "$net" "$fastscene" depth train "${small[@]}" --process $k "${apart[@]}" >"$k.out" 2>"$k.log" </dev/null & pids[k]=$!
done
wait_for 180 is_past apart 20
in_net "$near" ip link set cable down
wait_for 180 logged 0 'process 1 is gone; going on after step [0-9]+ with 1 of 2 processes'
wait_for 180 logged 1 'expected process 0 at 10.46.0.1:20046, found it gone'
