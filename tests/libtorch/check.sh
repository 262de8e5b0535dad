#!/usr/bin/env bash
# check.sh fast|all FOLDER [CXX]: whether the networks compile with libtorch 2.x. Only headers are needed, which
# fetch.sh brings to FOLDER; nothing is linked. fast: the sources that differ by version; all: every source that
# includes libtorch. Exit code 77: no headers.
set -euo pipefail
which=${1:?"fast or all"}
to=${2:?"a folder for the headers"}
cxx=${3:-g++}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
bash "$here/fetch.sh" "$to"
headers=$(cd "$to" && pwd)/usr/include
cd "$root"

flags=(-std=c++20 -fsyntax-only -pthread -D_GLIBCXX_USE_CXX11_ABI=1 -w -Isrc -I. -Ibench
  '-DFASTSCENE_SOURCE_DIR=""' -isystem "$headers" -isystem "$headers/torch/csrc/api/include")
nn=src/fastscene/nn
# Headers take nearly all of the time: sources go together, as in the build.
together() { local to=$1; shift; printf '#include "%s"\n' "$@" > "$to"; }
together "$to/versions.cc" $nn/libtorch.cc $nn/replay.cc $nn/fused.cc $nn/process_group.cc
together "$to/gloo.cc" $nn/process_group.cc $nn/rendezvous.cc
sources=("$to/versions.cc")
if [ "$which" = all ]; then
  # As the build does: common headers are read once.
  { echo '#include <ATen/ATen.h>'; echo '#include <nlohmann/json.hpp>'; } > "$to/common.h"
  "$cxx" "${flags[@]/-fsyntax-only/-xc++-header}" "$to/common.h" -o "$to/common.h.gch"
  flags+=(-include "$to/common.h")
  rm -f "$to"/together_*.cc
  ls $nn/*.cc | grep -v _test.cc | split -l 6 - "$to/together_a"
  ls $nn/*_test.cc | split -l 6 - "$to/together_b"
  grep -lE '<(ATen|c10|torch)/' bench/*.cc | split -l 1 - "$to/together_c"
  for list in "$to"/together_*; do
    together "$list.cc" $(< "$list")
    rm "$list"
  done
  sources=("$to"/together_*.cc)
fi
# What official builds lack, Debian's has: both.
has_gloo=
[ ! -e /usr/include/gloo/transport/tcp/device.h ] || has_gloo=1

export CXX_OF_CHECK=$cxx
check() {
  "$CXX_OF_CHECK" "$@" || { echo "libtorch 2.x: FAILED: ${*: -1}"; return 1; }
}
export -f check
status=0
with_gloo=
[ -z "$has_gloo" ] || { check "${flags[@]}" -DUSE_C10D_GLOO "$to/gloo.cc" & with_gloo=$!; }
printf '%s\0' "${sources[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c 'check "$@"' - "${flags[@]}" {} || status=1
[ -z "$with_gloo" ] || wait "$with_gloo" || status=1
# The parts for CUDA need its toolkit's headers, and one that only CUDA builds of libtorch have.
cuda=${CUDA_HOME:-/usr/local/cuda}/include
if [ -e "$cuda/cuda_runtime_api.h" ]; then
  mkdir -p "$to/cuda/c10/cuda/impl"
  echo '#define C10_CUDA_BUILD_SHARED_LIBS' > "$to/cuda/c10/cuda/impl/cuda_cmake_macros.h"
  for source in $nn/libtorch.cc $nn/replay.cc $nn/fused.cc; do
    check "${flags[@]}" -DFASTSCENE_CUDA -DFASTSCENE_KERNELS -isystem "$to/cuda" -isystem "$cuda" $source || status=1
  done
fi
version=$(sed -nE 's/^#define TORCH_VERSION_(MAJOR|MINOR) +([0-9]+)$/\2/p' "$headers"/torch/csrc/api/include/torch/version.h | paste -sd.)
echo "libtorch $version: exit code $status"
exit "$status"
