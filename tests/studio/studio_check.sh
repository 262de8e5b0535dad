#!/usr/bin/env bash
# From a sentence to walking, in the studio's pages.   studio_check.sh FASTSCENE WEB_DIR OUT_DIR
# What is not installed is said to be skipped.
set -euo pipefail
fastscene=$1 web=$2 out=$3
here=$(cd "$(dirname "$0")" && pwd)
chromium=${CHROMIUM:-/usr/bin/chromium}
command -v node >/dev/null || { echo "studio: skipped (node is not installed)"; exit 77; }
if [ -f "$web/node_modules/typescript/bin/tsc" ]; then node "$web/node_modules/typescript/bin/tsc" -p "$web/studio"; fi
pages=$(dirname "$fastscene")/../share/fastscene/studio/index.html
[ -f "$pages" ] || { echo "studio: skipped (its pages were not built: the npm packages of web/ are missing)"; exit 77; }
[ -d "$web/node_modules/playwright-core" ] && [ -x "$chromium" ] || { echo "studio: skipped (no Chromium)"; exit 77; }
rm -rf "$out" && mkdir -p "$out"
exec node "$here/studio_check.mjs" "$fastscene" "$web" "$out"
