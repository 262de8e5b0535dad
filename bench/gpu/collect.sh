#!/usr/bin/env bash
# collect.sh FOLDER: what bench/gpu needs of Debian's packages besides a compiler and libtorch, as include/ and lib/ for
# a machine that has none of it (-DFASTSCENE_DEPENDENCIES=FOLDER). About 10 MB.
set -euo pipefail
to=${1:?"a folder"}
rm -rf "$to/include" "$to/lib"
mkdir -p "$to/include" "$to/lib"
for headers in fmt nlohmann oneapi tbb CLI unicode gtest zlib.h zconf.h; do
  for place in /usr/include /usr/include/"$(gcc -print-multiarch)"; do
    if [ -e "$place/$headers" ]; then
      cp -rL "$place/$headers" "$to/include/"
      break
    fi
  done
  [ -e "$to/include/$headers" ] || { echo "collect.sh: expected $headers in /usr/include, found none" >&2; exit 1; }
done
for library in fmt tbb icuuc z; do
  file=$(gcc -print-file-name="lib$library.so")
  cp "$(readlink -f "$file")" "$to/lib/$(objdump -p "$(readlink -f "$file")" | awk '/SONAME/ {print $2}')"
  ln -s "$(basename "$(ls "$to"/lib/lib"$library".so.*)")" "$to/lib/lib$library.so"
done
cp "$(gcc -print-file-name=libgtest.a)" "$to/lib/"
# ICU's tables are 30 MB. What a tokenizer asks of letters lies in libicuuc itself: an empty table is enough.
uc=$(ls "$to"/lib/libicuuc.so.*)
data=$(objdump -p "$uc" | awk '/NEEDED.*icudata/ {print $2}')
table=$(nm -D "$uc" | awk '/icudt/ {print $2}')
echo "const unsigned char $table[64] = {0};" | gcc -shared -fPIC -x c - -Wl,-soname,"$data" -o "$to/lib/$data"
du -sh "$to" | cut -f1
