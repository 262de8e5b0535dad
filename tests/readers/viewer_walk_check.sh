#!/usr/bin/env bash
# Holds the visitor of viewer.html to the walkable area: the script by itself (node), then the page (Chromium).
#   viewer_walk_check.sh MAKE_READER_SAMPLES WEB_DIR OUT_DIR
# What is not installed is said to be skipped; without node the whole check is skipped (77).
set -euo pipefail
make=$1 web=$2 out=$3
here=$(cd "$(dirname "$0")" && pwd)
command -v node >/dev/null || { echo "walk: skipped (node is not installed)"; exit 77; }
node --test "$here/walk_bounds_test.mjs"

viewer=$web/node_modules/@playcanvas/supersplat-viewer/public
chromium=${CHROMIUM:-/usr/bin/chromium}
if [ -f "$viewer/index.html" ] && [ -d "$web/node_modules/playwright-core" ] && [ -x "$chromium" ]; then
  rm -rf "$out" && mkdir -p "$out"
  "$make" "$out" "$viewer"
  node "$here/viewer_walk_check.mjs" "$web" "$out/walk.html" "$out"
else
  echo "walk: the page was not opened (chromium or the npm packages are not installed)"
fi
