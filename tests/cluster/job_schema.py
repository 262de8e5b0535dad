#!/usr/bin/env python3
"""The Kubernetes job is one: kubectl's own types take it without a change, so no field is misspelt or misplaced; and
what the API server would refuse besides is not in it: required fields, words and names as the API's reference says.

  tests/cluster/job_schema.py JOB_YAML
"""
import copy
import json
import re
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


LABEL = re.compile(r"[a-z0-9]([-a-z0-9]{0,61}[a-z0-9])?$")


def unknown_fields(job):
    """Sentences about fields that kubectl's types lack, or cannot hold."""
    done = subprocess.run(["kubectl", "set", "env", "--local", "-f", "-", "-o", "json", "CHECKED=yes"],
                          input=json.dumps(job), capture_output=True, text=True)
    if done.returncode != 0:
        return [done.stderr.strip()]
    return [f"{place}: expected a field of a Job, found none of that name or value"
            for place in missing(job, json.loads(done.stdout))]


def refused(job):
    """Sentences about what an API server refuses."""
    found = []

    def want(is_good, place, expected, value):
        if not is_good:
            found.append(f"{place}: expected {expected}, found {value}")

    spec = job.get("spec", {})
    pod = spec.get("template", {}).get("spec", {})
    want(job.get("apiVersion") == "batch/v1" and job.get("kind") == "Job", ".kind", "Job of batch/v1", job.get("kind"))
    want(spec.get("completionMode") == "Indexed", ".spec.completionMode", "Indexed", spec.get("completionMode"))
    want(isinstance(spec.get("completions"), int), ".spec.completions", "a number: needed if Indexed",
         spec.get("completions"))
    want(pod.get("restartPolicy") in ("Never", "OnFailure"), ".restartPolicy", "Never or OnFailure",
         pod.get("restartPolicy"))
    want(pod.get("containers"), ".containers", "at least one", pod.get("containers"))
    volumes = {volume.get("name") for volume in pod.get("volumes", [])}
    for container in pod.get("containers", []):
        want(LABEL.match(container.get("name", "")), ".containers.name", "a DNS label", container.get("name"))
        want(container.get("image"), ".containers.image", "an image", container.get("image"))
        for mount in container.get("volumeMounts", []):
            want(mount.get("name") in volumes, ".volumeMounts.name", f"one of {sorted(volumes)}", mount.get("name"))
            want(mount.get("mountPath"), ".volumeMounts.mountPath", "a path", mount.get("mountPath"))
        resources = container.get("resources", {})
        for kind, most in resources.get("limits", {}).items():
            least = resources.get("requests", {}).get(kind, most)
            want(least == most or kind != "memory", f".resources.{kind}", "a request of no more than its limit", least)
    return found


# A check that cannot fail is none: each of these must be found.
BROKEN = {
    "a misspelt field": lambda job: job["spec"].update(completionmode="Indexed"),
    "a misplaced field": lambda job: job["spec"].update(restartPolicy="Never"),
    "a text for a number": lambda job: job["spec"].update(parallelism="four"),
    "no restart policy": lambda job: job["spec"]["template"]["spec"].pop("restartPolicy"),
    "a mount of no volume": lambda job: job["spec"]["template"]["spec"]["volumes"].pop(),
}


def main(path):
    if not shutil.which("kubectl"):
        print("skipped: no kubectl (for example of the package kubernetes-client)")
        return 77
    with open(path) as file:
        job = yaml.safe_load(file)
    problems = unknown_fields(job) + refused(job)
    for problem in problems:
        print(f"{path}: {problem}", file=sys.stderr)
    for name, spoil in BROKEN.items():
        broken = copy.deepcopy(job)
        spoil(broken)
        if not unknown_fields(broken) + refused(broken):
            problems.append(name)
            print(f"{name} is not found by this check", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
