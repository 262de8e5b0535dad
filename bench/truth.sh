#!/usr/bin/env bash
# Truth over ten rooms, as docs/benchmarks.md has it: five prompts of our choice, five drawn at random.
#   bench/truth.sh [draft|standard|high] [OUT] [VIEWS] [ROOMS]      FASTSCENE=program to measure another build
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
program=${FASTSCENE:-$here/fastscene}
quality=${1:-draft} out=${2:-$here/out/truth-$quality} views=${3:-30} rooms=${4:-10}

prompts=(
  "a cozy bedroom with a red armchair and a large window"
  "a modern living room with a gray sofa, a wooden coffee table and plants"
  "a rustic kitchen with white cabinets and a dining table, morning light"
  "a scandinavian study with a desk, a bookshelf and a green rug"
  "a bright bathroom with a bathtub and blue tiles"
)
# Five more, drawn by a fixed rule from words that were written down before any room was looked at.
styles=(modern scandinavian japandi industrial classic boho rustic mid-century mediterranean "art deco")
kinds=("living room" bedroom "dining room" study "kids room" hallway kitchen loft)
pieces=("a brown leather sofa" "a large mirror" "two armchairs" "a piano" "a blue rug" "yellow curtains" "a bookshelf" "a round table")
draw() { echo $((0x$(printf '%s' "fastscene-$1-$2" | sha256sum | cut -c1-8) % $3)); }
for i in 0 1 2 3 4; do
  prompts+=("a ${styles[$(draw "$i" style ${#styles[@]})]} ${kinds[$(draw "$i" kind ${#kinds[@]})]} with ${pieces[$(draw "$i" piece ${#pieces[@]})]}")
done

mkdir -p "$out"
for i in $(seq 0 $((rooms - 1))); do
  dir=$out/room-$i
  "$program" make "${prompts[$i]}" -o "$dir" --quality "$quality" --seed "$i" >"$dir.log" 2>&1 || { cat "$dir.log" >&2; exit 1; }
  for radius in 0.3 0.6; do
    "$program" metrics "$dir" --truth --views "$views" --radius "$radius" --bounds >>"$dir.log" 2>&1
    cp "$dir/metrics/report.json" "$out/room-$i-$radius.json"
  done
done

ROOMS=$rooms OUT=$out node -e '
const fs = require("fs"), out = process.env.OUT, n = +process.env.ROOMS;
const f = v => v == null ? "-" : v.toFixed(2);
for (const r of ["0.3", "0.6"]) {
  console.log(`\nradius ${r} m | ours dB | SSIM | seen | unseen | worst | A | B | gap to A | closed | floor`);
  console.log("---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:");
  const rows = [...Array(n).keys()].map(i => JSON.parse(fs.readFileSync(`${out}/room-${i}-${r}.json`)).truth);
  const line = (name, t) => console.log([name, f(t.psnr_mean), t.ssim_mean.toFixed(3), f(t.psnr_seen_mean), f(t.psnr_unseen_mean), f(t.psnr_worst),
    f(t.bounds.A.psnr_mean), f(t.bounds.B.psnr_mean), f(t.gap_to_a_db), (100 * t.closed_share).toFixed(0) + " %", f(t.floor_db)].join(" | "));
  rows.forEach((t, i) => line(`room ${i}`, t));
  const mean = g => rows.reduce((s, t) => s + g(t), 0) / n;
  const all = { psnr_mean: mean(t => t.psnr_mean), ssim_mean: mean(t => t.ssim_mean), psnr_seen_mean: mean(t => t.psnr_seen_mean),
    psnr_unseen_mean: mean(t => t.psnr_unseen_mean), psnr_worst: Math.min(...rows.map(t => t.psnr_worst)),
    bounds: { A: { psnr_mean: mean(t => t.bounds.A.psnr_mean) }, B: { psnr_mean: mean(t => t.bounds.B.psnr_mean) } },
    gap_to_a_db: mean(t => t.gap_to_a_db), floor_db: Math.min(...rows.map(t => t.floor_db)) };
  all.closed_share = (all.psnr_mean - all.bounds.B.psnr_mean) / (all.bounds.A.psnr_mean - all.bounds.B.psnr_mean);
  line("mean (worst, floor: least)", all);
}'
