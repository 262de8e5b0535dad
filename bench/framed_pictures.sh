#!/bin/bash
# Makes the photographs and paintings that hang framed on walls: bench/framed_pictures.sh DRAW_OUTLOOKS FOLDER
# Views of the outside by our own tracer; some are turned to black and white, some painted by a filter.
set -eu
draw=$1 folder=$2 here=$(dirname "$0")
mkdir -p "$folder"
# name|prompt|seed|field of view|turn|pitch, degrees
while IFS='|' read -r name prompt seed fov turn pitch; do
  [ -s "$folder/$name.png" ] ||
    "$draw" "$prompt" --seed "$seed" --fov "$fov" --turn "$turn" --pitch "$pitch" -o "$folder/$name.png" </dev/null
done <<'LIST'
sea_day|a living room with a view of the sea|1|34|-9|3
sea_dusk|a living room with a view of the sea at dusk|3|40|0|4
sea_storm|a living room with a view of the sea on a rainy day|5|40|0|3
peaks|a living room with a view of the mountains|1|26|6|6
peaks_winter|a living room with a view of the mountains, snowy winter|2|38|20|6
peaks_evening|a living room with a view of the mountains in the evening|4|34|-5|5
birches|a living room with a forest view|1|40|4|4
misty_firs|a living room with a forest view in the fog|2|44|8|5
rooftops|a living room with a city view|2|44|20|8
city_night|a living room with a city view at night|1|48|0|10
garden|a living room with a garden view|3|44|0|1
street|a living room with a street view in the evening|2|46|0|3
LIST
exec python3 "$here/framed_pictures.py" "$folder"
