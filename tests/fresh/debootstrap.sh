#!/usr/bin/env bash
# The README's two commands in a minimal Debian 12 where nothing was installed, on a clean clone.
#   sudo tests/fresh/debootstrap.sh [--quick] [--prompt TEXT] [--seed N] [--keep]
# Needs root, debootstrap and the network. --quick makes a draft and runs no tests. --keep leaves the system for a look.
# Not part of ./test: it downloads some 400 MB and takes half an hour.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
quick= keep= prompt="a cozy bedroom with a red armchair and a large window" seed=0
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=1 ;;
    --keep) keep=1 ;;
    --prompt) prompt=$2; shift ;;
    --seed) seed=$2; shift ;;
    *) echo "unknown argument $1" >&2; exit 2 ;;
  esac
  shift
done
[ "$(id -u)" = 0 ] || { echo "needs root" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "needs debootstrap: apt-get install debootstrap" >&2; exit 2; }

root=$(mktemp -d "${TMPDIR:-/tmp}/fastscene-fresh.XXXXXX")
cleanup() {
  umount "$root/proc" 2>/dev/null || true
  if [ -z "$keep" ]; then rm -rf --one-file-system "$root"; else echo "kept: $root" >&2; fi
}
trap cleanup EXIT

echo "== a minimal Debian 12 in $root" >&2
debootstrap --variant=minbase bookworm "$root" >"$root.log" 2>&1 || { tail "$root.log" >&2; exit 1; }
rm -f "$root.log"
# The network as this machine reaches it.
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
cp -L /etc/hosts "$root/etc/hosts"
if ls /etc/apt/apt.conf.d/*proxy* >/dev/null 2>&1; then cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/"; fi
if [ -n "${NODE_EXTRA_CA_CERTS:-}" ]; then cp -L "$NODE_EXTRA_CA_CERTS" "$root/etc/network-ca.crt"; fi
mount -t proc proc "$root/proc"
git clone -q --no-local "$here" "$root/fastscene"

inside() { # COMMAND…: in the new system, with an environment of its own
  env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    ${npm_config_registry:+npm_config_registry="$npm_config_registry"} \
    ${NODE_EXTRA_CA_CERTS:+NODE_EXTRA_CA_CERTS=/etc/network-ca.crt} \
    chroot "$root" bash -c 'cd /fastscene && "$@"' inside "$@" </dev/null
}
disk() { du -sxm "$root" | cut -f1; }
before=$(disk)

echo "== ./fastscene make" >&2
start=$SECONDS
inside ./fastscene make "$prompt" --seed "$seed" -o out/fresh ${quick:+--quality draft}
echo "== made after $((SECONDS - start)) s, $(($(disk) - before)) MB of disk" >&2
run=$root/fastscene/out/fresh
for file in run.json report.json viewer.html preview.jpg credits.txt panorama/{color.png,prompt.json,room.json} depth/range.exr \
  walk/poses.json walk/000/{color.png,range.exr,known.png} views/transforms.json views/sparse/0/{cameras,images,points3D}.{txt,bin} \
  splat/{scene.ply,scene.compressed.ply,curve.json}; do
  [ -s "$run/$file" ] || { echo "missing: $file" >&2; exit 1; }
done

echo "== the second time, off the network" >&2
start=$SECONDS
inside env http_proxy=http://127.0.0.1:9 https_proxy=http://127.0.0.1:9 ./fastscene make "$prompt" --seed "$seed" -o out/fresh ${quick:+--quality draft}
[ $((SECONDS - start)) -le 10 ] || { echo "the second start took $((SECONDS - start)) s" >&2; exit 1; }

if [ -z "$quick" ]; then
  echo "== ./test" >&2
  start=$SECONDS
  inside ./test
  echo "== tested after $((SECONDS - start)) s, $(($(disk) - before)) MB of disk in all" >&2
fi
echo "all is well" >&2
