# Killed at any moment and started again, a run ends in the same bytes; a polite stop keeps what is finished.
. "$(dirname "$0")/lib.sh"

expect 0 "$fastscene" make "$prompt" -o whole "${tiny[@]}"
start=$(date +%s%N)
expect 0 "$fastscene" make "$prompt" -o timed "${tiny[@]}"
took_ms=$((($(date +%s%N) - start) / 1000000))

# Killed again and again at drawn moments, and let through in the end.
RANDOM=7
for i in 1 2 3 4 5 6; do
  "$fastscene" make "$prompt" -o killed "${tiny[@]}" >/dev/null 2>&1 &
  pid=$!
  wait_ms=$((20 + RANDOM % (took_ms + 1)))
  sleep "$(printf '%d.%03d' $((wait_ms / 1000)) $((wait_ms % 1000)))"
  kill -9 "$pid" 2>/dev/null
  wait "$pid" 2>/dev/null
done
expect 0 "$fastscene" make "$prompt" -o killed "${tiny[@]}"
same whole killed
no_rest killed

# Stage by stage in processes of their own: the same again, with the settings of run.json.
expect 0 "$fastscene" panorama "$prompt" -o staged "${tiny[@]:0:10}"
lacks staged/depth
expect 0 "$fastscene" depth staged
has staged/depth/range.exr
expect 0 "$fastscene" walk staged --walk-viewpoints 2 --walk-room-viewpoints 2
lacks staged/views
expect 0 "$fastscene" views staged --views-size 48 --views-points 4000
expect 0 "$fastscene" splat staged --splat-count 2000 --splat-steps 20
same whole staged

# SIGTERM: the work under way is dropped, the finished stages stay, the exit code tells.
"$fastscene" make "$prompt" -o stopped "${tiny[@]}" --splat-steps 200000 >out 2>log &
pid=$!
for i in $(seq 600); do [ -e stopped/.splat.part ] && break; sleep 0.1; done
sleep 0.2
kill -TERM "$pid"
code=0; wait "$pid" || code=$?
[ "$code" = 143 ] || fail "exit code $code after SIGTERM, expected 143"
says "stopped"
has stopped/views/stage.json stopped/walk/stage.json
lacks stopped/splat
no_rest stopped

# A training that was stopped goes on from where it was, and ends as one that never was. A fast machine is given more steps, until
# the signal finds it at work.
for steps in 6000 24000 96000 384000; do
  rm -rf photos
  "$fastscene" splat --colmap whole/views -o photos --splat-count 2000 --splat-steps $steps >out 2>log &
  pid=$!
  for i in $(seq 600); do [ -e photos/.splat.part ] && break; sleep 0.1; done
  sleep 0.5
  kill -INT "$pid" 2>/dev/null
  code=0; wait "$pid" || code=$?
  [ "$code" = 0 ] || break
done
[ "$code" = 130 ] || fail "exit code $code after SIGINT, expected 130"
has photos/.splat.unfinished
expect 0 "$fastscene" splat --colmap whole/views -o photos --splat-count 2000 --splat-steps $steps
says "resuming from step"
lacks photos/.splat.unfinished
expect 0 "$fastscene" splat --colmap whole/views -o straight --splat-count 2000 --splat-steps $steps
cmp photos/splat/scene.ply straight/splat/scene.ply || fail "a stopped training ends otherwise"

# Two at once on one folder: the second is turned away.
"$fastscene" make "$prompt" -o stopped "${tiny[@]}" --splat-steps 200000 >out 2>/dev/null &
pid=$!
for i in $(seq 600); do [ -e stopped/.splat.part ] && break; sleep 0.1; done
expect 1 "$fastscene" make "$prompt" -o stopped "${tiny[@]}"
says "another fastscene is working on this folder"
kill -TERM "$pid"; wait "$pid"
expect 0 "$fastscene" make "$prompt" -o stopped "${tiny[@]}"
same whole stopped
exit 0
