#!/usr/bin/env bash
# pip installs the package offline into an environment of its own.     pip.sh PYTHON SOURCE_DIR BUILD_DIR WORK_FOLDER
set -euo pipefail
python=$1 source=$2 build=$3 work=$4
"$python" -c 'import ensurepip, setuptools, wheel' 2>/dev/null || { echo "pip: skipped, no python3-venv"; exit 77; }
rm -rf "$work" && mkdir -p "$work"
# A copy: pip writes into the tree that it builds.
mkdir "$work/tree"
cp -r "$source/python" "$source/pyproject.toml" "$source/setup.py" "$work/tree"
"$python" -m venv --system-site-packages "$work/venv"
FASTSCENE_BUILD_DIR=$build PIP_NO_INDEX=1 "$work/venv/bin/pip" install --no-build-isolation -q "$work/tree"
cd "$work"
PYTHONPATH= "$work/venv/bin/python" -c '
import fastscene, os, sys
assert fastscene.__file__.startswith(sys.prefix), fastscene.__file__
assert os.path.exists(os.path.join(os.path.dirname(fastscene.__file__), "py.typed"))
print(fastscene.__version__, fastscene.Pinhole.with_fov(8, 8, 90))'
