# The walks: ours, the published one and its ablations; the table of holes; resume between them.
. "$(dirname "$0")/lib.sh"

expect 0 "$fastscene" make "$prompt" -o run "${tiny[@]}"
grep -q '"kind": "room"' run/walk/stage.json || fail "stage.json does not say how was walked"
grep -q '"unseen_share"' run/walk/stage.json || fail "stage.json does not say what the viewpoints leave unseen"
has run/walk/walkable.json
grep -q '"polygon_m"' run/report.json || fail "report.json does not say where one may walk"
in_room=$(ls run/walk | wc -l)
# Everything in a viewpoint's panorama was looked at, and the same room lit again gives the same bytes.
cp run/walk/001/color.png first_color.png
cp run/walk/poses.json first_poses.json
expect 0 "$fastscene" walk run --walk ours
ours=$(ls run/walk | wc -l)
expect 0 "$fastscene" walk run --walk room
[ "$(ls run/walk | wc -l)" = "$in_room" ] || fail "the walk through the room is not what it was"
cmp run/walk/poses.json first_poses.json || fail "the viewpoints are not what they were"
cmp run/walk/001/color.png first_color.png || fail "a room that was made again is another one"

# Another walk in the same folder: panorama and depth stay, the walk is made anew, and back again.
before=$(stat -c %Y%i run/panorama/color.png)
expect 0 "$fastscene" walk run --walk paper --walk-steps 2
[ "$before" = "$(stat -c %Y%i run/panorama/color.png)" ] || fail "the panorama was made again"
has run/walk/016/color.png run/walk/016/range.exr run/walk/016/known.png
lacks run/walk/017
grep -q 'stands in' run/walk/stage.json || fail "stage.json does not say what stands in for the estimator"
expect 0 "$fastscene" walk run --walk paper --walk-steps 2
says "walk: already made"
expect 0 "$fastscene" walk run --walk paper-direct --walk-steps 1
has run/walk/008/color.png
expect 0 "$fastscene" walk run --walk paper-far
has run/walk/008/color.png
lacks run/walk/009
# The settings stay those of the run until a flag changes them; the rest of the stream takes any walk.
expect 0 "$fastscene" splat run
has run/splat/scene.ply
expect 0 "$fastscene" walk run --walk ours
[ "$(ls run/walk | wc -l)" = "$ours" ] || fail "our walk is not what it was"
expect 2 "$fastscene" walk run --walk papre
says "--walk: expected one of auto, room, ours, paper, paper-direct, paper-far"
expect 2 "$fastscene" walk run --walk-step 0
expect 2 "$fastscene" walk run --walk-step nan
# Steps that are too long are clipped, and it is said.
expect 0 "$fastscene" walk run --walk paper --walk-step 0.4 --walk-steps 2
says "would leave the room"
grep -q '"reached_m"' run/walk/stage.json || fail "stage.json does not say what was clipped"

# Holes that the room itself fills: lit again it is the room that the panorama was shot in.
expect 0 "$fastscene" walk run --walk ours --walk-inpainter room
expect 0 "$fastscene" make "$prompt" -o looked "${tiny[@]}" --walk-inpainter room
cmp run/walk/001/color.png looked/walk/001/color.png || fail "a room that was made again is another one"
expect 2 "$fastscene" walk run --walk paper --walk-inpainter room
says "--walk-inpainter room: expected --walk ours"
expect 2 "$fastscene" make --panorama run/panorama/color.png --range run/depth/range.exr -o pictured "${tiny[@]}" --walk room
says "--walk room: expected a prompt"
expect 2 "$fastscene" make --panorama run/panorama/color.png --range run/depth/range.exr -o pictured "${tiny[@]}" --walk-inpainter room
says "behind which there is no room"
lacks pictured
expect 0 "$fastscene" walk run --walk ours --walk-inpainter aotgan

# The table of holes.
expect 0 "$fastscene" walk table run
prints "published"
expect 0 "$fastscene" walk table run --truth -o table
has table/hole_table.txt table/hole_table.json table/hole_table.svg
grep -q precision table/hole_table.json || fail "no truth in the table"
expect 0 "$fastscene" walk table --panorama run/panorama/color.png --range run/depth/range.exr --json
prints '"axis": "x"'
expect 2 "$fastscene" walk table
expect 2 "$fastscene" walk table run --panorama run/panorama/color.png
expect 2 "$fastscene" walk table --panorama run/panorama/color.png --range run/depth/range.exr --truth
expect 1 "$fastscene" walk table --panorama run/panorama/color.png --range nowhere.exr
says nowhere.exr
# A place that cannot be written to is noticed before the work; settings of the walk change no table.
echo mine > taken
expect 1 "$fastscene" walk table run -o taken
says "taken: cannot make this directory"
mkdir -p half/hole_table.svg
expect 1 "$fastscene" walk table run -o half
says "half/hole_table.svg: cannot be written"
lacks half/hole_table.txt
expect 2 "$fastscene" walk table run --walk paper
says "--walk: expected with the walk itself"
expect 2 "$fastscene" walk
