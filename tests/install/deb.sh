#!/usr/bin/env bash
# Packs the build, unpacks the program's package into an empty folder, and makes a tiny scene there. No file of the
# checkout may be opened.     deb.sh BUILD_DIR SOURCE_DIR
set -euo pipefail
build=$1 source=$2
# Outside the checkout, so that every path within it is a fault.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "deb: $*" >&2; exit 1; }
for tool in dpkg-deb dpkg-shlibdeps strace; do
  command -v "$tool" >/dev/null || { echo "deb: skipped, no $tool"; exit 77; }
done
(cd "$build" && cpack -G DEB -B "$work/packages") >"$work/cpack.log" 2>&1 || { tail -n 30 "$work/cpack.log" >&2; fail "cpack failed"; }
package=$(ls "$work"/packages/fastscene_*.deb)
depends=$(dpkg-deb -f "$package" Depends)
for library in libc6 libembree3 libtorch; do
  [[ $depends == *"$library"* ]] || fail "Depends: expected $library, found $depends"
done
dpkg-deb -x "$package" "$work/root"
usr=$work/root/usr
for file in bin/fastscene share/man/man1/fastscene.1 share/man/man1/fastscene-make.1 \
  share/bash-completion/completions/fastscene share/zsh/vendor-completions/_fastscene \
  share/fish/vendor_completions.d/fastscene.fish share/man/man1/fastscene-completion.1 share/doc/fastscene/copyright; do
  [ -s "$usr/$file" ] || [ -s "$usr/$file.gz" ] || fail "not in the package: $file"
done

cd "$work"
# The program starts anew to set what its libraries read: strace follows.
strace -f -qq -e trace=openat,open,execve,newfstatat,readlink -o trace.txt "$usr/bin/fastscene" make "a bedroom" --quality draft \
  --panorama-width 256 --views-size 64 --splat-steps 20 --splat-count 5000 --walk-viewpoints 1 -o scene >made.txt 2>said.txt ||
  { tail -n 20 said.txt >&2; fail "the unpacked program made no scene"; }
[ -s scene/splat/scene.ply ] || fail "no scene.ply"
if [ -d "$usr/share/fastscene/supersplat-viewer" ]; then [ -s scene/viewer.html ] || fail "no viewer.html"; fi
opened=$(grep -F "\"$source/" trace.txt | grep -v ENOENT || true)
[ -z "$opened" ] || fail "files of the checkout were looked at: $(head -n 3 <<<"$opened")"
