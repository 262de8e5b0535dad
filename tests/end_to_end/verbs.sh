# The verbs that look at a finished run.
. "$(dirname "$0")/lib.sh"

expect 0 "$fastscene" make "$prompt" -o run "${tiny[@]}"

# A picture: from the same place the same, from elsewhere another; sizes and names are kept.
expect 0 "$fastscene" render run --size 80x60 -o a.png
expect 0 "$fastscene" render run/splat/scene.ply --size 80x60 -o b.png
cmp -s a.png b.png || fail "the folder and its .ply give other pictures"
expect 0 "$fastscene" render run --size 80x60 --yaw 90 -o c.png
! cmp -s a.png c.png || fail "the camera did not turn"
expect 0 "$fastscene" render run --size 80x60 --position 0.1 -0.1 0.1 --pitch -10 --fov 60 -o d.jpg
has d.jpg
expect 2 "$fastscene" render run --size 80 -o a.png
expect 2 "$fastscene" render run --fov 200 -o a.png
expect 2 "$fastscene" render run -o a.bmp
expect 2 "$fastscene" render .

# A film.
echo '{"fps": 4, "size": [64, 48], "keys": [{"position_m": [0, 0, 0]}, {"time_s": 1, "position_m": [0.1, 0, 0.1], "yaw_deg": 90}]}' >path.json
expect 0 "$fastscene" render run --path path.json -o film
[ "$(ls film | wc -l)" = 5 ] || fail "expected 5 frames"
if command -v ffmpeg >/dev/null; then has film.mp4; prints film.mp4; fi
echo '{"keys": []}' >bad.json
expect 1 "$fastscene" render run --path bad.json -o film
says bad.json

# The server on 127.0.0.1: says where it is, serves the splats whole and in part, ends on SIGTERM.
"$fastscene" view run --port 0 >out 2>log &
pid=$!
for i in $(seq 100); do grep -q http out && break; sleep 0.1; done
address=$(cat out)
get() { # PATH FILE [RANGE]: a bare HTTP client, in case there is no curl
  local port=${address##*:}; port=${port%/}
  exec 3<>"/dev/tcp/127.0.0.1/$port" || fail "no server at $address"
  printf 'GET %s HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n%s\r\n' "$1" "${3:+Range: bytes=$3$'\r\n'}" >&3
  cat <&3 >"$2"; exec 3<&-
}
get /splat/scene.compressed.ply whole
head -1 whole | grep -q ' 200 ' || fail "the server said: $(head -1 whole)"
tail -c "$(stat -c %s run/splat/scene.compressed.ply)" whole | cmp -s - run/splat/scene.compressed.ply || fail "the server changed the splats"
get /splat/scene.compressed.ply part 0-9
head -1 part | grep -q ' 206 ' || fail "the server said to a range: $(head -1 part)"
get / page
head -1 page | grep -qE ' (200|302) ' || fail "the server said: $(head -1 page)"
get /../../../../etc/passwd outside
head -1 outside | grep -qE ' 40[0-9] ' || fail "the server left its folder: $(head -1 outside)"
expect 1 "$fastscene" view run --port "$(echo "${address%/}" | sed 's/.*://')"
kill -TERM "$pid"
code=0; wait "$pid" || code=$?
[ "$code" = 0 ] || [ "$code" = 143 ] || fail "exit code $code after SIGTERM"

# Truth on two poses: figures are there and make sense.
expect 0 "$fastscene" metrics run --truth --views 2 --radius 0.2 --json
has run/metrics/report.json
grep -q '"psnr_mean"' run/metrics/report.json || fail "no psnr_mean"
expect 2 "$fastscene" metrics run
expect 2 "$fastscene" metrics run --truth --samples 3
says "--samples"

# Help and doctor.
expect 0 "$fastscene" --help
for verb in make panorama depth walk views splat metrics render view doctor version; do
  prints "$verb"
done
for verb in make panorama depth walk views splat metrics render view doctor version; do
  expect 0 "$fastscene" "$verb" --help
  prints "--threads"
  expect 0 "$fastscene" --help
done
expect 0 "$fastscene" make --help
prints "--splat-steps N=3000"
expect 0 "$fastscene" doctor
prints threads
expect 0 "$fastscene" doctor --json
prints '"remedy"'
expect 0 "$fastscene" version
prints fastscene
exit 0
