# A depth network learns, stops, goes on, and makes a scene of a picture.
. "$(dirname "$0")/lib.sh"

small=(--height 32 --channels 4 --batch 1 --eval-steps 1000 --learning-rate 0.001 --final-learning-rate 0.001)
expect 0 "$fastscene" depth train --painted 1 --steps 4 "${small[@]}" -o whole --json
prints '"steps": 4'
has whole/egformer.safetensors whole/checkpoint.safetensors whole/curves.csv whole/sheets/00000004.png whole/training.json

# Stopped and gone on with: the same network, byte for byte.
expect 0 "$fastscene" depth train --painted 1 --steps 2 "${small[@]}" -o parts
expect 0 "$fastscene" depth train --painted 1 --steps 4 "${small[@]}" -o parts
cmp -s whole/egformer.safetensors parts/egformer.safetensors || fail "a training that was stopped ends elsewhere"
expect 0 "$fastscene" depth train --painted 1 --steps 4 "${small[@]}" -o parts --start whole/egformer.safetensors
says "--start whole/egformer.safetensors: not used"
cmp -s whole/egformer.safetensors parts/egformer.safetensors || fail "--start changed a training that goes on"

# One folder, one training.
expect 2 "$fastscene" depth train --painted 1 --steps 4 "${small[@]}" --channels 8 -o parts
expect 2 "$fastscene" depth train --steps 4 --height 33 -o other
says "--height"
expect 1 "$fastscene" depth train --data . --steps 4 -o other
says "expected panoramas with range"
expect 1 "$fastscene" depth train --start nowhere.pkl --steps 4 "${small[@]}" -o started
says "nowhere.pkl"

# Two processes, one network; figures and the folder are the first one's alone.
port=$((20000 + RANDOM % 20000))
"$fastscene" depth train --painted 1 --steps 4 "${small[@]}" -o two --processes 2 --process 1 --meet "localhost:$port" >second 2>second.log </dev/null &
second=$!
expect 0 "$fastscene" depth train --painted 1 --steps 4 "${small[@]}" -o two --processes 2 --process 0 --meet "localhost:$port"
prints "two/egformer.safetensors: 4 steps; held out"
wait "$second" || fail "the second process: $(tail -n 3 second.log)"
grep -q "held out" second && fail "the second process tells figures of nothing: $(cat second)"
grep -qF "done, 4 steps; process 0 saves the network" second || fail "the second process says: $(cat second)"

# Our own rooms as data, and what the network makes of them.
expect 0 "$fastscene" rooms dataset --count 24 --views 1 --size 64x32 --cell 0.4 --cell-samples 2 --pixel-samples 1 --outside-detail 0 -o rooms
expect 0 "$fastscene" depth train --data rooms --painted 0.5 --steps 2 "${small[@]}" -o taught
expect 0 "$fastscene" depth check --data rooms --depth-weights taught/egformer.safetensors --json
prints '"backend": "egformer"'
says "expected 50 held-out places, found 2: --all takes all"
expect 0 "$fastscene" depth check --data rooms --all --count 24 --depth-backend layout
prints "layout, 24 places"
expect 0 "$fastscene" depth check --data rooms --depth-backend layout
prints "layout"
cp -r rooms broken_rooms
for file in broken_rooms/shard-00000/*.range.*; do head -c 100 "$file" >cut && cp cut "$file"; done
expect 1 "$fastscene" depth check --data broken_rooms --depth-backend layout
says "broken_rooms: expected held-out pictures with range, found none of"
cp rooms/shard-00000/00000009.range.* broken_rooms/shard-00000/
expect 0 "$fastscene" depth check --data broken_rooms --depth-backend layout
prints "more cannot be used)"
expect 2 "$fastscene" depth check --data rooms --depth-backend exact

picture=$(ls rooms/shard-00000/*.color.jpg | head -n 1)
expect 0 "$fastscene" make --panorama "$picture" --depth-weights taught/egformer.safetensors -o scene "${tiny[@]}"
has scene/depth/range.exr scene/splat/scene.ply
