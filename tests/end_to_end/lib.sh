# Sourced by the end-to-end tests: bash NAME.sh PROGRAM EMPTY_FOLDER. Each check says what it wants; the first that fails ends the test.
set -u
fastscene=$1 work=$2
# Not the models that whoever runs this has pulled.
export FASTSCENE_MODELS=$work/models
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1

# The whole stream in a few seconds.
tiny=(--panorama-width 128 --panorama-cell 0.25 --panorama-cell-samples 8 --panorama-pixel-samples 2 --panorama-outside-detail 0 --walk-viewpoints 2 --walk-room-viewpoints 2
  --views-size 48 --views-points 4000 --splat-count 2000 --splat-steps 20)
prompt="a cozy bedroom with a red armchair and a large window"

fail() { echo "FAILED: $*" >&2; [ -f log ] && tail -n 20 log >&2; exit 1; }
# expect CODE COMMAND…: runs it with its output in out and log, and wants this exit code.
expect() {
  local code=$1 got=0; shift
  "$@" >out 2>log </dev/null || got=$?
  [ "$got" = "$code" ] || fail "exit code $got, expected $code: $*"
}
# says TEXT: the last command said this on stderr.
says() { grep -qF -- "$1" log || fail "stderr lacks \"$1\""; }
prints() { grep -qF -- "$1" out || fail "stdout lacks \"$1\""; }
has() { local f; for f in "$@"; do [ -s "$f" ] || fail "missing or empty: $f"; done; }
lacks() { local f; for f in "$@"; do [ ! -e "$f" ] || fail "should not be there: $f"; done; }
# Everything of a run but what it cost: names and hashes.
contents() { (cd "$1" && find . -type f ! -name stage.json ! -name report.json ! -name run.json -exec sha256sum {} + | sort -k2); }
same() { diff <(contents "$1") <(contents "$2") >log || fail "$1 and $2 differ"; }
no_rest() { local rest; rest=$(find "$1" -name '*.part*'); [ -z "$rest" ] || fail "left over: $rest"; }
