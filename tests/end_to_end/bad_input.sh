# Everything that can be wrong from outside: the right exit code, a sentence that helps, and nothing lost.
. "$(dirname "$0")/lib.sh"

# Prompts.
expect 2 "$fastscene" make "" -o p
expect 2 "$fastscene" make "   " -o p
expect 2 "$fastscene" make "$(head -c 10000 /dev/zero | tr '\0' 'x')" -o p
expect 2 "$fastscene" make $'a bed \xff\xfe' -o p
expect 2 "$fastscene" make -o p
says "expected a prompt"
expect 2 "$fastscene" make "xyzzy qwertz zzzzz" --strict -o p
says "xyzzy"
lacks p
# Without one known word: a plausible room, and it is said.
expect 0 "$fastscene" panorama "xyzzy qwertz zzzzz" -o unknown "${tiny[@]:0:10}"
grep -q "built-in" unknown/credits.txt || fail "credits.txt: expected beside a panorama"
says "the prompt names nothing that belongs to a room"
has unknown/panorama/color.png
grep -q xyzzy unknown/panorama/prompt.json || fail "prompt.json does not name the word"

# Flags and verbs.
expect 2 "$fastscene" make "$prompt" --qualty draft -o p
says "did you mean --quality?"
expect 2 "$fastscene" make "$prompt" --splat-step 7 -o p
says "did you mean --splat-steps?"
expect 2 "$fastscene" mak "$prompt"
says "did you mean make?"
expect 2 "$fastscene" make "$prompt" --quality best -o p
expect 2 "$fastscene" make "$prompt" --panorama-width many -o p
says "--panorama-width: expected a whole number"
expect 2 "$fastscene" make "$prompt" --panorama-width 12 -o p
says "expected a number from 64"
expect 2 "$fastscene" make "$prompt" --panorama-cell nan -o p
expect 2 "$fastscene" make "$prompt" --seed -1 -o p
expect 2 "$fastscene" make "$prompt" too many -o p
expect 2 "$fastscene" make "$prompt" --seed
says "--seed: expected a whole number after it"
expect 2 "$fastscene" make "$prompt" --quality Draft -o p
says "did you mean draft?"
expect 2 "$fastscene" make "$prompt" --threads 1e3 -o p
says "--threads: expected a whole number from 0 to 4096, found \"1e3\""
expect 2 "$fastscene" make "$prompt" -o ""
says "--out: expected DIR, found an empty text"
# What is no verb has no help, and a part of a verb is known too.
expect 2 "$fastscene" mak --help
says "did you mean make?"
expect 0 "$fastscene" make --help
expect 2 "$fastscene" models pul
says "models: unknown argument pul; did you mean pull?"
expect 2 "$fastscene" walk tabel run
says "did you mean walk table?"
expect 2 "$fastscene" models
says "models: expected one of list, pull, verify, path"
expect 2 "$fastscene" render
says "render: expected scene DIR|FILE, found none"
expect 2 "$fastscene" depth train somewhere -o p
says "depth train: expected its folder after --data, found only \"somewhere\""
expect 2 "$fastscene"
expect 2 "$fastscene" walk "$work/nowhere"
says "no run.json"
lacks p nowhere

# A program without the part that holds its networks: what needs none works, what needs one names the missing file.
mkdir bin && ln "$fastscene" bin/ 2>/dev/null || cp "$fastscene" bin/
expect 0 bin/fastscene panorama "$prompt" -o without "${tiny[@]:0:10}"
expect 1 bin/fastscene make --panorama without/panorama/color.png -o pictured "${tiny[@]}"
says "$work/lib/fastscene/fastscene-nn.so: cannot open"

# A run to lose.
expect 0 "$fastscene" make "$prompt" -o run "${tiny[@]}"
contents run >before
kept() { contents run | diff before - >log || fail "something of the run was lost or changed"; no_rest run; }

# Two numbers where three are wanted, in the last of several too.
expect 2 "$fastscene" render run --position 1 2
says "--position: expected 3 numbers (X Y Z), found 2"
expect 2 "$fastscene" render run --position 1 2 3 --position 1 2
expect 2 "$fastscene" convert run crop.ply --crop -1 -1 -1 1 1
says "--crop: expected 6 numbers"
expect 2 "$fastscene" render run --fov wide
says "--fov: expected a number, found \"wide\""
lacks crop.ply
expect 0 "$fastscene" render run --position 1 2 3 --position 0 0 0 --size 8x8 -o still.png

# Files of later stages are missed before the first begins; a pipe is not waited for.
mkfifo pipe
for file in gone.pt pipe; do
  expect 1 "$fastscene" make "$prompt" -o p --walk-inpaint-weights "$file"
  says "$file: "
  expect 1 "$fastscene" make "$prompt" -o p --depth-backend egformer --depth-weights "$file"
  says "$file: "
  expect 1 timeout 60 "$fastscene" make --panorama "$file" -o p
  says "$file: cannot be read"
done
expect 1 "$fastscene" make "$prompt" -o p --splat-checkpoint nowhere/state
says "nowhere/state: cannot be written"
lacks p

# A record that was edited: it is said whose.
cp -r run edited && sed -i 's/"viewpoints": 2/"viewpoints": "two"/' edited/run.json
expect 1 "$fastscene" walk edited
says "edited/run.json: params: viewpoints: expected another kind of value"

# Another prompt, another seed, a foreign folder.
expect 2 "$fastscene" make "a kitchen" -o run "${tiny[@]}"
says "--force"
expect 2 "$fastscene" make "$prompt" --seed 9 -o run "${tiny[@]}"
says "seed 9"
mkdir -p foreign/views && echo mine >foreign/views/holiday.txt
expect 2 "$fastscene" make "$prompt" -o foreign "${tiny[@]}"
[ "$(cat foreign/views/holiday.txt)" = mine ] || fail "a foreign file was touched"
kept

# Pictures.
expect 2 "$fastscene" make --panorama run/panorama/color.png --depth-backend image -o p "${tiny[@]}"
says "--range FILE"
lacks p
expect 2 "$fastscene" make "$prompt" --range run/depth/range.exr -o p "${tiny[@]}"
expect 2 "$fastscene" make "$prompt" --more nothing.json -o p "${tiny[@]}"
says "--more: expected together with --panorama FILE"
echo '{"panoramas": [{"color": "gone.png", "position": [1, 0]}]}' >more.json
expect 1 "$fastscene" make --panorama run/panorama/color.png --range run/depth/range.exr --more more.json -o p "${tiny[@]}"
says "more.json: panorama 1: expected 3 numbers"
lacks p
expect 0 "$fastscene" render run --size 100x90 -o odd.png
expect 0 "$fastscene" render run --size 1x1 -o one.png
head -c 3000 run/panorama/color.png >short.png
with_picture() { expect 1 "$fastscene" make --panorama "$1" --range run/depth/range.exr -o p "${tiny[@]}"; says "$1"; lacks p; }
with_picture odd.png
says "found 100 x 90"
with_picture one.png
says "found 1 x 1"
with_picture short.png
with_picture absent.png
echo "not a picture" >text.jpg
with_picture text.jpg
if command -v node >/dev/null; then
  # A good PNG of 20000 x 10000, one bit a pixel.
  node -e '
    const zlib = require("zlib"), fs = require("fs"), w = 20000, h = 10000;
    const table = [...Array(256).keys()].map(n => { for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1; return n >>> 0; });
    const crc = b => { let c = 0xffffffff; for (const x of b) c = table[(c ^ x) & 255] ^ (c >>> 8); return (c ^ 0xffffffff) >>> 0; };
    const chunk = (name, data) => { const body = Buffer.concat([Buffer.from(name), data]), out = Buffer.alloc(body.length + 8);
      out.writeUInt32BE(data.length, 0); body.copy(out, 4); out.writeUInt32BE(crc(body), body.length + 4); return out; };
    const head = Buffer.alloc(13); head.writeUInt32BE(w, 0); head.writeUInt32BE(h, 4); head[8] = 1;
    fs.writeFileSync("wide.png", Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", head),
      chunk("IDAT", zlib.deflateSync(Buffer.alloc(h * (w / 8 + 1)))), chunk("IEND", Buffer.alloc(0))]));'
  with_picture wide.png
  says "found 20000 x 10000"
fi

# The same picture as WebP and TIFF, where ffmpeg can write them; half of one is an error.
if command -v ffmpeg >/dev/null; then
  for name in copy.webp copy.tif; do
    ffmpeg -v error -y -i run/panorama/color.png "$name" 2>/dev/null || continue
    expect 0 "$fastscene" panorama --panorama "$name" --range run/depth/range.exr -o "with-$name" "${tiny[@]:0:10}"
    head -c 700 "$name" >"short-$name"
    with_picture "short-$name"
  done
fi

# Splats in an archive.
echo "no archive" >text.sog
expect 1 "$fastscene" convert text.sog splats.ply
says "text.sog: expected PlayCanvas' SOG"
printf 'PK\003\004 and no more' >short.sog
expect 1 "$fastscene" convert short.sog splats.ply
says "short.sog: expected a zip archive"
lacks splats.ply

# Range maps: PFM files of one value.
pfm() { printf 'Pf\n%d %d\n-1.0\n' "$2" "$3" >"$1"; for _ in $(seq $(($2 * $3))); do printf "$4"; done >>"$1"; }
pfm size.pfm 64 32 '\x00\x00\x80\x3f'
pfm nan.pfm 128 64 '\x00\x00\xc0\x7f'
pfm zero.pfm 128 64 '\x00\x00\x00\x00'
with_map() { expect 1 "$fastscene" make --panorama run/panorama/color.png --range "$1" -o p "${tiny[@]}"; says "$1"; lacks p; }
with_map size.pfm
says "found 64 x 32"
with_map nan.pfm
with_map zero.pfm
says "no finite value above zero"
with_map absent.exr
kept

# A picture that is gone after its run was begun: what was made of it is enough to go on, what wants it again names it.
cp run/panorama/color.png mine.png && cp run/depth/range.exr mine.exr
expect 0 "$fastscene" make --panorama mine.png --range mine.exr -o mine "${tiny[@]}"
rm mine.exr
echo other >>mine.png
expect 1 "$fastscene" splat mine --splat-steps 21
says "mine.exr: cannot be read"
rm mine.png
expect 0 "$fastscene" splat mine --splat-steps 21
says "mine.png is missing: the run continues from what was made of it"
says "panorama: already made"
expect 1 "$fastscene" depth mine --panorama-width 64
says "mine.png: cannot be read"

# What only the last stage needs is missed before the first one.
narrow() { (ulimit -v 8000000; exec "$fastscene" "$@"); }
if narrow version >/dev/null 2>&1; then   # a sanitizer's own memory is larger
  expect 1 narrow make "$prompt" -o early "${tiny[@]}" --splat-count 20000000 --splat-sh-degree 3
  says "--splat-count: 20000000 Gaussians with SH degree 3 take"
  # Without a degree it is that which a room gets, known before the first stage.
  expect 1 narrow make "$prompt" -o early "${tiny[@]}" --splat-count 20000000
  says "--splat-count: 20000000 Gaussians with SH degree 2 take"
fi
expect 2 "$fastscene" make "$prompt" -o early "${tiny[@]}" --splat-patience 5
says "--splat-patience: expected together with --splat-eval-every"
lacks early

# Disks: a place that cannot be written, and a limit on the size of files in place of a full disk.
echo x >file
expect 1 "$fastscene" make "$prompt" -o file/below "${tiny[@]}"
says "file/below"
expect 1 "$fastscene" make "$prompt" -o /proc/fastscene "${tiny[@]}"
says "/proc/fastscene"
limited() { (ulimit -f 16; exec "$fastscene" "$@"); }
expect 1 limited make "$prompt" -o full "${tiny[@]}"
says "full"
expect 1 limited make "$prompt" -o run "${tiny[@]}" --splat-steps 7
kept
no_rest full
expect 0 "$fastscene" make "$prompt" -o full "${tiny[@]}"
same run full

# --force throws the other run away, as asked.
expect 0 "$fastscene" make "a bright kitchen" -o full "${tiny[@]}" --force
! cmp -s run/panorama/color.png full/panorama/color.png || fail "--force kept the old room"
exit 0
