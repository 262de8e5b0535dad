#!/usr/bin/env bash
# Our trainer beside OpenSplat 1.2.0, both on one thread: CPU time of a step at equal Gaussians, loss and settings, and
# CPU seconds until OpenSplat's own held-out PSNR.
#   OPENSPLAT=/path/to/opensplat bench/peers/opensplat.sh [WORK]      WORK: scratch folder, default out/opensplat
# OPENSPLAT is a CPU build of that program. Needs GNU time and taskset.
# Two scenes: a room seen from within (a fifth of the splats in view, as in what this project makes) and a ring around a
# stage (all of them in view). SCENES="room" or "stage" asks for one.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
fail() { echo "opensplat.sh: $*" >&2; exit 2; }
program=${OPENSPLAT:-}
[ -n "$program" ] || fail "OPENSPLAT: expected the path of the program opensplat, found nothing"
[ -f "$program" ] && [ -x "$program" ] || fail "OPENSPLAT=$program: expected a program, found none"
[ -x /usr/bin/time ] || fail "expected GNU time at /usr/bin/time, found none: apt-get install time"
work=$(realpath -m "${1:-$here/out/opensplat}")
peer=$here/build/release/bin/bench_peer fit=$here/build/release/bin/bench_fit
for built in "$peer" "$fit"; do
  [ -x "$built" ] || fail "$built: expected our bench program, found none: ninja -C build/release bench_peer bench_fit"
done
export OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
mkdir -p "$work"

# CPU seconds of a run of OpenSplat: fixed number of Gaussians, every parameter stepped every time, degree 0 active.
opensplat() {  # DATA STEPS OUT
  taskset -c 0 /usr/bin/time -f "%U %S" -o "$work/time" "$program" "$1" --cpu -n "$2" -o "$3" --densify-from 100000000 --densify-until 100000000 \
    --sh-degree 3 --sh-degree-interval 100000000 --ssim-weight 0.2 --num-downscales 0 >"$work/opensplat.log"
  awk '{print $1 + $2}' "$work/time"
}
# Ours, the same views and points, the same way: CPU seconds of a run of so many steps.
ours() { taskset -c 0 "$fit" "$1" --holdout 0 --splat-count "$2" --splat-steps "$3" | sed 's/.*"cpu_s":\([0-9.]*\).*/\1/'; }
# Views both read. OpenSplat prefers transforms.json, whose point file has a column it does not know and then reads garbage from.
views() {  # SCENE SIZE COUNT DATA FLAGS…
  [ -d "$4" ] || "$peer" $(orbit "$1") --size "$2" --count "$3" "${@:5}" write "$4"
  rm -f "$4/transforms.json"
}
orbit() { if [ "$1" = stage ]; then echo --orbit; fi; }
scenes=${SCENES-room stage} goals=${GOALS-512:50000:300 256:50000:1000}

echo "== CPU milliseconds a step, paired, in turn"
for scene in $scenes; do
  for setting in "512 50000" "512 200000"; do
    read -r size count <<<"$setting"
    data=$work/$scene-$size-$count
    views "$scene" "$size" "$count" "$data" --positions 2 --samples 1
    for pair in 1 2; do
      short=$(opensplat "$data" 5 "$work/short.ply") few=$(ours "$data" "$count" 5)
      long=$(opensplat "$data" 25 "$work/long.ply") many=$(ours "$data" "$count" 45)
      awk -v a="$short" -v b="$long" -v c="$few" -v d="$many" -v s="$size" -v n="$count" -v scene="$scene" \
        'BEGIN { t = (b - a) / 20 * 1000; m = (d - c) / 40 * 1000; printf "%s, %dx%d, %d Gaussians: OpenSplat %.0f ms, ours %.1f ms, ratio %.1f\n", scene, s, s, n, t, m, t / m }'
    done
  done
done

echo "== CPU seconds until OpenSplat's held-out PSNR"
for scene in $scenes; do
  for setting in $goals; do
    IFS=: read -r size count steps <<<"$setting"
    data=$work/goal-$scene-$size-$count
    views "$scene" "$size" "$count" "$data"
    cost=$(opensplat "$data" "$steps" "$work/goal.ply")
    load=$(opensplat "$data" 1 "$work/short.ply")
    psnr=$("$peer" $(orbit "$scene") --size "$size" --count "$count" eval "$work/goal.ply" | sed 's/.*:\([0-9.]*\)}/\1/')
    echo "$scene, OpenSplat $size $count: $steps steps, $cost CPU s ($load of them loading and one step), $psnr dB"
    taskset -c 0 "$peer" $(orbit "$scene") --size "$size" --count "$count" train --psnr "$psnr"
  done
done

echo "== Held-out PSNR after many steps, the same number of Gaussians; OpenSplat as it stands but for that number"
for scene in $scenes; do
  for setting in ${LONG-256:20000:1500}; do
    IFS=: read -r size count steps <<<"$setting"
    data=$work/goal-$scene-$size-$count
    views "$scene" "$size" "$count" "$data"
    taskset -c 0 /usr/bin/time -f "%U %S" -o "$work/time" "$program" "$data" --cpu -n "$steps" -o "$work/end.ply" --ssim-weight 0.2 --num-downscales 0 --max-gaussians "$count" >"$work/opensplat.log"
    echo "$scene, OpenSplat $size $count: $steps steps, $(awk '{print $1 + $2}' "$work/time") CPU s, $(head -c 400 "$work/end.ply" | grep -a 'element vertex'), $("$peer" $(orbit "$scene") --size "$size" --count "$count" eval "$work/end.ply")"
    taskset -c 0 "$peer" $(orbit "$scene") --size "$size" --count "$count" train --psnr 1000 --steps "$steps"
  done
done
