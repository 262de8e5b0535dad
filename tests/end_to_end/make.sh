# The main job: every file of the contract, the same bytes for any number of threads, and from a picture too.
. "$(dirname "$0")/lib.sh"

expect 0 "$fastscene" make "$prompt" -o one "${tiny[@]}"
[ "$(cat out)" = one ] || fail "stdout is \"$(cat out)\", expected the folder"
has one/{run.json,report.json,preview.jpg,credits.txt} one/panorama/{color.png,prompt.json,room.json,stage.json} \
  one/depth/range.exr one/walk/poses.json one/walk/00{0,1,2}/{color.png,range.exr,known.png} \
  one/views/transforms.json one/views/sparse/0/{cameras,images,points3D}.{txt,bin} one/splat/{scene.ply,scene.compressed.ply,curve.json,stage.json}
[ "$(ls one/views/images | wc -l)" -ge 18 ] || fail "too few views"
grep -q '"class": "armchair"' one/panorama/room.json || fail "no armchair in room.json"
grep -q '"prompt": "a cozy bedroom' one/run.json || fail "no prompt in run.json"
grep -q '"peak_memory_bytes"' one/report.json || fail "no memory in report.json"
head -c 3000 one/splat/scene.ply | grep -ac '^property float' | grep -qx 62 || fail "scene.ply has not 62 floats a vertex"
if [ -e one/viewer.html ]; then
  ! grep -qE '(src|href)="https?:' one/viewer.html || fail "viewer.html refers to the network"
else
  says "npm ci"  # the log still holds the warning with the remedy
fi
no_rest one

# The same bytes with one thread, with two, and another scene with another seed.
expect 0 "$fastscene" make "$prompt" -o single "${tiny[@]}" --threads 1 --progress none
expect 0 "$fastscene" make "$prompt" -o double "${tiny[@]}" --threads 2 --progress json
grep -q '"event":"progress"' log || fail "--progress json shows none"
same one single
same one double
# Its room has no mirror, through which the walk of a known room looks further than that of its picture.
expect 0 "$fastscene" make "$prompt" -o other --seed 12 "${tiny[@]}"
! cmp -s one/panorama/color.png other/panorama/color.png || fail "another seed made the same room"

# The second time nothing is made again; JSON goes to stdout alone.
before=$(stat -c %Y.%Z one/splat/scene.ply)
expect 0 "$fastscene" make "$prompt" -o one "${tiny[@]}" --json
says "splat: already made"
prints '"cpu_seconds"'
[ "$before" = "$(stat -c %Y.%Z one/splat/scene.ply)" ] || fail "a finished stage was made again"

# Another setting of a later stage leaves the earlier ones alone.
before=$(stat -c %Y.%Z one/walk/poses.json)
expect 0 "$fastscene" make "$prompt" -o one "${tiny[@]}" --splat-steps 5
[ "$before" = "$(stat -c %Y.%Z one/walk/poses.json)" ] || fail "the walk was made again for a setting of the splats"
grep -q '"step": 20' one/splat/curve.json && fail "the splats were not made again"

# The default folder is named after the prompt.
mkdir elsewhere
(cd elsewhere && "$fastscene" panorama "A bright Kitchen!" "${tiny[@]:0:10}" >../printed 2>../log) || fail "panorama with a default folder"
[ "$(cat printed)" = out/a-bright-kitchen/panorama ] || fail "printed \"$(cat printed)\""
has elsewhere/out/a-bright-kitchen/panorama/color.png
lacks elsewhere/out/a-bright-kitchen/depth

# The user's own picture with its range map: here the ones just made.
expect 0 "$fastscene" make --panorama other/panorama/color.png --range other/depth/range.exr -o picture --seed 12 "${tiny[@]}"
cmp -s other/panorama/color.png picture/panorama/color.png || same_pixels=no
has picture/{preview.jpg,credits.txt} picture/panorama/{color.png,prompt.json,room.json} picture/splat/scene.ply
[ "${same_pixels:-yes}" = yes ] || fail "the picture came out changed"
# Around the first panorama the walk of the room's is that of its picture.
expect 0 "$fastscene" walk other --walk ours
same_walk() { cmp -s "other/walk/$1" "picture/walk/$1" || fail "walk/$1 differs between the room and its picture"; }
same_walk 002/color.png
same_walk 002/range.exr

# Threads that wait sleep, however the program was started (libgomp says how it was set when it loads).
(unset OMP_WAIT_POLICY; OMP_DISPLAY_ENV=true "$fastscene" depth picture --depth-backend egformer >printed 2>log) || fail "without OMP_WAIT_POLICY"
grep -qi "OMP_WAIT_POLICY = 'PASSIVE'" log || fail "waiting threads spin"

# And with a second one beside it, which is observed as it came.
echo "{\"panoramas\": [{\"color\": \"$PWD/other/walk/001/color.png\", \"range\": \"$PWD/other/walk/001/range.exr\", \"position\": [0.3, 0, 0.2]}]}" >more.json
expect 0 "$fastscene" panorama --panorama other/panorama/color.png --range other/depth/range.exr --more more.json -o several --seed 12 "${tiny[@]:0:10}"
expect 0 "$fastscene" walk several --walk-viewpoints 2
has several/walk/00{0,1,2,3}/color.png
lacks several/walk/004
cmp -s other/walk/001/color.png several/walk/001/color.png || fail "the second panorama came out changed"
grep -q '"scaled_to_agree_by"' several/depth/stage.json && fail "the second range map was not taken"
sed -i 's/"range": "[^"]*", //' more.json
expect 0 "$fastscene" panorama --panorama other/panorama/color.png --more more.json -o several --seed 12 --force "${tiny[@]:0:10}"
expect 0 "$fastscene" depth several
grep -q '"scaled_to_agree_by"' several/depth/stage.json || fail "the second range was not made to agree"

# Each further panorama is looked at as the first is, and told of by its file; how its range came about stands beside it, here where the first has a map.
half() { local i; for i in $(seq 96); do printf "$1"; done; }   # 32 pixels
{ printf 'PF\n64 32\n-1.0\n'; for i in $(seq 32); do half '\0\0\200\076'; half '\0\0\200\077'; done; } >photo.pfm
echo '{"panoramas": [{"color": "photo.pfm", "position": [0.3, -0.4, 0.2]}, {"color": "other/walk/001/color.png", "position": [0, 1.5, 0]}]}' >more.json
expect 0 "$fastscene" panorama --panorama other/panorama/color.png --range other/depth/range.exr --more more.json -o mixed --seed 12 "${tiny[@]:0:10}"
says "photo.pfm: the left and the right edge do not meet"
says "photo.pfm: no range: estimated from the picture, the camera 2 m above the floor"
says "other/walk/001/color.png: expected a position above the floor, which is 1.6 m below the first camera, found 1.5 m below it"
expect 0 "$fastscene" depth mixed --depth-tta 1
expect 2 "$fastscene" export mixed mixed.svg
says "mixed: expected a scene from a prompt, found one from a picture, which has no known room"
lacks mixed.svg
expect 1 "$fastscene" export mixed mixed.glb
says "mixed: its panoramas are not made yet: run \`fastscene walk mixed\` first"
lacks mixed.glb
tr -d ' \n' <mixed/depth/stage.json >about
for told in '"about":{"backend":"image"' '"picture":"photo.pfm","backend":"egformer","weights":"egformer-rooms-256,egformer-rooms","tta":1,"camera_height_m":2.0' \
  '"picture":"color.png","backend":"egformer","weights":"egformer-rooms-256,egformer-rooms","tta":1,"camera_height_m":0.2' '"floor_found":' '"walls":['; do
  grep -qF -- "$told" about || fail "depth/stage.json lacks $told"
done
# Weights that only the further panoramas need are missed before the work.
expect 1 "$fastscene" make --panorama other/panorama/color.png --range other/depth/range.exr --more more.json --depth-weights gone.pkl -o gone "${tiny[@]}"
says "gone.pkl"
lacks gone

exit 0
