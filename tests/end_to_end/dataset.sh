# A data set from its making to the formats that others train with, each opened by a reader that knows only the format.
. "$(dirname "$0")/lib.sh"
here=$(cd "$(dirname "$0")" && pwd)

small=(--views 2 --size 96x48 --cell 0.4 --cell-samples 2 --pixel-samples 1 --outside-detail 0 --seed 3)
make=("$fastscene" rooms dataset --count 8 "${small[@]}" --channels intrinsics,flow -o rooms)
expect 0 "${make[@]}"
prints "8 of 8 pictures done, 8 in this run"
has rooms/README.md rooms/index.txt rooms/rooms-00000/0000003.json rooms/shard-00000/00000007.shading.exr
grep -q "^# 8 panoramas of 4 furnished rooms" rooms/README.md || fail "no card"
# A room's document is a room that the program takes.
expect 0 "$fastscene" rooms plan --room rooms/rooms-00000/0000002.json -o planned.json

expect 0 "$fastscene" dataset stats rooms --json
python3 -c 'import json; s = json.load(open("out")); assert s["pictures"] == 8 and sum(c["pixels"] for c in s["classes"]) == 8 * 96 * 48' || fail "stats --json"
expect 0 "$fastscene" dataset card rooms --license cc-by-4.0

for format in webdataset coco structured3d huggingface nerfstudio; do
  expect 0 "$fastscene" dataset export rooms --format $format --splits 0.6,0.2,0.2 -o $format
done
expect 0 "$fastscene" dataset verify huggingface
prints "all intact"
expect 0 "$fastscene" dataset export rooms --format webdataset --shard-samples 2 -o twos
has twos/train-000001.tar
expect 0 "$fastscene" rooms dataset --count 4 "${small[@]}" --camera perspective -o views
expect 0 "$fastscene" dataset export views --format colmap --splits 1,0,0 -o colmap
expect 0 "$fastscene" dataset export views --format coco --splits 0,1,0 -o coco_views
expect 0 "$fastscene" dataset export views --format structured3d -o structured3d_views
has structured3d_views/scene_00001/2D_rendering/0/perspective/full/3/camera_pose.txt
python3 "$here/../datasets/formats_check.py" rooms webdataset twos coco structured3d huggingface || fail "a format"
python3 "$here/../datasets/formats_check.py" views coco_views || fail "a format of perspective pictures"
expect 0 "$fastscene" inpaint dataset structured3d -o holes --size 32
prints "8 of 8 panoramas"
if command -v colmap >/dev/null; then
  expect 0 colmap model_analyzer --path colmap/train/room-0000000/sparse/0
  cat out log | grep -q "Registered images: 2" || fail "COLMAP does not read the model"
fi

# Damage is named, and made again.
cp -r rooms damaged
head -c 100 rooms/shard-00000/00000003.range.png >damaged/shard-00000/00000003.range.png
printf 'x' | dd of=damaged/shard-00000/00000002.color.jpg bs=1 seek=400 conv=notrunc status=none
rm damaged/shard-00000/00000006.class.png
expect 1 "$fastscene" dataset verify damaged
prints "shard-00000/00000003.range.png: truncated: expected"
prints "shard-00000/00000002.color.jpg: damaged"
prints "shard-00000/00000006.class.png: missing"
says "3 of"
expect 1 "$fastscene" dataset export damaged --format coco -o from_damaged
says "fastscene dataset verify damaged --repair"
expect 0 "$fastscene" dataset verify damaged --repair
prints "3 pictures regenerated"
diff -r rooms damaged >log || fail "a repaired set differs"
head -c 5000 webdataset/train-000000.tar >cut && mv cut webdataset/train-000000.tar
expect 1 "$fastscene" dataset verify webdataset
prints "train-000000.tar: truncated"
expect 2 "$fastscene" dataset verify webdataset --repair
expect 0 "$fastscene" dataset export rooms --format webdataset --splits 0.6,0.2,0.2 -o webdataset

# What cannot be.
expect 2 "$fastscene" dataset export rooms --format webdatset -o no
says "did you mean webdataset?"
expect 2 "$fastscene" dataset export rooms --format colmap -o no
says "--format colmap: expected perspective pictures, found panoramas: coco, huggingface"
expect 2 "$fastscene" dataset export holes --format coco -o no
says "holes"
expect 2 "$fastscene" dataset export rooms --format coco -o holes
says "holes: expected an empty folder or an export to make again, found other files"
expect 2 "$fastscene" dataset export rooms --format coco --splits 0.5,0.1,0.1 -o no
says "--splits"
expect 2 "$fastscene" rooms dataset --count 1 --size 64x32 --channels flo -o no
says "did you mean flow?"
lacks no
rm rooms/shard-00000/00000004.json
expect 1 "$fastscene" dataset export rooms --format coco -o no
says "expected 8 pictures, found 7: fastscene rooms dataset --count 8 --size 96x48 --seed 3"
lacks no
expect 1 "$fastscene" dataset verify rooms
prints "shard-00000/00000004.json: missing"
expect 0 "${make[@]}"
prints "1 in this run"
