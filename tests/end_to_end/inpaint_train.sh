# The paper's inpainting data and training, from rooms to a walk with the network that came out.
. "$(dirname "$0")/lib.sh"

expect 0 "$fastscene" rooms dataset --count 4 --views 2 --size 128x64 --film clean --cell 0.3 --cell-samples 8 --pixel-samples 1 --outside-detail 0 --seed 2 -o rooms
echo broken > rooms/shard-00000/00000002.color.png
expect 0 "$fastscene" inpaint dataset rooms -o holes --size 64 --held-out 50 --seed 3
says "skipped"
prints "3 of 4 panoramas"
prints "18 faces, 288 masks"
has holes/train/images holes/train/masks holes/held-out/images
expect 2 "$fastscene" inpaint dataset rooms -o holes --size 32
says "dataset.json"
expect 0 "$fastscene" inpaint dataset ./rooms/ -o holes --size 64 --held-out 50 --seed 3
prints "0 in this run"
expect 2 "$fastscene" inpaint dataset nowhere -o holes
cp -r holes held_out_only && rm -r held_out_only/train
expect 2 "$fastscene" inpaint train held_out_only -o run3
says "held_out_only: expected faces to train on, found held-out ones only"

train=("$fastscene" inpaint train holes -o run --width 4 --blocks 1 --size 64 --batch 1 --held-out 2 --holes harmonic --adversarial 0 --log-steps 1)
expect 0 "${train[@]}" --steps 2
has run/generator.safetensors run/checkpoint.safetensors run/curves.csv run/sheets/00000002.png
expect 0 "${train[@]}" --steps 3
says "resuming after step 2"
expect 2 "${train[@]}" --steps 4 --learning-rate 1e-3
says "training.json"
expect 2 "$fastscene" inpaint train nowhere -o run2

expect 0 "$fastscene" make "$prompt" -o scene "${tiny[@]}"
expect 0 "$fastscene" walk scene --walk-inpainter aotgan --walk-inpaint-weights run/generator.safetensors
expect 1 "$fastscene" walk scene --walk-inpainter aotgan --walk-inpaint-weights run/curves.csv
says "curves.csv"
