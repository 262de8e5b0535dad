#!/usr/bin/env bash
# Every example of examples/python does what it says.     examples.sh PYTHON SOURCE_DIR WORK_FOLDER
set -euo pipefail
python=$1 examples=$2/examples/python work=$3
rm -rf "$work" && mkdir -p "$work" && cd "$work"
fail() { echo "FAILED: $*" >&2; exit 1; }
ran=
# run NAME ARGUMENT…
run() { local name=$1; shift; ran="$ran $name"; "$python" "$examples/$name.py" "$@" >"$name.txt" || fail "$name"; }
says() { grep -q "$2" "$1.txt" || fail "$1: expected \"$2\", found: $(cat "$1.txt")"; }
run read_prompt; says read_prompt "zorblax: not understood"; says read_prompt "armchair: object: armchair, color red"
run plan_room room.json; says plan_room "green"; grep -q '"things"' room.json || fail "room.json"
run trace_panorama all.jpg; grep -q GPano all.jpg || fail "all.jpg is not marked"
run trace_views view.png; says trace_views "yaw 240"
run train_splats box.ply; says train_splats "step 150 of 150"
run train_on_room room.spz; says train_on_room "PSNR [12]"
run render_splats box.ply pictures; [ -s pictures/02.png ] && [ -s pictures/sphere.jpg ] || fail "pictures"
run edit_splats box.ply half.spz; [ -s half.spz ] || fail "half.spz"
run measure; says measure "refused: expected pictures of one size"
run make_scene scene 2>/dev/null; says make_scene "a tour of"; [ -s scene/tour.chan ] || fail "tour.chan"
for file in "$examples"/*.py; do
  case " $ran " in *" $(basename "$file" .py) "*) ;; *) fail "$file is not run" ;; esac
done
