# A small draft on a graphics card, as Mesa's lavapipe imitates one: as good as on the processor; pictures; what runs
# where.
. "$(dirname "$0")/lib.sh"
card=(--splat-backend vulkan --splat-device llvmpipe)
# The first steps of a small scene: an imitated card is a hundred times slower than the processor. Before step 100 no
# splat is moved elsewhere, so more of them are only more of the same.
short=(--quality draft --panorama-width 512 --panorama-cell 0.12 --panorama-cell-samples 64 --panorama-outside-detail 0
  --walk-viewpoints 4 --walk-room-viewpoints 6 --views-size 128 --views-points 60000
  --splat-count 30000 --splat-steps 40 --splat-eval-every 40)
held_out() { tail -n 1 "$1/splat/curve.csv" | cut -d, -f4; }

expect 0 "$fastscene" make "$prompt" -o run "${short[@]}"
grep -q '"device": "processor"' run/report.json || fail "report.json does not say that the processor trained the splats"
processor=$(held_out run)
expect 0 "$fastscene" splat run "${short[@]}" "${card[@]}"
says "panorama: already made"
grep -q '"device": "llvmpipe' run/report.json || fail "report.json does not say what trained the splats"
card_psnr=$(held_out run)
# Measured: 0.001 to 0.003 dB.
awk "BEGIN { d = $card_psnr - $processor; exit !(d < 0.02 && d > -0.02) }" ||
  fail "held-out views: $card_psnr dB on the card, $processor dB on the processor"

# Pictures of the same splats, within a level or so of a byte.
expect 0 "$fastscene" render run --size 320x180 -o on_processor.png
expect 0 "$fastscene" render run --size 320x180 --backend vulkan --device 0 -o on_card.png
expect 0 "$fastscene" render run --sphere --size 256x128 --backend vulkan --device llvm -o sphere.png
mkdir -p a b && mv on_processor.png a/x.png && mv on_card.png b/x.png
expect 0 "$fastscene" metrics images a --reference b --json
python3 -c 'import json; exit(json.load(open("out"))["mean"]["psnr"] < 50)' || fail "the card's picture is another one"

# Never an imitated card unless it is asked for; unknown ones are answered with those that there are.
expect 2 "$fastscene" render run --backend vulkan
says "--device auto: expected a graphics card with a Vulkan driver"
says "llvmpipe"
expect 2 "$fastscene" splat run "${short[@]}" --splat-backend vulkan --splat-device 7
says "--splat-device 7: expected auto, a number or part of a name"
# … before the first stage begins.
expect 2 "$fastscene" make "$prompt" -o p --panorama-trace-backend vulkan
says "--panorama-trace-device auto: expected a graphics card with a Vulkan driver"
expect 2 "$fastscene" make "$prompt" -o p --panorama-trace-device list
says "--panorama-trace-device list: found"
says "llvmpipe"
expect 2 "$fastscene" make "$prompt" -o p --splat-device list
says "--splat-device list: found"
lacks p
expect 2 "$fastscene" render run --of room --backend vulkan
says "--backend: expected with --of splats"
VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent expect 2 "$fastscene" render run --backend vulkan --device 0
says "found no device"
expect 0 "$fastscene" doctor
prints "graphics card"
