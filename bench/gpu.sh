#!/bin/bash
# What a graphics card does for a scene: steps of splat training, path tracing, a whole scene, networks. In two halves, since machines
# with cards are often bare:
#
#   bench/gpu.sh pack FILE.tar.xz     on a machine with a build (build/release): programs, and the libraries they need
#   bench/gpu.sh run FILE.tar.xz [OUT]   on the machine with the card: at most 8 minutes; figures go to OUT, too
#
# `run` needs a Vulkan driver (of NVIDIA's: with libGLX_nvidia), bash and xz. Networks are measured where python3 has
# PyTorch with CUDA, whose libtorch they are built with: bench/gpu_networks.sh says what that needs.
set -u
root=$(cd "$(dirname "$0")/.." && pwd)
prompt="a cozy bedroom with a red armchair and a large window"

pack() {
  local bin=$root/build/release/bin out=$1 folder
  folder=$(mktemp -d) && mkdir "$folder/lib"
  for program in bench_splat bench_scene bench_trace splat_test trace_test; do
    [ -x "$bin/$program" ] || { echo "expected $bin/$program: ninja -C build/release bin/{bench_splat,bench_scene,bench_trace,splat_test,trace_test}" >&2; exit 1; }
    cp "$bin/$program" "$folder/" && strip "$folder/$program"
    ldd "$bin/$program" | awk '$3 ~ /^\// { print $3 }' | grep -vE '/lib(c|m|stdc\+\+|gcc_s|pthread|dl|rt)\.so' |
      xargs -I{} cp -Lu {} "$folder/lib/"
  done
  # The loader of drivers, and what NVIDIA's driver asks for.
  local library
  for library in vulkan.so.1 GLdispatch.so.0 GLX.so.0 EGL.so.1 OpenGL.so.0 GL.so.1 X11.so.6 Xext.so.6 xcb.so.1 Xau.so.6 \
    Xdmcp.so.6 bsd.so.0 md.so.0; do
    library=/lib/x86_64-linux-gnu/lib$library
    [ -e "$library" ] && cp -Lu "$library" "$folder/lib/"
  done
  # Networks are built there, with the libtorch that is there.
  mkdir "$folder/networks"
  tar -C "$root" -cf - cmake bench models tests/test_main.cc src/fastscene/{base,math,image,geometry,scene,trace,io,nn} |
    tar -C "$folder/networks" -xf -
  bash "$root/bench/gpu/collect.sh" "$folder/networks/dependencies" || exit 1
  tar -C "$folder" -cJf "$out" . && rm -r "$folder" && ls -l "$out"
}

run() {
  local folder out=${2:-gpu_results} start=$SECONDS
  folder=$(mktemp -d) && tar -C "$folder" -xJf "$1" && mkdir -p "$out" || exit 1
  local nvidia=/usr/local/nvidia/share/vulkan/icd.d/nvidia_icd.json
  [ -z "${VK_DRIVER_FILES:-}" ] && [ -f $nvidia ] && export VK_DRIVER_FILES=$nvidia
  export FASTSCENE_VULKAN_VALIDATION=${FASTSCENE_VULKAN_VALIDATION:-0} OMP_WAIT_POLICY=passive
  # $1: seconds at most; the rest: a program of the package and its arguments.
  go() { local limit=$1 program=$2; shift 2; LD_LIBRARY_PATH=$folder/lib timeout "$limit" "$folder/$program" "$@"; }
  echo "== tests"
  go 90 splat_test --gtest_filter='Vulkan*' > "$out/tests.txt" 2>&1
  go 60 trace_test --gtest_filter='Vulkan*:Kernels*' >> "$out/tests.txt" 2>&1
  grep -E '^\[ +(OK|FAILED|PASSED) |Failure|Expected' "$out/tests.txt" | tail -n 30
  echo "== steps of splat training"
  : > "$out/steps.jsonl"
  for size in "50000 512" "200000 512" "250000 640" "600000 960"; do
    go 60 bench_splat --device auto --count "${size% *}" --size "${size#* }" --steps 1000 --warm 200 --json | tee -a "$out/steps.jsonl"
  done
  echo "== path tracing of a room, on the card and on the processor"
  go 90 bench_trace --trace-device auto | tee "$out/trace.json"
  echo "== a scene from a sentence, with the room and its splats on the card and on the processor"
  for quality in draft standard; do
    go 120 bench_scene "$prompt" --quality $quality --device auto --trace-device auto | tee "$out/scene_$quality.json"
  done
  go 120 bench_scene "$prompt" --quality standard | tee "$out/scene_processor.json"
  echo "== networks"
  if python3 -c 'import importlib.util as u, sys; sys.exit(u.find_spec("torch") is None)' 2> /dev/null; then
    FASTSCENE_DEPENDENCIES=$folder/networks/dependencies FASTSCENE_BENCH_S=${FASTSCENE_BENCH_S:-130} OUT=$out \
      timeout 170 bash "$folder/networks/bench/gpu_networks.sh" "$folder/networks-build"
  else
    echo "no python3 with torch here: networks are not measured"
  fi
  echo "== $((SECONDS - start)) s"
  rm -r "$folder"
}

case "${1:-}" in
  pack) pack "${2:?a file}" ;;
  run) run "${2:?a file}" "${3:-}" ;;
  *) sed -n '2,10s/^# \{0,1\}//p' "$0"; exit 2 ;;
esac
