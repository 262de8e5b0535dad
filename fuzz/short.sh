#!/usr/bin/env bash
# The small form for the tests: each reader for two seconds, in the build that fuzz/run makes. Skipped without Clang.
set -euo pipefail
command -v clang++ >/dev/null || { echo "fuzz: skipped: clang is not installed"; exit 77; }
[ -x "${FUZZ_BUILD:-$(dirname "$0")/../build/fuzz}/bin/fuzz_readers" ] || { echo "fuzz: skipped: ./fuzz/run builds the readers first"; exit 77; }
exec "$(dirname "$0")/run" 1
