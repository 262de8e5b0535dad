# An edited scene begins from the run before, and is the same however often it is made.
. "$(dirname "$0")/lib.sh"

# Enough pixels that something of the picture stays, and cells fine enough for sun patches.
small=("${tiny[@]}" --panorama-width 256 --panorama-cell 0.15 --views-size 64)
expect 0 "$fastscene" make "$prompt" -o one "${small[@]}"
has one/panorama/light.bin
# about STAGE KEY: what a stage of the edited run says of itself.
about() { python3 -c "import json, sys; print(json.load(open('two/$1/stage.json'))['about']['$2'])"; }
over() { python3 -c "import sys; sys.exit(not float('$1') > $2)" || fail "$3: $1, expected more than $2"; }

expect 0 "$fastscene" edit one "remove the armchair" -o two
says "begins from the"
prints "armchair-1: removed"
over "$(about panorama kept_light)" 0.3 "light kept"
over "$(about panorama kept_pixels)" 0.5 "pixels kept"
over "$(($(ls -d two/walk/0* | wc -l) - 1))" "$(about walk rendered_panoramas)" "viewpoints, all of them rendered whole"
grep -q '"edited_from"' two/run.json || fail "run.json does not say what it is an edit of"
! grep -q '"class": "armchair"' two/panorama/room.json || fail "the armchair is still there"
has two/{report.json,preview.jpg} two/splat/scene.ply
# What the edit did not change is the very picture of before.
python3 - one/panorama/color.png two/panorama/color.png <<'PYTHON' || fail "too many pixels differ"
import subprocess, sys
pixels = [subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                         stdout=subprocess.PIPE, check=True).stdout for name in sys.argv[1:]]
same = sum(a == b for a, b in zip(*pixels)) / len(pixels[0])
sys.exit(not 0.5 < same < 1)
PYTHON

# The same bytes for any number of threads, and nothing is made twice.
expect 0 "$fastscene" edit one "remove the armchair" -o single --threads 1
same two single
expect 0 "$fastscene" edit one "remove the armchair" -o two
says "splat: already made"

# Its light is kept, too: an edit of an edit.
expect 0 "$fastscene" edit two "remove the clock" -o three --plan-only
python3 -c "import json, sys; sys.exit(not json.load(open('three/panorama/stage.json'))['about']['kept_light'] > 0)" ||
  fail "the edit of an edit kept no light"

# In place: as elsewhere, and what else is in the folder stays.
cp -r one place && echo mine >place/notes.txt
expect 0 "$fastscene" edit place "remove the armchair" --in-place
has place/notes.txt && rm place/notes.txt
lacks place/.edit.unfinished
same two place
# An edit in place that was interrupted: another one starts over; once complete, it only has to be moved.
expect 2 "$fastscene" edit place "remove the bed" --in-place --plan-only
says "--plan-only"
# The sentence alone is no scene, whatever the document says.
expect 2 "$fastscene" edit --room place.json "remove the bed"
says '--room: expected beside the folder of a run, found "remove the bed"'
cp -r two half && cp -r three half/.edit.unfinished
expect 0 "$fastscene" edit half "remove the dresser" --in-place
lacks half/.edit.unfinished
cp -r one late && cp -r two late/.edit.unfinished
python3 - late/.edit.unfinished <<'PYTHON'
import json, os, sys
names = [n for n in os.listdir(sys.argv[1]) if not n.startswith(".")]
json.dump({"command": "something else", "names": names}, open(sys.argv[1] + "/complete.json", "w"))
PYTHON
rm -r late/panorama && mv late/.edit.unfinished/panorama late/panorama  # as far as it came
expect 0 "$fastscene" splat late
lacks late/.edit.unfinished
same two late
# Not by accident.
expect 2 "$fastscene" edit one "remove the armchair" -o one/
says "--in-place"

# Other light everywhere: nothing can be kept, which is said.
expect 0 "$fastscene" edit one --time night -o night --plan-only
says "the scene is made without it: the edit changes lamps, windows or the outside"

# The run before may be gone, or its light damaged: then all is made, and that is said.
rm -r two/walk two/views two/splat && mv one elsewhere
expect 0 "$fastscene" splat two
says "it no longer exists"
has two/splat/scene.ply
mv elsewhere one && head -c 5000 one/panorama/light.bin >cut && mv cut one/panorama/light.bin
expect 0 "$fastscene" render one --of room --size 32x32 -o still.png
says "the light is gathered again"
has still.png
