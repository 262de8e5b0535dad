#!/usr/bin/env bash
# shared.sh GOLDEN SET NETWORK…: holds these networks against the set, or says that there is none.
set -euo pipefail
golden=$1 set=$2
shift 2
[ -d "$set" ] || { echo "skipped: no golden set at $set"; exit 77; }
exec "$golden" --set "$set" --only "$@"
