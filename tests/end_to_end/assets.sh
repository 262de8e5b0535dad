# A folder of one's own models, textures and skies: added, listed, used by rooms, credited.
. "$(dirname "$0")/lib.sh"

# box NAME W H D: a box as a model, in metres, with a material.
box() {
  mkdir -p "$(dirname "$1")"
  printf 'newmtl wood\nKd 0.5 0.3 0.1\n' >"${1%.obj}.mtl"
  { printf 'mtllib %s\nusemtl wood\n' "$(basename "${1%.obj}.mtl")"
    for z in -0.5 0.5; do for y in 0 1; do for x in -0.5 0.5; do
      python3 -c "print('v', $x * $2, $y * $3, $z * $4)"; done; done; done
    printf 'f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n'; } >"$1"
}
box from/chair.obj 0.8 1.0 0.8
box from/sundial.obj 0.5 0.9 0.5
echo "no model" >from/broken.glb

expect 0 "$fastscene" assets add mine from/chair.obj --class armchair --name "thinking chair" --author Ada --licence "CC BY 4.0"
has mine/chair.obj mine/chair.mtl mine/assets.toml
expect 0 "$fastscene" assets add mine from/sundial.obj --licence CC0
expect 2 "$fastscene" assets add mine from/chair.obj
says "there is a file of this name already"
expect 1 "$fastscene" assets add mine from/broken.glb
says "broken.glb"
[ "$(ls mine | wc -l)" = 5 ] || fail "what cannot be used was left behind: $(ls mine)"
expect 0 "$fastscene" assets list mine
prints "chair.obj: armchair, 0.80 x 1.00 x 0.80 m, 12 triangles"
prints "sundial.obj: sundial, 0.50 x 0.90 x 0.50 m"
expect 0 "$fastscene" assets verify mine

# A sky with a sun, as Radiance writes it.
python3 - <<'PYTHON'
rows = [[(200, 220, 255, 128) if y < 8 else (90, 80, 60, 128) for x in range(32)] for y in range(16)]
rows[4][20] = (255, 240, 200, 138)
open("mine/noon.hdr", "wb").write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 32\n" + bytes(v for r in rows for c in r for v in c))
PYTHON
printf '\n[[sky]]\nfile = "noon.hdr"\nauthor = "Grace"\nlicence = "CC0"\n' >>mine/assets.toml
expect 0 "$fastscene" assets verify mine
prints "sky      noon.hdr"

# The prompt's words, and what no prompt names: every armchair is ours.
expect 0 "$fastscene" rooms read "a study with a thinking chair and two sundials" --assets mine
prints "thinking chair: object: armchair"
expect 0 "$fastscene" panorama "a study with a thinking chair and a sundial" --assets mine -o run --panorama-width 128 \
  --panorama-cell-samples 8 --panorama-pixel-samples 1
grep -q "chair by Ada (CC BY 4.0), chair.obj" run/credits.txt || fail "credits.txt does not name the author"
grep -q "noon by Grace (CC0), noon.hdr" run/credits.txt || fail "credits.txt does not name the sky's author"
grep -q '"model": "sundial.obj"' run/panorama/room.json || fail "room.json does not name the model"
expect 0 "$fastscene" render run --of room --size 32x32 -o still.png
has still.png
# A run knows its folder from anywhere; nothing is made twice, and anew when a file changes.
mkdir elsewhere && cd elsewhere || exit 1
expect 0 "$fastscene" panorama "a study with a thinking chair and a sundial" --assets ../mine -o ../run \
  --panorama-width 128 --panorama-cell-samples 8 --panorama-pixel-samples 1
says "already made"
cd .. || exit 1
box mine/sundial.obj 0.4 1.2 0.4
expect 0 "$fastscene" panorama "a study with a thinking chair and a sundial" --assets mine -o run --panorama-width 128 \
  --panorama-cell-samples 8 --panorama-pixel-samples 1
python3 - <<'PYTHON' || fail "a changed model left the room as it was"
import json
thing = next(t for t in json.load(open("run/panorama/room.json"))["things"] if t.get("model") == "sundial.obj")
assert abs(thing["size_m"][1] - 1.2) < 1e-3, thing
PYTHON

# What is wrong is named; the rest goes on.
printf '\n[[model]]\nfile = "gone.glb"\n' >>mine/assets.toml
expect 1 "$fastscene" assets verify mine
prints '"gone.glb" is not there'
expect 0 "$fastscene" rooms read "a study with a sundial" --assets mine
says '"gone.glb" is not there'
expect 2 "$fastscene" panorama "a study" --assets nowhere -o other
says "expected none, cc0, all or a folder"
expect 2 "$fastscene" assets list nowhere
