# A painted panorama with small random networks: the whole stream, a stop, a photo, larger pictures, what belongs to a run.
. "$(dirname "$0")/lib.sh"

"$3" brought >log 2>&1 || fail "no tiny networks"
weights=$work/brought/weights
small=(--panorama diffusion360 --panorama-width 256 --panorama-steps 2 --threads 1)
width_of() { od -An -tu1 -j18 -N2 "$1" | awk '{ print 256 * $1 + $2 }'; }
is_wide() { [ "$(width_of "$1")" = "$2" ] || fail "$1 is $(width_of "$1") wide, expected $2"; }

# The whole stream. A network for depth that is not needed yet is neither opened nor announced.
mkdir -p "$FASTSCENE_MODELS/egformer" && echo no network >"$FASTSCENE_MODELS/egformer/EGformer_pretrained.pkl"
expect 0 "$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" -o loft
grep -qi egformer log && fail "egformer was announced"
rm -rf "$FASTSCENE_MODELS/egformer"
is_wide loft/panorama/color.png 256
expect 0 "$fastscene" make "a loft" "${small[@]}" --weights "$weights" -o loft --depth-backend layout "${tiny[@]:10}"
says "panorama: already made"
has loft/panorama/color.png loft/depth/range.exr loft/splat/scene.ply loft/viewer.html
lacks loft/painting.png

# Killed between two pictures, it goes on after the first and ends in the same bytes; a larger one begins with what is there.
larger=("$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" --panorama-upscale 6)
"${larger[@]}" -o killed >out 2>log &
pid=$!
while kill -0 "$pid" 2>/dev/null && [ ! -e killed/painting/3.json ]; do sleep 0.1; done
kill -9 "$pid" 2>/dev/null
wait "$pid" 2>/dev/null
has killed/painting/3.png
rm -rf killed/panorama  # where the kill came too late
expect 0 "${larger[@]}" -o killed
says "the generated picture already exists"
says "upscaled by 3: already exists"
is_wide killed/panorama/color.png 1536
expect 0 "${larger[@]}" -o loft
says "the generated picture already exists"
cmp killed/panorama/color.png loft/panorama/color.png || fail "a run that was killed ends in other bytes"

# Any picture can be made larger.
expect 0 "$fastscene" panorama --panorama loft/painting/1.png --panorama-upscale 3 --weights "$weights" -o picture --threads 1
is_wide picture/panorama/color.png 768
expect 2 "$fastscene" panorama --panorama loft/painting/1.png --panorama-upscale 3 --panorama-width 250 --weights "$weights" -o odd
says "multiple of 128"
expect 2 "$fastscene" panorama "a loft" --panorama-upscale 3 -o odd
says "--panorama-upscale"
expect 2 "$fastscene" panorama --panorama loft/painting/1.png --panorama-upscale 3 -o odd
says "models pull diffusion360-upscale"
lacks odd

# A photo that lies on its side is turned.
expect 0 "$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" --photo brought/side.jpg -o photo
expect 0 "$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" --photo brought/upright.png -o upright
cmp photo/panorama/color.png upright/panorama/color.png || fail "a photo on its side is painted otherwise"
grep -q '"guidance": 7.0' photo/run.json || fail "the guidance of photos is not the published one"

# What a run does not open is nothing to it; what it opens, and its photo, are named when they differ.
touch "$weights/readme.txt" "$weights/sd-base/unet/notes.txt"
expect 0 "$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" --panorama-upscale 6 -o loft
says "panorama: already made"
expect 2 "$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" --photo brought/upright.png -o photo
says "photo $work/brought/upright.png (contents "
printf x | dd of="$weights/sd-base/unet/diffusion_pytorch_model.safetensors" bs=1 seek=$(($(stat -c %s "$weights/sd-base/unet/diffusion_pytorch_model.safetensors") - 1)) conv=notrunc 2>/dev/null
expect 2 "$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" -o loft
says "weights $weights (contents "
expect 0 "$fastscene" panorama "a loft" "${small[@]}" --weights "$weights" --photo brought/side.jpg -o photo
says "panorama: already made"
exit 0
