#!/usr/bin/env python3
"""The Kubernetes job is one: kubectl's own types take it without a change, so no field is misspelt or misplaced.

  tests/cluster/job_schema.py JOB_YAML
"""
import json
import shutil
import subprocess
import sys

try:
    import yaml
except ImportError:
    print("skipped: no python3-yaml")
    sys.exit(77)


def missing(wanted, found, place=""):
    """Places in `wanted` that `found` lacks."""
    if isinstance(wanted, dict):
        if not isinstance(found, dict):
            return [place]
        return [m for key, value in wanted.items() for m in missing(value, found.get(key), f"{place}.{key}")]
    if isinstance(wanted, list):
        if not isinstance(found, list) or len(found) != len(wanted):
            return [place]
        return [m for i, value in enumerate(wanted) for m in missing(value, found[i], f"{place}[{i}]")]
    return [] if wanted == found else [place]


def main(path):
    if not shutil.which("kubectl"):
        print("skipped: no kubectl")
        return 77
    done = subprocess.run(["kubectl", "set", "env", "--local", "-f", path, "-o", "json", "CHECKED=yes"],
                          capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stderr, file=sys.stderr)
        return 1
    with open(path) as file:
        lost = missing(yaml.safe_load(file), json.loads(done.stdout))
    for place in lost:
        print(f"{path}: {place}: expected a field of a Job, found none of that name or value", file=sys.stderr)
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
