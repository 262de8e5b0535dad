#!/usr/bin/env bash
# Noise at equal CPU time, ours against Blender's Cycles: same triangles, matt colors, lamps, sky, sun, camera; one thread, no denoiser.
#   bench/peers/cycles.sh [OUT] [HEIGHT] [SAMPLES] [REFERENCE_SAMPLES]      Needs blender (apt-get install blender; 3.4.1 in Debian 12).
# First Cycles renders SAMPLES a pixel, then we get as many as fit into the same CPU seconds. Each picture is compared with its
# own renderer's reference; how far the two references lie apart is printed too.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
out=${1:-/tmp/fastscene-cycles} height=${2:-64} samples=${3:-32} reference=${4:-1024}
bench=${BENCH:-$here/build/release/bin/bench_noise}
command -v blender >/dev/null || { echo "cycles.sh: expected blender on PATH, found none: apt-get install blender" >&2; exit 77; }
prompts=("a modern living room with a gray sofa, sunny day" "a rustic bedroom at night with the lamps on" "an overcast scandinavian kitchen")
only=${ROOMS:-0 1 2}
number() { node -e 'console.log(JSON.parse(process.argv[1])[process.argv[2]])' "$1" "$2"; }
cycles() { blender -b --factory-startup -P "$here/bench/peers/cycles_render.py" -- "$1" "$height" "$2" "$3" "$4" 2>&1 | tee "$4.log" | sed -n 's/^CYCLES //p'; }
for i in $only; do
  dir=$out/$i; mkdir -p "$dir"
  room=(--prompt "${prompts[$i]}" --seed "$i" --plain --height "$height")
  "$bench" export "${room[@]}" -o "$dir" >/dev/null
  theirs=$(cycles "$dir" "$samples" 1 "$dir/cycles.f32")
  # Their time holds the scene's build: measured by one sample, and taken off.
  build=$(cycles "$dir" 1 1 "$dir/one.f32")
  time_s=$(node -e 'const a=JSON.parse(process.argv[1]).cpu_s,b=JSON.parse(process.argv[2]).cpu_s,n=+process.argv[3];console.log((a-b)*n/(n-1))' "$theirs" "$build" "$samples")
  probe=$("$bench" paths "${room[@]}" --samples 4 -o "$dir/probe.f32")
  ours_n=$(node -e 'const p=JSON.parse(process.argv[1]);console.log(Math.max(1,Math.round(p.samples*process.argv[2]/p.cpu_s)))' "$probe" "$time_s")
  ours=$("$bench" paths "${room[@]}" --samples "$ours_n" -o "$dir/ours.f32")
  "$bench" paths --prompt "${prompts[$i]}" --seed "$i" --plain --height "$height" --samples "$reference" -o "$dir/ours_reference.f32" >/dev/null
  cycles "$dir" "$reference" 2 "$dir/cycles_reference.f32" >/dev/null
  echo "room $i: ${prompts[$i]}"
  echo "  Cycles: $samples samples in $time_s CPU s; ours: $(number "$ours" samples) in $(number "$ours" cpu_s)"
  echo "  ours against our reference, their reference against ours:"
  "$bench" compare --height "$height" --reference "$dir/ours_reference.f32" --pictures "$dir/ours.f32" "$dir/cycles_reference.f32"
  echo "  Cycles against its reference:"
  "$bench" compare --height "$height" --reference "$dir/cycles_reference.f32" --pictures "$dir/cycles.f32"
done
