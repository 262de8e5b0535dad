# snakemake.sh PROGRAM FOLDER SNAKEFILE PACKAGES: a batch by Snakemake, stopped in the middle and gone on with.
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../end_to_end/lib.sh"
snakefile=$3
if command -v snakemake >/dev/null; then
  snakemake=(snakemake)
else
  python=$(bash "$here/fetch_snakemake.sh" "$4") || { echo "$python"; exit 77; }
  snakemake=(env PYTHONPATH="$python" python3 -m snakemake)
fi
export XDG_CACHE_HOME=$work/cache

small="--stage panorama --panorama-width 128 --panorama-cell 0.25 --panorama-cell-samples 8 --panorama-pixel-samples 2 --panorama-outside-detail 0"
line() { echo "{\"prompt\": \"a small study with a desk\", \"seed\": $1, \"name\": \"study-$1\"$2}"; }
{ line 0 ""; line 1 ', "flags": ["--panorama-pixel-samples", "300"]'; line 2 ""; } >list.jsonl
expect 0 "$fastscene" batch list.jsonl -o alone --quality draft $small --threads 2
run=("${snakemake[@]}" -s "$snakefile" --cores 2 --config list=list.jsonl out=set quality=draft "flags=$small" threads=1 fastscene="$fastscene")

# Ctrl-C in the middle: it goes to Snakemake and its jobs.
setsid env --default-signal=INT "${run[@]}" >log 2>&1 & started=$!
for ((i = 0; i < 600; ++i)); do [ -d set/study-1 ] && break; sleep 0.1; done
kill -INT -- "-$started"
wait "$started" && fail "it was not stopped"
# What each scene asks of a cluster, by the program's own estimate.
says "mem_mb=1536"
says "runtime=15"
lacks set/made/study-1

expect 0 "${run[@]}"
grep -q '^prepare\|rule prepare' log && fail "what was prepared is prepared anew"
for i in 0 1 2; do same "alone/study-$i" "set/study-$i"; done
expect 0 "${run[@]}"
says "Nothing to be done"

# A line more: it alone is made. One that gives no scene fails, and the rest is there.
before=$(stat -c %Y set/study-0/run.json)
sleep 1
{ line 3 ""; line 4 ', "flags": ["--panorama-width", "wide"]'; } >>list.jsonl
expect 1 "${run[@]}" --keep-going
has set/study-3/run.json
lacks set/made/study-4
says "rule scene"
[ "$(stat -c %Y set/study-0/run.json)" = "$before" ] || fail "a finished scene was made again"
expect 0 "$fastscene" batch set --status
prints "4 of 5 scenes done, 1 failed"
