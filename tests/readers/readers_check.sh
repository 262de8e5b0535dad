#!/usr/bin/env bash
# Asks programs that are not ours to read what we write.
#   readers_check.sh MAKE_READER_SAMPLES WEB_DIR OUT_DIR FASTSCENE
# A program that is not installed is said to be skipped; when none is there the whole check is skipped (77).
set -euo pipefail
make=$1 web=$2 out=$3 fastscene=$4
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out"
viewer=$web/node_modules/@playcanvas/supersplat-viewer/public
asked=0
if [ -f "$viewer/index.html" ]; then "$make" "$out" "$viewer"; else "$make" "$out"; fi

if command -v colmap >/dev/null; then
  asked=1
  # model_analyzer takes the binary model when both are there; the text one is converted to binary and compared.
  QT_QPA_PLATFORM=offscreen colmap model_analyzer --path "$out/views/sparse/0" >"$out/colmap.log" 2>&1 || { cat "$out/colmap.log"; exit 1; }
  grep -Eq 'Cameras: 2' "$out/colmap.log" && grep -Eq 'Images: 3' "$out/colmap.log" && grep -Eq 'Points: 18000' "$out/colmap.log" ||
    { echo "colmap: expected 2 cameras, 3 images, 18000 points"; cat "$out/colmap.log"; exit 1; }
  mkdir -p "$out/text" "$out/again"
  cp "$out"/views/sparse/0/*.txt "$out/text/"
  QT_QPA_PLATFORM=offscreen colmap model_converter --input_path "$out/text" --output_path "$out/again" --output_type BIN >"$out/colmap_text.log" 2>&1 ||
    { cat "$out/colmap_text.log"; exit 1; }
  for part in cameras images; do
    [ "$(stat -c %s "$out/again/$part.bin")" = "$(stat -c %s "$out/views/sparse/0/$part.bin")" ] || { echo "colmap: $part.txt differs from $part.bin"; exit 1; }
  done
  echo "colmap: reads the binary and the text model"
else
  echo "colmap: skipped (not installed)"
fi

transform=$web/node_modules/@playcanvas/splat-transform/bin/cli.mjs
if command -v node >/dev/null && [ -f "$transform" ] && node "$transform" --version >/dev/null 2>&1; then
  asked=1
  for name in room.ply room.compressed.ply; do
    node "$transform" -w "$out/$name" "$out/again.ply" >"$out/transform.log" 2>&1 || { cat "$out/transform.log"; exit 1; }
    head -c 400 "$out/again.ply" | grep -aq 'element vertex 18000' || { echo "splat-transform: expected 18000 splats of $name"; exit 1; }
    echo "splat-transform: reads $name"
  done
  # What we wrote, read by it; what it wrote, read by us: the same splats as odd.ply, colors from every side too.
  theirs() { node "$transform" -w -g cpu "$@" >"$out/transform.log" 2>&1 || { cat "$out/transform.log"; exit 1; }; }
  ours() { "$fastscene" convert "$@" --progress none >"$out/convert.log" 2>&1 || { cat "$out/convert.log"; exit 1; }; }
  same() { node "$here/same_splats.mjs" "$out/odd.ply" "$1" "$2" || exit 1; }
  for name in odd.compressed.ply odd3.spz odd4.spz odd2.spz; do
    theirs "$out/$name" "$out/theirs.ply"
    same "$out/theirs.ply" "splat-transform reads our $name"
    ours "$out/$name" "$out/ours.ply"
    same "$out/ours.ply" "we read our $name"
  done
  for name in their.compressed.ply their3.spz their4.spz their.glb their.sog; do
    if [ "$name" = their3.spz ]; then theirs --spz-version 3 "$out/odd.ply" "$out/$name"; else theirs "$out/odd.ply" "$out/$name"; fi
    ours "$out/$name" "$out/ours.ply"
    same "$out/ours.ply" "we read splat-transform's $name"
  done
  ours "$out/odd.ply" "$out/odd.sog"
  theirs "$out/odd.sog" "$out/theirs.ply"
  same "$out/theirs.ply" "splat-transform reads our odd.sog"
  # It does not read glTF: ours must hold the numbers that its own file holds.
  node "$here/same_glb.mjs" "$out/odd.glb" "$out/their.glb"
else
  echo "splat-transform: skipped (not installed)"
fi

if command -v node >/dev/null && [ -d "$web/node_modules/gltf-validator" ]; then
  asked=1
  node "$here/gltf_check.mjs" "$web" "$out"/*.room.glb "$out"/*.collision.glb "$out"/*.meshopt.glb
else
  echo "gltf-validator: skipped (not installed)"
fi

if command -v node >/dev/null && [ -d "$web/node_modules/tinyusdz" ]; then
  asked=1
  rooms=()
  for room in bedroom bathroom attic; do rooms+=("$out/$room.room.usda" "$out/$room.room.glb"); done
  node "$here/usd_check.mjs" "$web" "$out/odd.usda" 300 "${rooms[@]}"
else
  echo "tinyusdz: skipped (not installed)"
fi

if command -v node >/dev/null && [ -d "$web/node_modules/three" ] && [ -d "$web/node_modules/playwright-core" ] && [ -x "${CHROMIUM:-/usr/bin/chromium}" ]; then
  asked=1
  for glb in bedroom.room.glb bedroom.meshopt.glb; do
    node "$here/three_check.mjs" "$web" "$out/$glb" "$out/bedroom.instances.png" "$out/bedroom.instances.json" "$out/three.png"
  done
else
  echo "three.js: skipped (chromium or the npm packages are not installed)"
fi

if command -v node >/dev/null && [ -f "$out/viewer.html" ] && [ -d "$web/node_modules/playwright-core" ] && [ -x "${CHROMIUM:-/usr/bin/chromium}" ]; then
  asked=1
  node "$here/viewer_check.mjs" "$web" "$out/viewer.html" "$out/viewer.png"
else
  echo "viewer: skipped (chromium or the npm packages are not installed)"
fi
[ $asked = 1 ] || exit 77
