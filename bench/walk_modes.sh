#!/usr/bin/env bash
# The four walks on the same rooms, splat stage unchanged: truth at 0.3 and 0.6 m, as docs/benchmarks/walk.md has it.
#   bench/walk_modes.sh [draft|standard|high] [OUT] [VIEWS] [FIRST] [LAST]      rooms of bench/truth.sh, counted from 0
# What is there already is not made again, so rooms can be done one at a time and the table be printed at any moment (FIRST > LAST).
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
program=${FASTSCENE:-$here/fastscene}
quality=${1:-draft} out=${2:-$here/out/walk-modes-$quality} views=${3:-5} first=${4:-0} last=${5:-9}
mkdir -p "$out"
# The same sentences as everywhere else: the lines of truth.sh that make the list.
eval "$(sed -n '/^prompts=(/,/^done$/p' "$here/bench/truth.sh")"

measure() { # DIR NAME FLAGS…: truth at both radii
  local dir=$1 name=$2; shift 2
  for radius in 0.3 0.6; do
    [ -s "$out/$name-$radius.json" ] && continue
    "$program" metrics "$dir" --truth --views "$views" --radius "$radius" "$@" >>"$dir.log" 2>&1 || { tail -5 "$dir.log" >&2; exit 1; }
    cp "$dir/metrics/report.json" "$out/$name-$radius.json"
  done
}
for i in $(seq "$first" "$last"); do
  ours=$out/room-$i-ours
  "$program" make "${prompts[$i]}" -o "$ours" --quality "$quality" --seed "$i" >>"$ours.log" 2>&1 || { tail -5 "$ours.log" >&2; exit 1; }
  measure "$ours" "room-$i-ours" --bounds
  for mode in paper paper-direct paper-far; do
    dir=$out/room-$i-$mode
    if [ ! -s "$dir/run.json" ]; then
      mkdir -p "$dir"
      cp -r "$ours/run.json" "$ours/panorama" "$ours/depth" "$dir/"
    fi
    "$program" splat "$dir" --walk "$mode" >>"$dir.log" 2>&1 || { tail -5 "$dir.log" >&2; exit 1; }
    measure "$dir" "room-$i-$mode"
  done
done

OUT=$out node -e '
const fs = require("fs"), out = process.env.OUT, kinds = ["ours", "paper", "paper-direct", "paper-far"];
const read = (i, k, r) => { try { return JSON.parse(fs.readFileSync(`${out}/room-${i}-${k}-${r}.json`)).truth; } catch { return null; } };
const f = v => v.toFixed(2);
for (const r of ["0.3", "0.6"]) {
  console.log(`\nradius ${r} m | ours | paper | paper-direct | paper-far | A | B | ours - paper | gap to A`);
  console.log("---|--:|--:|--:|--:|--:|--:|--:|--:");
  const rows = [];
  for (let i = 0; i < 10; ++i) {
    const t = kinds.map(k => read(i, k, r));
    if (t.some(v => !v)) continue;
    const row = [...t.map(v => v.psnr_mean), t[0].bounds.A.psnr_mean, t[0].bounds.B.psnr_mean, t[0].psnr_mean - t[1].psnr_mean, t[0].gap_to_a_db];
    rows.push(row);
    console.log([`room ${i}`, ...row.map(f)].join(" | "));
  }
  if (rows.length) console.log(["**mean**", ...rows[0].map((_, c) => f(rows.reduce((s, row) => s + row[c], 0) / rows.length))].join(" | "));
}'
