#!/usr/bin/env bash
# Brings what another system made into the form that `fastscene evaluate --peer NAME=DIR` measures: DIR/SCENE/NN.png, DIR/SCENE/source.png or DIR/SCENE.ply.
#   bench/peers/collect.sh SYSTEM FROM SCENE DIR [MINUTES]
# SYSTEM: text2room, scenescape, set-the-scene, perf, hunyuanworld, worldgen, pictures (a folder), video (a file), splats (a .ply) or
# sphere (a 2:1 picture all around from the source panorama's place, as large as that: what paper-table3 compares).
# FROM: what that system left: its output folder, or the file itself.   SCENE: the scene's name in the suite (evaluate SUITE --show).
# MINUTES: what the scene took there; goes into DIR/SCENE/minutes.txt.  PICTURES=30: how many to take, spread over all of them.
# Those systems are run by their own programs, on their own machines; nothing of them is fetched here.
set -euo pipefail
fail() { echo "collect.sh: $*" >&2; exit 1; }
[ $# -ge 4 ] || { sed -n '2,8s/^# //p' "$0" >&2; exit 2; }
system=$1 from=$2 scene=$3 dir=$4 minutes=${5:-} wanted=${PICTURES:-30}
whole='^[1-9][0-9]{0,5}$' number='^[0-9]+([.][0-9]+)?$'
[[ $wanted =~ $whole ]] || fail "PICTURES=$wanted: expected a whole number from 1"
[[ -z $minutes || $minutes =~ $number ]] || fail "MINUTES: expected a number of minutes, found $minutes"
case $scene in '' | . | .. | */*) fail "SCENE: expected the name of a scene, found \"$scene\"" ;; esac
[ -e "$from" ] || fail "$from: expected what $system left, found nothing"
mkdir -p "$dir"

# take_pictures FILE…: WANTED of them, evenly spread, as NN.png or NN.jpg.
take_pictures() {
  local count=$# i=0 at
  [ "$count" -gt 0 ] || fail "$from: expected pictures, found none"
  mkdir -p "$dir/$scene"
  find "$dir/$scene" -maxdepth 1 -type f -name '[0-9]*' -delete  # of an earlier call; source.png and minutes.txt stay
  while [ "$i" -lt "$wanted" ] && [ "$i" -lt "$count" ]; do
    at=$((i * count / (wanted < count ? wanted : count) + 1))
    cp "${!at}" "$dir/$scene/$(printf '%03d' "$i").${!at##*.}"
    i=$((i + 1))
  done
  echo "$dir/$scene: $i of $count pictures"
}
from_folder() {
  local files
  mapfile -t files < <(find "$1" -maxdepth 1 -type f \( -iname '*.png' -o -iname '*.jpg' -o -iname '*.jpeg' \) | sort -V)
  take_pictures ${files[@]+"${files[@]}"}
}
from_video() {
  command -v ffmpeg >/dev/null || fail "a video needs ffmpeg: apt-get install ffmpeg"
  case $1 in *.mp4 | *.avi | *.mov | *.webm | *.mkv) ;; *) fail "$1: expected a video (.mp4 .avi .mov .webm .mkv)" ;; esac
  local frames; frames=$(mktemp -d)
  ffmpeg -nostdin -loglevel error -i "$1" "$frames/%05d.png" || { rm -rf "$frames"; fail "$1: ffmpeg cannot read it"; }
  from_folder "$frames"; rm -rf "$frames"
}
from_splats() {
  head -c 4000 "$1" | grep -aq 'f_dc_0' || fail "$1: expected Gaussian splats (f_dc_0 in the header), found another PLY: a mesh is rendered by its own system, and its pictures brought here"
  cp "$1" "$dir/$scene.ply"
  echo "$dir/$scene.ply"
}
from_sphere() {
  case $1 in *.png | *.jpg | *.jpeg) ;; *) fail "$1: expected a .png or .jpg" ;; esac
  mkdir -p "$dir/$scene"
  rm -f "$dir/$scene"/source.*
  cp "$1" "$dir/$scene/source.${1##*.}"
  echo "$dir/$scene/source.${1##*.}"
}
# first_of PATTERN…: the newest file or folder below FROM that matches the first pattern that anything matches.
first_of() {
  local pattern found
  for pattern in "$@"; do
    found=$(find "$from" -path "$from/$pattern" -printf '%T@ %p\n' 2>/dev/null | sort -rn | head -1 | cut -d' ' -f2-)
    [ -n "$found" ] && { echo "$found"; return; }
  done
  fail "$from: expected one of $* below it, found none"
}
any() {  # a folder of pictures, a video, splats, whatever it is
  case $1 in *.ply) from_splats "$1" ;; *.mp4 | *.avi | *.mov | *.webm) from_video "$1" ;; *) from_folder "$1" ;; esac
}

case $system in
  pictures) from_folder "$from" ;;
  video) from_video "$from" ;;
  splats) from_splats "$from" ;;
  sphere) from_sphere "$from" ;;
  # Where each leaves its final pictures or splats, as its own program writes them.
  text2room)  # output/…/TIME/output_rendering/rendering_T.png; rendering_noise_T.png are of shaken poses
    folder=$(first_of output_rendering '*/output_rendering')
    mapfile -t files < <(find "$folder" -maxdepth 1 -name 'rendering_[0-9]*.png' | sort -V)
    take_pictures ${files[@]+"${files[@]}"} ;;
  scenescape) found=$(first_of images/frames '*/images/frames'); from_folder "$found" ;;
  set-the-scene) found=$(first_of 'results/images' '*/results/images' 'results/*_rgb_*.mp4' '*/results/*_rgb_*.mp4'); any "$found" ;;
  perf) found=$(first_of video.mp4 '*/video.mp4'); any "$found" ;;
  worldgen) found=$(first_of splat.ply '*.ply' '*.mp4'); any "$found" ;;
  hunyuanworld)  # layered meshes: pictures of them, rendered by whoever shows them
    found=$(first_of renders '*/renders' '*.mp4'); any "$found" ;;
  *) fail "unknown system $system: expected text2room, scenescape, set-the-scene, perf, hunyuanworld, worldgen, pictures, video, splats or sphere" ;;
esac
[ -z "$minutes" ] || { mkdir -p "$dir/$scene"; echo "$minutes" >"$dir/$scene/minutes.txt"; }
