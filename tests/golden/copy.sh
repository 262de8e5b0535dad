#!/usr/bin/env bash
# copy.sh GOLDEN COPY ORIGINAL: is the copy true? Skipped where there is no original.
set -euo pipefail
[ -d "$3" ] || { echo "skipped: no golden set at $3"; exit 77; }
exec "$1" --set "$2" --copy-of "$3"
