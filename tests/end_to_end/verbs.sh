# The verbs that look at a finished run.
. "$(dirname "$0")/lib.sh"

expect 0 "$fastscene" make "$prompt" -o run "${tiny[@]}"

# A picture: from the same place the same, from elsewhere another; sizes and names are kept.
expect 0 "$fastscene" render run --size 80x60 -o a.png
expect 0 "$fastscene" render run/splat/scene.ply --size 80x60 -o b.png
cmp -s a.png b.png || fail "the folder and its .ply give other pictures"
expect 0 "$fastscene" render run --size 80x60 --yaw 90 -o c.png
! cmp -s a.png c.png || fail "the camera did not turn"
expect 0 "$fastscene" render run --size 80x60 --position 0.1 -0.1 0.1 --pitch -10 --fov 60 -o d.jpg
has d.jpg
expect 2 "$fastscene" render run --size 80 -o a.png
expect 2 "$fastscene" render run --fov 200 -o a.png
expect 2 "$fastscene" render run -o a.bmp
expect 2 "$fastscene" render .
# Known before the work, not after it; a shorter film does not end in an earlier one's frames.
expect 1 "$fastscene" render run --size 80x60 -o a.png --alpha nowhere/alpha.png
says "nowhere/alpha.png: cannot be written"
expect 1 "$fastscene" convert run nowhere/a.spz
says "nowhere/a.spz: cannot be written"

# All around, with depth and alpha; other programs' cameras; what does not go together.
expect 0 "$fastscene" render run --sphere --size 128x64 -o sphere.png --depth range.exr --alpha alpha.png --background 1 0 1
has sphere.png range.exr alpha.png
expect 0 "$fastscene" render run --size 80x60 -o e.png --depth depth.png
expect 0 "$fastscene" render run --path run/views/transforms.json -o cameras
[ "$(find cameras -name '*.png' | wc -l)" = "$(ls run/views/images | wc -l)" ] || fail "expected a picture a camera"
expect 0 "$fastscene" render run --path run/views/sparse/0 -o cameras2
expect 2 "$fastscene" render run --sphere --size 100x100 -o sphere.png
expect 2 "$fastscene" render run --depth depth.jpg -o e.png
expect 2 "$fastscene" render run --background 2 0 0 -o e.png

# Splats of photographs with cameras, from COLMAP's model and from nerfstudio's file; a finished one is kept. (That both say the same
# cameras is tested in io/: here the last bit of a pose differs, and training makes more of it.)
photos=(--quality draft --splat-count 2000 --splat-steps 20)
expect 0 "$fastscene" splat --colmap run/views -o c "${photos[@]}"
has c/splat/scene.ply c/splat/scene.compressed.ply c/splat/curve.json c/preview.jpg c/report.json c/run.json
expect 0 "$fastscene" splat --nerfstudio run/views/transforms.json -o n "${photos[@]}"
[ "$(stat -c %s c/splat/scene.ply)" = "$(stat -c %s n/splat/scene.ply)" ] || fail "COLMAP's and nerfstudio's cameras give another number of splats"
expect 0 "$fastscene" splat --colmap run/views -o c "${photos[@]}"
says "already made"
expect 0 "$fastscene" splat c --splat-steps 25
expect 0 "$fastscene" splat c --antialias --random-background --steps 26 --eval-every 13 --holdout 4
grep -q '^26,' c/splat/curve.csv || fail "--steps and --eval-every are not --splat-steps and --splat-eval-every"
grep -aq '^comment SplatRenderMode: mip' c/splat/scene.ply || fail "--antialias is not --splat-antialias"
grep -q '"random-background": true' c/run.json || fail "--random-background is not --splat-random-background"
has c/splat/cameras.json c/splat/eval
expect 0 "$fastscene" render c --path c/splat/cameras.json -o again
expect 0 "$fastscene" render c --path run/views -o again2
[ "$(ls again | wc -l)" = "$(ls run/views/images | wc -l)" ] && [ "$(ls again2 | wc -l)" = "$(ls again | wc -l)" ] || fail "not a picture of every camera"
# What would change nothing is refused.
expect 2 "$fastscene" splat --colmap run/views -o p --views-size 64
says "--views-size"
expect 2 "$fastscene" splat c --seed 3
says "--seed"
expect 2 "$fastscene" splat run --max-size 64
expect 2 "$fastscene" splat --colmap run/views -o p --splat-patience 3
says "--splat-eval-every"
expect 2 "$fastscene" render c --path path.json --yaw 3
expect 2 "$fastscene" render c --position nan 0 0
mkdir -p none && expect 1 "$fastscene" splat --colmap run/views -o p --masks none
says "--masks none"
lacks p
mkdir -p text/sparse && cp run/views/sparse/0/*.txt text/sparse && cp -r run/views/images text/
rm -f "text/images/$(ls text/images | head -1)" text/sparse/points3D.txt
expect 0 "$fastscene" splat --colmap text -o t "${photos[@]}" --random-points 3000
says "1 of"
says "no points"
expect 2 "$fastscene" splat --colmap run/views -o n "${photos[@]}"
says "--force"
expect 2 "$fastscene" splat
expect 2 "$fastscene" splat run --colmap run/views
expect 2 "$fastscene" splat --colmap run/views -o p --alpha red
expect 2 "$fastscene" walk c
expect 1 "$fastscene" splat --colmap run/depth -o p
says "sparse/0"
expect 1 "$fastscene" splat --nerfstudio absent.json -o p
says absent.json
lacks p
if command -v colmap >/dev/null; then expect 2 "$fastscene" views run --sfm nobody; says "known, colmap"; fi

# For engines: what is asked for is written, over an earlier file too; what cannot be is said before the work.
expect 0 "$fastscene" export run room.glb --texels-per-metre 16
prints room.glb
[ "$(head -c 4 room.glb)" = glTF ] || fail "room.glb is no glTF binary"
expect 0 "$fastscene" export run room.glb --texture-size 64 --json
prints '"what": "room"'
expect 0 "$fastscene" export run collision.glb --what collision
expect 0 "$fastscene" export run labels.json
expect 0 "$fastscene" export run walkable.json --what walkable
expect 0 "$fastscene" export run plan.svg
has collision.glb labels.json walkable.json plan.svg
grep -q '"class": "armchair"' labels.json || fail "the labels lack the armchair of the prompt"
grep -q spawn_points_m walkable.json || fail "no spawn points"
expect 2 "$fastscene" export run room.fbx
says "room.fbx: expected a name that ends in .glb, .usda, .json, .svg, .ply or .npy"
expect 2 "$fastscene" export run plan.glb --what plan
says "plan.glb: expected a name that ends in .svg"
expect 2 "$fastscene" export run room.glb --texture-size 3
expect 2 "$fastscene" export run room.glb --what scene
expect 1 "$fastscene" export run nowhere/room.glb
says "nowhere/room.glb: cannot be written"
expect 2 "$fastscene" export absent room.glb
expect 2 "$fastscene" export c room.glb
says photographs
expect 0 "$fastscene" export run room.usda --texels-per-metre 16
has room.usda
[ -n "$(ls room_textures)" ] || fail "no textures beside room.usda"
expect 0 "$fastscene" export run lit.glb --baked-light --texels-per-metre 8 --texture-size 512
grep -aq KHR_materials_unlit lit.glb || fail "--baked-light: the materials are lit"
expect 2 "$fastscene" export run collision.glb --what collision --baked-light
says "--baked-light"

# Things on splats and views.
expect 0 "$fastscene" export run labelled.ply
expect 0 "$fastscene" export run scene.labels.npy
has scene.labels.json
grep -aq 'property int instance' labelled.ply || fail "labelled.ply has no labels"
for from in run labelled.ply; do
  expect 0 "$fastscene" splat select -i $from --class floor -o floor.ply
  expect 0 "$fastscene" splat select -i $from --id floor --invert -o rest.spz
done
cp run/splat/scene.ply scene.ply
expect 0 "$fastscene" splat select -i scene.ply --class floor -o floor2.ply
cmp -s floor.ply floor2.ply || fail "labels in the .ply and beside it cut out other splats"
expect 2 "$fastscene" splat select -i run --class flor -o floor.ply
says "did you mean floor?"
expect 2 "$fastscene" splat select -i run -o floor.ply
expect 2 "$fastscene" splat select -i c --class floor -o floor.ply
expect 2 "$fastscene" splat select -i a.glb --class floor -o floor.ply
says "expected labelled splats"
expect 0 "$fastscene" metrics labels run --views 2 --size 64 --json
prints '"class"'
expect 0 "$fastscene" export run labelled --what views --maps depth,instance
[ "$(ls labelled/depth | wc -l)" = "$(ls run/views/images | wc -l)" ] || fail "expected a depth map a view"
[ -d labelled/instance ] && [ ! -e labelled/class ] || fail "--maps depth,instance: expected these and no others"
grep -q depth_file_path labelled/transforms.json || fail "transforms.json does not name the depth maps"
expect 2 "$fastscene" export run labelled --what views --maps dept
expect 2 "$fastscene" export run labelled.zip --what views

# Without a known room: a mesh of what the panoramas show, and a collider; no labels.
expect 0 "$fastscene" make --panorama run/panorama/color.png --range run/depth/range.exr -o photo "${tiny[@]}"
expect 0 "$fastscene" export photo mesh.glb --json
prints '"what": "mesh"'
expect 0 "$fastscene" export photo mesh-collision.glb --what collision
has mesh.glb mesh-collision.glb
[ "$(stat -c %s mesh-collision.glb)" -lt 200000 ] || fail "the collider is large"
expect 2 "$fastscene" export photo labels2.json
says "which has no known room"
expect 2 "$fastscene" splat select -i photo --class sofa -o sofa.ply
says "which has no known room"
expect 0 "$fastscene" export run mesh.glb --what mesh

# A film.
echo '{"fps": 4, "size": [64, 48], "keys": [{"position_m": [0, 0, 0]}, {"time_s": 1, "position_m": [0.1, 0, 0.1], "yaw_deg": 90}]}' >path.json
expect 0 "$fastscene" render run --path path.json -o film
[ "$(ls film | wc -l)" = 5 ] || fail "expected 5 frames"
if command -v ffmpeg >/dev/null; then
  has film.mp4; prints film.mp4
  expect 0 "$fastscene" render run --path path.json -o "a: 100%5d ü.mp4"
  has "a: 100%5d ü.mp4"
fi
sed 's/"time_s": 1/"time_s": 0.25/' path.json >short.json
expect 0 "$fastscene" render run --path short.json -o film
says "frames from 00002.png on belong to an earlier film"
if command -v ffprobe >/dev/null; then
  [ "$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 film.mp4)" = 2 ] || fail "the film goes on in an earlier one's frames"
fi
# Paths of the scene's own, camera files of other programs, spheres and stereo.
small=(--size 64x36 --fps 5)
for kind in tour orbit walkthrough; do
  expect 0 "$fastscene" render run --path $kind "${small[@]}" --write-path $kind.json --path-only
  has $kind.json; lacks run/$kind.mp4
done
expect 0 "$fastscene" render run --path tour.json --write-path tour.chan --path-only
expect 0 "$fastscene" render run --path tour.json --write-path ns.json --path-format nerfstudio --path-only
expect 0 "$fastscene" render run --path tour.chan "${small[@]}" --write-path again.json --path-only
expect 2 "$fastscene" render run --path tour --seconds 0.5
says "--seconds: expected at least"
expect 2 "$fastscene" render run/splat/scene.ply --path tour
says "expected the folder of a run"
expect 2 "$fastscene" render run --stereo vr180
says "--stereo: expected with --sphere"
expect 2 "$fastscene" render run --path-only --path tour
says "--path-only: expected with --write-path"
expect 0 "$fastscene" render run --sphere --size 64x32 -o sphere.jpg
grep -q GPano:ProjectionType sphere.jpg || fail "sphere.jpg is not marked as a panorama"
grep -q GPano:ProjectionType run/panorama/color.png || fail "the run's panorama is not marked as one"
if command -v ffmpeg >/dev/null; then
  # Frames at exactly i / fps; the second try renders nothing that is there already.
  sed 's/"fps": 4/"fps": 29.97/' path.json >television.json
  expect 0 "$fastscene" render run --path television.json -o television.mp4
  lacks television.mp4.frames
  ffprobe -v error -show_entries packet=pts_time -of csv=p=0 television.mp4 | tr -d , | sort -n |
    awk '{ if (($1 - (NR - 1) * 1001 / 30000) ^ 2 > 1e-11) exit 1 } END { exit NR != 31 }' || fail "frame times of television.mp4"
  expect 0 "$fastscene" render run --path path.json -o film.webm --keep-frames
  has film.webm film.webm.frames/00004.png
  sphere=(--sphere --size 64x32 --path short.json)
  expect 0 "$fastscene" render run "${sphere[@]}" -o sphere.mp4
  ffprobe -v error -show_streams sphere.mp4 >log; says "side_data_type=Spherical Mapping"; says "projection=equirectangular"
  expect 0 "$fastscene" render run "${sphere[@]}" --stereo top-bottom -o both.mp4
  ffprobe -v error -show_streams both.mp4 >log; says "type=top and bottom"; says "height=64"
  expect 0 "$fastscene" render run "${sphere[@]}" --stereo vr180 -o vr180.mp4
  ffprobe -v error -show_streams vr180.mp4 >log; says "type=side by side"; says "tiled equirectangular"
  expect 0 "$fastscene" render run "${sphere[@]}" --stereo top-bottom -o both.webm
  ffprobe -v error -show_streams both.webm >log; says "type=top and bottom"; says "projection=equirectangular"
  expect 0 "$fastscene" render run --of room --samples 16 "${sphere[@]}" --stereo top-bottom -o traced.mp4
  has traced.mp4
  expect 1 env PATH=/nowhere "$fastscene" render run --path path.json -o none.mp4
  says "expected ffmpeg on PATH"
fi
echo '{"keys": []}' >bad.json
expect 1 "$fastscene" render run --path bad.json -o film
says bad.json

# Splat files: every format and back gives nearly the same picture; what cannot be done is said and nothing is written.
for name in a.spz a.glb a.compressed.ply a.sog a.splat b.ply; do
  expect 0 "$fastscene" convert run "$name"
  prints "$name"
  case $name in  # the run trains with a low-pass of its own
    *.spz | *.splat) says "cannot store the low-pass of 0.1 square pixels" ;;
    *) grep -q low-pass log && fail "$name: the low-pass is not kept" ;;
  esac
  expect 0 "$fastscene" render "$name" --size 80x60 -o of.png
  has of.png
done
cmp -s a.png of.png || fail "b.ply gives another picture than the run"
cmp -s b.ply run/splat/scene.ply || fail "PLY to PLY changed something"
expect 0 "$fastscene" convert a.spz c.ply --up z --scale 100 --max-splats 500 --sh-degree 0 --compact --json
prints '"splats": 500'
[ "$(head -c 300 c.ply | grep -ac 'f_rest')" = 0 ] || fail "--compact wrote bands"
expect 0 "$fastscene" convert c.ply d.spz --from-up z --scale 0.01 --spz-version 4
expect 1 "$fastscene" convert run none.ply --crop 900 900 900 901 901 901
lacks none.ply
expect 2 "$fastscene" convert run none.ply --crop 1 1 1 0 0 0
expect 2 "$fastscene" convert run none.xyz
says ".compressed.ply"
expect 2 "$fastscene" convert run none.ply --handed left
cp run/splat/scene.ply before.ply; cp a.spz before.spz; ln -s run linked
for target in run/splat/scene.ply linked/splat/scene.ply run/splat/scene.compressed.ply; do
  expect 2 "$fastscene" convert run "$target" --max-splats 5
  says "$target: expected"
done
expect 2 "$fastscene" convert a.spz a.spz --max-splats 5
says "a.spz: expected an output file different from the input"
expect 2 "$fastscene" convert a.spz run/splat/scene.ply
cmp -s before.ply run/splat/scene.ply && cmp -s before.spz a.spz || fail "convert wrote over what it read"
expect 1 "$fastscene" convert absent.spz none.ply
says absent.spz
expect 1 "$fastscene" convert a.png none.ply
says a.png
head -c 3000 a.spz >short.spz
expect 1 "$fastscene" convert short.spz none.ply
says "short.spz: byte"
lacks none.ply none.xyz

# The server on 127.0.0.1: says where it is, serves the splats whole and in part, ends on SIGTERM.
"$fastscene" view run --port 0 >out 2>log &
pid=$!
for i in $(seq 100); do grep -q http out && break; sleep 0.1; done
address=$(cat out)
get() { # PATH FILE [RANGE [HOST [ORIGIN]]]: a bare HTTP client, in case there is no curl
  local port=${address##*:}; port=${port%/}
  exec 3<>"/dev/tcp/127.0.0.1/$port" || fail "no server at $address"
  printf 'GET %s HTTP/1.1\r\nHost: %s\r\nConnection: close\r\n%s%s\r\n' "$1" "${4:-localhost}" "${3:+Range: bytes=$3$'\r\n'}" "${5:+Origin: $5$'\r\n'}" >&3
  cat <&3 >"$2"; exec 3<&-
}
get /splat/scene.compressed.ply whole
head -1 whole | grep -q ' 200 ' || fail "the server said: $(head -1 whole)"
tail -c "$(stat -c %s run/splat/scene.compressed.ply)" whole | cmp -s - run/splat/scene.compressed.ply || fail "the server changed the splats"
get /splat/scene.compressed.ply part 0-9
head -1 part | grep -q ' 206 ' || fail "the server said to a range: $(head -1 part)"
get / page
head -1 page | grep -qE ' (200|302) ' || fail "the server said: $(head -1 page)"
if [ -f run/viewer.html ]; then
  touch run/viewer.html
  get / page
  grep -q '^Location: /viewer.html' page || fail "the server opens not the run's own page, which bounds the walk"
fi
get /../../../../etc/passwd outside
head -1 outside | grep -qE ' 40[0-9] ' || fail "the server left its folder: $(head -1 outside)"
get /run.json rebound '' evil.example
head -1 rebound | grep -q ' 403 ' || fail "the server said to a host of another name: $(head -1 rebound)"
get /run.json foreign '' localhost http://evil.example
head -1 foreign | grep -q ' 403 ' || fail "the server said to a page of another site: $(head -1 foreign)"
get /run.json own '' localhost:1 http://localhost:1
head -1 own | grep -q ' 200 ' || fail "the server said to its own page: $(head -1 own)"
expect 1 "$fastscene" view run --port "$(echo "${address%/}" | sed 's/.*://')"
kill -TERM "$pid"
code=0; wait "$pid" || code=$?
[ "$code" = 0 ] || [ "$code" = 143 ] || fail "exit code $code after SIGTERM"

# Truth on two poses: figures are there and make sense.
expect 0 "$fastscene" metrics run --truth --views 2 --size 128 --radius 0.2 --json
has run/metrics/report.json
grep -q '"psnr_mean"' run/metrics/report.json || fail "no psnr_mean"
# With bounds also what the walk and then the splats lose at the walked poses; what was traced for it stays, and is not traced again.
expect 0 "$fastscene" metrics run --truth --views 2 --size 128 --radius 0.2 --bounds --json
has run/metrics/bounds/panoramas/01.png
grep -q '"walked_poses"' run/metrics/report.json || fail "no walked_poses"
prints '"splat_stage_loses_db"'
cp out first && touch -d '2001-01-01' run/metrics/bounds/panoramas/01.png run/metrics/bounds/A.ply
expect 0 "$fastscene" metrics run --truth --views 2 --size 128 --radius 0.2 --bounds --json
cmp -s out first || fail "the same question has another answer"
for kept in panoramas/01.png A.ply; do
  [ "$(stat -c %Y run/metrics/bounds/$kept)" -lt 1000000000 ] || fail "$kept was made again"
done
expect 2 "$fastscene" metrics run
expect 2 "$fastscene" metrics run --truth --samples 3
says "--samples"

# Pictures: nothing that was said is ignored, and what could not be measured is no success.
expect 2 "$fastscene" metrics images run/metrics/truth run
says 'expected no further argument, found "run"'
expect 2 "$fastscene" metrics images run/metrics/truth --truth
expect 1 "$fastscene" metrics images run/metrics/truth --weights nowhere
says "--weights nowhere: expected a folder, found none"
mkdir -p weights/clip-vit-base-patch32
expect 0 "$fastscene" metrics images run/metrics/truth --weights weights --reference run/metrics/truth --prompt "$prompt"
prints "ssim_wang"
prints "clip_s is not measured: weights/clip-vit-base-patch32: expected"
expect 1 "$fastscene" metrics images run/metrics/truth --weights weights --reference run/metrics/truth --measure psnr --measure niqe
prints "psnr: the mean is over 0 of 2 pictures; infinite for 2"
says "expected a value of niqe"

mkdir -p pictures && cp run/metrics/truth/*.png pictures/ && head -c 500 a.png >pictures/cut.png
expect 0 "$fastscene" metrics images pictures --reference pictures --measure psnr
prints "1 of 3 pictures cannot be read and are left out"
says "left out: pictures/cut.png"
expect 1 "$fastscene" metrics images pictures/cut.png --measure psnr --reference pictures/cut.png
says "pictures/cut.png: expected"

# Range maps that are none are named.
expect 1 "$fastscene" metrics depth run/depth/range.exr pictures/cut.png
says "pictures/cut.png"
if command -v ffmpeg >/dev/null && ffmpeg -v error -y -i run/panorama/color.png -vf format=gray gray.png 2>/dev/null; then
  expect 1 "$fastscene" metrics depth run gray.png
  says "gray.png: expected a map of one number a pixel"
  says "found 8 bits of gray"
fi
{ printf 'Pf\n128 64\n-1.0\n' && head -c $((4 * 128 * 64)) /dev/zero; } >empty.pfm
expect 1 "$fastscene" metrics depth run empty.pfm
says "empty.pfm: expected pixels with a range above 0"

# Help and doctor.
expect 0 "$fastscene" --help
for verb in make panorama depth walk views splat metrics render convert view models doctor version; do
  prints "$verb"
done
for verb in make panorama depth walk views splat metrics render convert view models doctor version; do
  expect 0 "$fastscene" "$verb" --help
  prints "--threads"
  expect 0 "$fastscene" --help
done
expect 0 "$fastscene" make --help
prints "--splat-steps N=2200"
expect 0 "$fastscene" doctor
prints threads
expect 0 "$fastscene" doctor --json
prints '"remedy"'
expect 0 env FASTSCENE_ISA=sse4 "$fastscene" doctor
prints "sse4 in use"
expect 2 env FASTSCENE_ISA=avx1024 "$fastscene" doctor
says 'FASTSCENE_ISA: expected sse4, avx2 or avx512, found "avx1024"'
expect 0 "$fastscene" version
prints fastscene
exit 0
