#!/usr/bin/env bash
# Installs the build to an empty folder, builds examples/ against it with find_package alone, and runs them.
#   install.sh BUILD_DIR SOURCE_DIR WORK_DIR
set -euo pipefail
build=$1 source=$2 work=$3
fail() { echo "install: $*" >&2; exit 1; }
rm -rf "$work"
mkdir -p "$work"
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >"$work/install.log" 2>&1 || { tail -n 30 "$work/install.log" >&2; fail "cmake --install failed"; }
[ -z "$(find "$prefix/include" -name '*_test.*' -o -name 'test_*')" ] || fail "headers of tests were installed"
# The splat library is free of Embree and libtorch.
if grep -qE 'embree|torch' "$prefix"/lib/*/cmake/fastscene/fastscene-splat-targets*.cmake "$prefix"/lib/cmake/fastscene/fastscene-splat-targets*.cmake 2>/dev/null; then
  fail "fastscene::splat links Embree or libtorch"
fi

cp -r "$source/examples" "$work/examples"
cmake -S "$work/examples" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" >"$work/configure.log" 2>&1 ||
  { tail -n 30 "$work/configure.log" >&2; fail "the examples were not configured"; }
cmake --build "$work/build" >"$work/build.log" 2>&1 || { tail -n 40 "$work/build.log" >&2; fail "the examples were not built"; }

cd "$work"
out=$(./build/train_splats trained.ply)
echo "$out"
psnr=$(sed -E 's/.*PSNR ([0-9]+).*/\1/' <<<"$out")
[ "$psnr" -ge 25 ] || fail "train_splats: expected a PSNR of at least 25 dB, found $psnr"
[ "$(./build/convert_splats trained.ply few.spz 1000)" = "1000 splats" ] || fail "convert_splats: expected 1000 splats"
./build/render_splats few.spz still.png sphere.png 30
if ./build/convert_splats none.ply out.spz 2>error.txt; then fail "convert_splats took a file that is not there"; fi
grep -q none.ply error.txt || fail "convert_splats: the error does not name the file"
./build/room_picture "a small study with a green armchair" room.png 128 | tee said.txt
grep -q armchair said.txt || fail "room_picture: no armchair"
for picture in still sphere room; do [ -s "$picture.png" ] || fail "$picture.png is not there"; done
if [ -x build/make_scene ]; then
  scene=$(./build/make_scene "a bedroom" scene 2>progress.txt)
  [ -s "$scene" ] || fail "make_scene: no scene"
fi
