# Many scenes: lists with faults, a scene that fails, a batch that is killed, the page of all.
. "$(dirname "$0")/lib.sh"

# Panoramas alone are quick.
small=(--stage panorama --quality draft --panorama-width 128 --panorama-cell 0.25 --panorama-cell-samples 8 --panorama-pixel-samples 2 --panorama-outside-detail 0)
cat > list.jsonl <<'LIST'
{"prompt": "a cozy bedroom with a red armchair", "seed": 3, "name": "bedroom"}
{"promt": "a typo"}
{"prompt": "a small kitchen", "name": "kitchen"}
{"prompt": "a study", "name": "faulty", "flags": ["--no-such-flag"]}
LIST
expect 1 "$fastscene" batch list.jsonl -o set "${small[@]}"
says 'list.jsonl:2: expected the keys prompt, seed, name, quality, flags, found "promt"'
prints "2 of 3 scenes done, 1 failed"
prints "faulty: panorama: unknown flag --no-such-flag"
has set/bedroom/panorama/color.png set/kitchen/panorama/color.png set/index.html set/bedroom.log
expect 2 "$fastscene" batch list.jsonl -o strict "${small[@]}" --strict
lacks strict

# A scene of a batch is the scene that the command line makes.
expect 0 "$fastscene" panorama "a cozy bedroom with a red armchair" --seed 3 -o alone "${small[@]:2}"
cmp alone/panorama/color.png set/bedroom/panorama/color.png || fail "a scene of a batch is another one"

# What is done stays; what failed is tried again; what was added is made.
before=$(stat -c %Y%i set/bedroom/panorama/color.png)
sed -i -e '/promt/d' -e 's/"--no-such-flag"//' list.jsonl
expect 0 "$fastscene" batch list.jsonl -o set "${small[@]}"
says "3 scenes, 2 already done"
[ "$before" = "$(stat -c %Y%i set/bedroom/panorama/color.png)" ] || fail "a finished scene was made again"
expect 0 "$fastscene" batch --status -o set --json
prints '"done": 3'

# Killed in the middle, and continued: the same scenes as in one go.
expect 0 "$fastscene" batch --count 6 -o whole "${small[@]}"
"$fastscene" batch --count 6 -o killed "${small[@]}" >/dev/null 2>&1 &
sleep 2
kill -9 $! && wait $! 2>/dev/null
expect 0 "$fastscene" batch --count 6 -o killed "${small[@]}"
for scene in whole/0*/; do
  cmp "$scene/panorama/color.png" "killed/$(basename "$scene")/panorama/color.png" || fail "$scene is another one after a kill"
done

expect 2 "$fastscene" batch -o none
says "expected a list of prompts or --count N, found neither"
expect 1 "$fastscene" batch missing.txt -o none
says "missing.txt: expected a list of prompts"
expect 2 "$fastscene" batch --count 2 -o none "${small[@]}" --splat-steps 3
says "--splat-steps: expected with --stage make"
expect 2 "$fastscene" batch --status -o none
