#!/usr/bin/env bash
# gpu_networks.sh [BUILD]: the networks on this machine's graphics card: builds them alone with the libtorch that
# python3 has (or FASTSCENE_TORCH), and prints what a panorama, its enlargement, a depth network and the inpainter take,
# and how far from the processor's or from single precision's results they are. Lines of JSON go to
# $OUT/networks.jsonl. A part that fails does not stop the others. Takes about two minutes on 16 cores.
#
# FASTSCENE_DEPENDENCIES: what bench/gpu/collect.sh made, where Debian's packages are missing.
# FASTSCENE_BENCH_S: seconds after which no further part starts (210).
# FASTSCENE_BENCH_DEVICE=cpu FASTSCENE_BENCH_WIDTH=256: to try this script without a card.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-${TMPDIR:-/tmp}/fastscene-networks}
out=${OUT:-$build}
device=${FASTSCENE_BENCH_DEVICE:-cuda}
width=${FASTSCENE_BENCH_WIDTH:-1024}
budget=${FASTSCENE_BENCH_S:-210}
jobs=$(nproc)
models=$(cd "${FASTSCENE_MODELS:-$root/models}" && pwd)
lines=$out/networks.jsonl
mkdir -p "$build" "$out"
: > "$lines"
export OMP_WAIT_POLICY=passive
begin=$SECONDS
say() { echo "[$((SECONDS - begin)) s] $*"; }

torch=${FASTSCENE_TORCH:-$(python3 -c 'import importlib.util as u; print(list(u.find_spec("torch").submodule_search_locations)[0])' 2> /dev/null)}
[ -n "$torch" ] || { echo "gpu_networks.sh: expected a python3 with torch, or FASTSCENE_TORCH=FOLDER of libtorch, found neither" >&2; exit 1; }
cuda=${FASTSCENE_CUDA_TOOLKIT:-/usr/local/cuda}
[ -e "$cuda" ] || cuda=$(dirname "$(dirname "$(command -v nvcc)")")
say "libtorch in $torch, CUDA in $cuda, $(g++ --version | head -1), $jobs cores"
nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv,noheader 2> /dev/null

generator=()
command -v ninja > /dev/null && generator=(-G Ninja)
configure=(cmake -S "$root/bench/gpu" "${generator[@]}" -DFASTSCENE_MODELS="$models"
  -DFASTSCENE_DEPENDENCIES="${FASTSCENE_DEPENDENCIES:-}" -DFASTSCENE_CUDA_ARCH="${FASTSCENE_CUDA_ARCH:-native}")

# A log's end, where a step failed.
failed() {
  say "FAILED: $1"
  grep -nE "error|Error|undefined reference" "$2" | head -30
  tail -30 "$2"
}

say "building"
if ! timeout 60 "${configure[@]}" -B "$build/tree" -DFASTSCENE_TORCH="$torch" -DFASTSCENE_CUDA_TOOLKIT="$cuda" \
    > "$build/configure.log" 2>&1; then
  failed configure "$build/configure.log"
  exit 1
fi
# Whether libtorch's own CMake files configure as well, as the whole program asks for them.
(timeout 60 "${configure[@]}" -B "$build/found" -DCMAKE_PREFIX_PATH="$torch" > "$build/found.log" 2>&1
 echo $? > "$build/found.status") &
found=$!
# Without what does not compile: first our kernels, then all of CUDA but libtorch's own.
for without in "" -DFASTSCENE_NVCC=NO -DFASTSCENE_PLAIN=ON; do
  [ -z "$without" ] || "${configure[@]}" -B "$build/tree" "$without" > "$build/configure.log" 2>&1
  timeout "${FASTSCENE_BENCH_BUILD_S:-150}" cmake --build "$build/tree" -j "$jobs" --target bench_networks bench_diffusion card_test \
    -- -k 0 > "$build/build$without.log" 2>&1 && break
  failed "build $without" "$build/build$without.log"
  [ ! -x "$build/tree/bench_networks" ] || break
done
say "built"
bench=$build/tree/bench_networks
[ -x "$bench" ] || exit 1

weights=${FASTSCENE_BENCH_WEIGHTS:-$build/weights}
if [ ! -e "$weights/RealESRGAN_x2plus.pth" ]; then
  rm -rf "$weights"
  timeout 90 "$build/tree/bench_diffusion" --threads "$jobs" --write "$weights" > "$build/write.log" 2>&1 \
    || failed "writing weights" "$build/write.log"
fi
say "weights of Stable Diffusion 1.5's sizes: $(du -shL "$weights" 2> /dev/null | cut -f1)"

# Whether a part of so many seconds still fits.
has() { [ $((SECONDS - begin + $1)) -le "$budget" ] || { say "no time for $2"; return 1; }; }

# run NAME SECONDS flags…: one part, its line with its name and the card's memory.
run() {
  local name=$1 limit=$2
  shift 2
  has 8 "$name" || return 0
  local log=$build/$name.log failed=1
  (while sleep 0.3; do nvidia-smi --query-gpu=memory.used --format=csv,noheader,nounits; done) > "$build/$name.mib" 2> /dev/null &
  local watch=$!
  if timeout "$limit" "$bench" --device "$device" --width "$width" --weights "$weights" --models "$models" "$@" \
      > "$build/$name.json" 2> "$log"; then
    local mib
    mib=$(sort -n "$build/$name.mib" | tail -1)
    failed=0
    sed "s/^{/{\"name\":\"$name\",\"card_mib\":${mib:-0},/" "$build/$name.json" | tee -a "$lines"
  else
    failed "$name" "$log"
  fi
  head -5 "$log"
  kill "$watch" 2> /dev/null
  wait "$watch" 2> /dev/null
  say "$name done"
  return $failed
}
half=fp16
[ "$device" = cpu ] && half=bf16

if [ -x "$build/tree/card_test" ]; then
  timeout 60 "$build/tree/card_test" > "$build/card_test.log" 2>&1 || failed "tests on the card" "$build/card_test.log"
  tail -4 "$build/card_test.log"
  say "tests done"
fi
# A first part that fails goes without our kernels, then without graphs, and so do the others.
if ! run parts_half 40 --part parts --precision $half --runs 5; then
  export FASTSCENE_CUDA_KERNELS=0
  run parts_half_no_kernels 40 --part parts --precision $half --runs 5 || export FASTSCENE_CUDA_GRAPHS=0
fi
run paint_half 40 --part paint --precision $half --runs 5 --keep "$build/half.rgb"
run enlarge_half 60 --part enlarge --precision $half --runs 1
run paint_float 40 --part paint --precision float --runs 2 --keep "$build/float.rgb" --against "$build/half.rgb"
run depth 40 --part depth --runs 3
wanted_width=$width
[ "$width" = 1024 ] && width=1092  # the size of DA-2's published evaluation
run da2_float 40 --part da2 --precision float --runs 3
run da2_bf16 40 --part da2 --precision bf16 --runs 3
width=$wanted_width
run inpaint 60 --part inpaint --runs 2
FASTSCENE_CUDA_KERNELS=0 run paint_half_no_kernels 40 --part paint --precision $half --runs 3 --against "$build/float.rgb"
FASTSCENE_CUDA_GRAPHS=0 run paint_half_no_graphs 40 --part paint --precision $half --runs 3 --against "$build/float.rgb"
run paint_bf16 40 --part paint --precision bf16 --runs 2 --against "$build/float.rgb"
wanted_width=$width wanted_device=$device width=256 device=cpu
run small_cpu 40 --part paint --precision float --steps 4 --runs 1 --keep "$build/small.rgb"
device=$wanted_device
run small_float 40 --part paint --precision float --steps 4 --runs 1 --against "$build/small.rgb"
width=$wanted_width

wait "$found" 2> /dev/null
say "find_package(Torch) of libtorch's own: exit code $(cat "$build/found.status" 2> /dev/null)"
[ "$(cat "$build/found.status" 2> /dev/null)" = 0 ] || tail -15 "$build/found.log"
if ! has 30 "compiling training"; then :
elif timeout 60 cmake --build "$build/tree" -j "$jobs" --target networks_training > "$build/training.log" 2>&1; then
  say "training compiles as well"
else
  failed "compiling training" "$build/training.log"
fi
tar -czf "$out/networks_logs.tgz" -C "$build" $(cd "$build" && ls -- *.log)
python3 - "$lines" <<'P'
import json, sys
rows = [json.loads(line) for line in open(sys.argv[1])]
print(f"{'part':24}{'first s':>9}{'s':>9}{'MiB':>8}  difference (255ths: largest, mean)")
for r in rows:
    d = r.get("difference_255ths")
    said = f"{d['largest']:.0f}, {d['mean']:.4f}" if d else ""
    if "runs" in r:
        said = "; ".join(", ".join(f"{k} {v:.2f}" for k, v in run.items()) for run in r["runs"])
    print(f"{r['name']:24}{r.get('first_s', 0):9.3f}{r.get('s', 0):9.3f}{r['card_mib']:8}  {said}")
P
say "done"
