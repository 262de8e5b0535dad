#!/usr/bin/env bash
# Asks Blender to read furnished rooms and to render them with its own path tracer.
#   blender_check.sh MAKE_READER_SAMPLES OUT_DIR
# Skipped (77) where Blender is not installed.
set -euo pipefail
make=$1 out=$2
here=$(cd "$(dirname "$0")" && pwd)
command -v blender >/dev/null || { echo "blender: skipped (not installed)"; exit 77; }
rm -rf "$out" && mkdir -p "$out"
"$make" "$out"
for room in bedroom bathroom attic; do
  # One thread: other tests run beside this one.
  blender --background --factory-startup -t 1 --python-exit-code 1 --python "$here/blender_check.py" -- \
    "$out/$room" "$out/$room.blender.png" >"$out/$room.log" 2>&1 </dev/null || { cat "$out/$room.log"; exit 1; }
  grep '^blender ' "$out/$room.log"
done
