# Sourced by ./fastscene and ./test: installs what is missing and builds. Needs bash and apt only.
# `root` is the checkout. Everything said here goes to stderr.

say() { printf '%s\n' "fastscene: $*" >&2; }
fail() { say "$*"; exit 1; }

# Runs a command as root.
as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"
  elif command -v sudo >/dev/null; then sudo "$@"
  else fail "needs root or sudo to run: $*"
  fi
}

# Runs a command with its output in a log, shown only when it fails.
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if [ "$status" != 0 ]; then tail -n 60 "$log" >&2; fi
  rm -f "$log"
  return "$status"
}

# The packages of the named lists that dpkg does not know to be installed.
missing_packages() {
  local package
  sed 's/#.*//' "$@" | while read -r package; do
    [ -n "$package" ] || continue
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || printf '%s\n' "$package"
  done
}

apt_install() {
  export DEBIAN_FRONTEND=noninteractive
  [ -z "$apt_is_fresh" ] && { quietly as_root apt-get update || fail "apt-get update failed: is the network there?"; }
  apt_is_fresh=1
  quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@" || fail "apt-get install failed"
}
apt_is_fresh=

# install_packages LIST…
install_packages() {
  command -v dpkg-query >/dev/null || { say "not a Debian system: the packages named in packaging/*.txt must be there already"; return 0; }
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" = 0 ] && return 0
  say "installing ${#missing[@]} Debian packages (some minutes, once): ${missing[*]}"
  apt_install "${missing[@]}"
}

# install_npm [--omit=dev]: the viewer's page, and without --omit=dev the readers that the tests ask, exactly as
# web/package-lock.json pins them.
install_npm() {
  local lock=$root/web/package-lock.json modules=$root/web/node_modules
  local last=$modules/@playcanvas/splat-transform/package.json
  if [ "${1:-}" = --omit=dev ]; then last=$modules/@playcanvas/supersplat-viewer/package.json; fi
  [ -f "$last" ] && [ -f "$modules/.complete" ] && cmp -s "$lock" "$modules/.complete" && return 0
  local missing=()
  command -v node >/dev/null || missing+=(nodejs)
  command -v npm >/dev/null || missing+=(npm)
  if [ "${#missing[@]}" != 0 ]; then
    say "installing ${missing[*]} (once)"
    apt_install "${missing[@]}"
  fi
  say "installing the npm packages of web/ (once)"
  (cd "$root/web" && quietly npm ci --ignore-scripts --no-audit --no-fund "$@") || fail "npm ci failed in web/: is the network there?"
  cp "$lock" "$modules/.complete"
}

# Which of CMakePresets.json is built.
preset=release

# A release build is for processors with AVX2 (FASTSCENE_ARCH); one without gets a build of its own.
lacks_avx2() { [ "$(uname -m)" = x86_64 ] && ! { grep -qw avx2 /proc/cpuinfo && grep -qw fma /proc/cpuinfo; }; }

# configure ON|OFF: with or without the tests (which need packages of their own). A build with them serves both.
configure() {
  local build=$root/build/$preset arch=()
  if lacks_avx2; then arch=(-DFASTSCENE_ARCH=x86-64-v2); fi
  if [ -f "$build/build.ninja" ] && { [ "$1" = OFF ] || grep -q '^FASTSCENE_TESTS:BOOL=ON' "$build/CMakeCache.txt"; } &&
    { [ "${#arch[@]}" = 0 ] || grep -q '^FASTSCENE_ARCH:[A-Z]*=x86-64-v2' "$build/CMakeCache.txt"; }; then return 0; fi
  say "configuring"
  # A half-made build folder of an earlier try would be believed.
  [ -f "$build/build.ninja" ] || rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  (cd "$root" && quietly cmake --preset "$preset" -DFASTSCENE_TESTS="$1" "${arch[@]}") || fail "cmake failed"
}

# build_targets TARGET…: ninja finds out what has changed (a few hundredths of a second when nothing has).
build_targets() {
  local build=$root/build/$preset
  local log last=-1 status=0 line done total
  log=$(mktemp)
  # ninja says [12/120] before each step: a line of ours each tenth of a long build, none for a short one.
  { ninja -C "$build" "$@" </dev/null 2>&1 || echo "ninja failed"; } | while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
    done=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
    if [ "$total" -gt 5 ] && [ $((10 * done / total)) -gt "$last" ]; then
      last=$((10 * done / total))
      say "building, step $done of $total"
    fi
  done
  if [ "$(tail -n 1 "$log")" = "ninja failed" ]; then status=1; tail -n 60 "$log" >&2; fi
  rm -f "$log"
  [ "$status" = 0 ] || fail "the build failed"
}

# Whether everything was installed for this state of the lists; keeps the second start quick and off the network.
stamp_is_good() {
  local stamp=$root/build/installed-$1; shift
  [ -f "$stamp" ] || return 1
  local file
  for file in "$@"; do [ "$file" -nt "$stamp" ] && return 1; done
  return 0
}
set_stamp() { mkdir -p "$root/build" && touch "$root/build/installed-$1"; }
