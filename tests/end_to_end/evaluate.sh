# A suite from its file to its report: made, gone on with, with other systems' pictures, and with everything that can be wrong in it.
collect=$(realpath "$(dirname "$0")/../../bench/peers/collect.sh")
. "$(dirname "$0")/lib.sh"
unset FASTSCENE_WEIGHTS; export XDG_CACHE_HOME=$work/cache

settings='[settings]
panorama-width = 256
panorama-cell = 0.25
panorama-cell-samples = 8
panorama-outside-detail = 0
panorama-pixel-samples = 2
walk-viewpoints = 2
views-size = 64
views-points = 4000
splat-count = 2000
splat-steps = 20
'
cat >small.toml <<TOML
title = "Small"
measures = ["stills", "source", "held-out", "holes"]
columns = ["niqe", "clip_l14", "source_psnr", "lpips_alex", "psnr", "holes", "minutes"]
quality = "draft"
$settings
[stills]
count = 3
[held-out]
views = 1
size = 96
[[variant]]
name = "Ours"
[[scene]]
name = "bedroom"
prompt = "$prompt"
seeds = [3]
[[published]]
name = "Them"
niqe = 3.9
TOML

expect 0 "$fastscene" evaluate small.toml -o eval
prints "| Them (published) | 3.90 |"
prints "fetch modelparameters.mat"
prints "| Ours, x +0.33 |"
says "report.html"
has eval/results.json eval/table.md eval/table.csv eval/table.tex eval/scenes.csv eval/report.html eval/scenes/ours/bedroom-3/splat/scene.ply
grep -q '"psnr"' eval/results.json || fail "no psnr in results.json"
grep -q "clip-vit-large-patch14" eval/report.html || fail "the report does not say what to fetch"
! grep -qE '(src|href)="http' eval/report.html || fail "the report asks the network"

# Again: nothing is made anew, and the result is the same.
contents eval/scenes >before
cp eval/table.csv first.csv
expect 0 "$fastscene" evaluate small.toml -o eval
says "splat: already made"
contents eval/scenes | diff before - >log || fail "a finished scene changed"
cmp -s first.csv eval/table.csv || fail "another table the second time"

# The page alone, from results.json.
rm eval/report.html
expect 0 "$fastscene" evaluate --redraw eval
has eval/report.html
cmp -s first.csv eval/table.csv || fail "another table when drawn again"
expect 2 "$fastscene" evaluate --redraw nowhere
says "results.json"

# Other systems: pictures, splats, what is seen all around, time. Our own splats under another name are worth what ours are: the same
# cameras, the same panorama, the same room.
mkdir -p peer/bedroom third sphere/bedroom
expect 0 "$fastscene" render eval/scenes/ours/bedroom-3 --size 120x100 -o peer/bedroom/a.png
echo 70 >peer/minutes.txt
cp eval/scenes/ours/bedroom-3/splat/scene.ply third/bedroom.ply
cp eval/measured/ours/bedroom-3/source/splats/sphere.png sphere/bedroom/source.png
echo 12.5 >sphere/bedroom/minutes.txt
mkdir -p broken/bedroom
cp peer/bedroom/a.png broken/bedroom/b.png
echo junk >broken/bedroom/a.png
expect 0 "$fastscene" evaluate small.toml -o eval --peer "Some system=peer" --peer "Third=third" --peer "Sphere=sphere" --peer "Broken=broken"
grep -q 'a.png: not there, or cannot be read' eval/report.html || fail "a broken picture of another system is not named in the page"
grep -q '^| Some system .*70.0<sup>.*</sup> |$' eval/table.md || fail "the peer's minutes are not in the table"
grep -q '^| Sphere .* 12.5 |$' eval/table.md || fail "the scene's own minutes are not in the table"
grep -q 'minutes: one figure for all its scenes' eval/table.md || fail "one figure for all scenes, unsaid"
column() { sed -n 's/^"\(.*\)","\(.*\)","bedroom",[0-9]*,\(.*\),\(.*\),$/\1|\2|\3|\4/p' eval/scenes.csv | grep "^$1||$2|" | cut -d'|' -f4; }
for measure in psnr source_psnr; do
  [ -n "$(column Ours $measure)" ] && [ "$(column Ours $measure)" = "$(column Third $measure)" ] || fail "$measure of the same splats differs: ours $(column Ours $measure), theirs $(column Third $measure)"
done
[ "$(column Sphere source_psnr)" = "$(column Ours source_psnr)" ] || fail "source.png is not measured as the splats are"
cmp -s eval/measured/peers/third/bedroom/stills/walked/00.png eval/measured/ours/bedroom-3/stills/walked/00.png || fail "a peer's splats are seen by other cameras"
expect 2 "$fastscene" evaluate small.toml -o nothing --peer "Nobody=$work"
says "bedroom"
lacks nothing
expect 2 "$fastscene" evaluate small.toml -o nothing --peer nobody
says "NAME=DIR"
expect 2 "$fastscene" evaluate small.toml -o nothing --peer "ours=peer"
says "expected a name of its own"

# What other systems leave, brought into that form; a name with a space, more pictures than are wanted, and what is none of it.
mkdir -p "left behind/run/output_rendering" left/images/frames left/splats
for i in $(seq 0 40); do cp peer/bedroom/a.png "left behind/run/output_rendering/rendering_$i.png"; done
cp peer/bedroom/a.png "left behind/run/output_rendering/rendering_noise_0.png"
cp peer/bedroom/a.png "left/images/frames/view 1.jpg"
cp third/bedroom.ply left/splats/splat.ply
expect 0 "$collect" text2room "left behind" bedroom "all peers/text2room" 70.5
[ "$(ls "all peers/text2room/bedroom" | grep -c png)" = 30 ] || fail "30 pictures of 41 were wanted"
[ "$(cat "all peers/text2room/bedroom/minutes.txt")" = 70.5 ] || fail "minutes.txt"
expect 0 "$collect" scenescape left bedroom "all peers/scenescape"
has "all peers/scenescape/bedroom/000.jpg"
expect 0 "$collect" worldgen left/splats bedroom "all peers/worldgen"
cmp third/bedroom.ply "all peers/worldgen/bedroom.ply" || fail "other splats"
expect 0 "$collect" sphere sphere/bedroom/source.png bedroom "all peers/perf"
has "all peers/perf/bedroom/source.png"
printf 'ply\nformat ascii 1.0\nelement vertex 0\nend_header\n' >mesh.ply
expect 1 "$collect" splats mesh.ply bedroom none && says "expected Gaussian splats"
expect 1 "$collect" text2room left bedroom none && says "output_rendering"
expect 1 "$collect" text2room "left behind" bedroom none many && says "expected a number of minutes"
expect 1 "$collect" text2room "left behind" ../bedroom none && says "expected the name of a scene"
expect 1 env PICTURES=0 "$collect" text2room "left behind" bedroom none && says "PICTURES=0"
expect 1 "$collect" video small.toml bedroom none && says "expected a video"
expect 1 "$collect" nobody left bedroom none && says "hunyuanworld"
expect 2 "$collect" text2room

# A finished run as a scene: read only, and measured as it was.
contents eval/scenes >before
sed 's/^prompt = .*/run = "eval\/scenes\/ours\/bedroom-3"/; /^seeds/d' small.toml >given.toml
expect 0 "$fastscene" evaluate given.toml -o given
contents eval/scenes | diff before - >log || fail "a run that was lent has changed"
lacks given/scenes
[ "$(sed -n 's/^"Ours","","bedroom",3,psnr,//p' given/scenes.csv)" = "$(sed -n 's/^"Ours","","bedroom",3,psnr,//p' eval/scenes.csv)" ] || fail "a run is measured otherwise than the same scene"

# One scene fails, the others go on, and the exit code says so. A second row starts from the first one's panorama.
sed 's/^measures.*/measures = ["stills"]/; s/^columns.*/columns = ["niqe", "minutes"]/; s/^name = "bedroom"/name = "odd"/; s/^prompt = .*/panorama = "odd.png"/' small.toml >odd.toml
"$fastscene" render eval/scenes/ours/bedroom-3 --size 90x80 -o odd.png >/dev/null 2>&1
printf '\n[[scene]]\nname = "bedroom"\nprompt = "%s"\nseeds = [3]\n[[variant]]\nname = "Fewer"\nsettings = { walk-viewpoints = 1 }\n' "$prompt" >>odd.toml
expect 1 "$fastscene" evaluate odd.toml -o eval2
says "odd.png"
has eval2/report.html eval2/scenes/ours/bedroom-3/splat/scene.ply
cmp -s eval2/scenes/ours/bedroom-3/panorama/stage.json eval2/scenes/fewer/bedroom-3/panorama/stage.json || fail "the panorama was made twice"
says "2 of 4 scenes failed"
for form in html md tex csv; do grep -q "odd.png: expected" eval2/{report,table}.$form 2>/dev/null || fail "the failure is not in .$form"; done

# A kill while the second row's copy of the panorama was made: the rest of it goes, and the row is made as before.
cp -r eval2/scenes/fewer/bedroom-3 as_before
rm -r eval2/scenes/fewer/bedroom-3/{run.json,report.json,depth/stage.json,walk,views,splat}
expect 1 "$fastscene" evaluate odd.toml -o eval2
says "2 of 4 scenes failed"
same eval2/scenes/fewer/bedroom-3/splat as_before/splat

# Suites that ship, and typos.
expect 0 "$fastscene" evaluate
prints paper-table2
expect 0 "$fastscene" evaluate paper-table2 --show
prints 'prompt = "a cozy bedroom'
expect 2 "$fastscene" evaluate paper-tabel2
says "did you mean paper-table2?"
sed 's/^prompt/promt/' small.toml >typo.toml
expect 1 "$fastscene" evaluate typo.toml -o p
says "did you mean prompt?"
grep -qE 'typo.toml:[0-9]+:' log || fail "no line number"
expect 1 "$fastscene" evaluate typo.toml --show
says "did you mean prompt?"
expect 0 "$fastscene" evaluate small.toml --show
prints 'title = "Small"'
lacks p
no_rest eval
