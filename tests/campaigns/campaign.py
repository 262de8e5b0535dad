"""What campaigns share: the commands that they disturb, at tiny sizes, and how results are compared."""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import time

PROMPT = "a cozy bedroom with a red armchair and a large window"
PANORAMA = ["--quality", "draft", "--panorama-width", "128", "--panorama-cell", "0.25", "--panorama-cell-samples", "8",
            "--panorama-pixel-samples", "2", "--panorama-outside-detail", "0"]
TINY = PANORAMA + ["--walk-viewpoints", "2", "--walk-room-viewpoints", "2", "--views-size", "48", "--views-points",
                   "4000", "--splat-count", "2000", "--splat-steps", "20"]
SPLAT = ["--quality", "draft", "--splat-count", "2000", "--splat-steps", "20"]
# Files with times, memory or paths: they differ between any two runs.
VARYING = {"stage.json", "report.json", "run.json", "index.html", "batch.jsonl", "manifest.json", "curves.csv",
           "training.json"}


class Failure(Exception):
    pass


class Campaign:
    """A folder with the program, its inputs, and what went wrong so far."""

    def __init__(self, about, flags=()):
        parser = argparse.ArgumentParser(description=about)
        parser.add_argument("program", help="the built fastscene")
        parser.add_argument("work", help="an empty folder, or one of an earlier campaign, whose inputs are used again")
        parser.add_argument("--rounds", type=int, default=3, help="disturbances per command; 0: as many as there are")
        parser.add_argument("--only", nargs="+", default=[], help="these commands")
        parser.add_argument("--seed", type=int, default=1, help="other moments, other numbers")
        for args, kwargs in flags:
            parser.add_argument(*args, **kwargs)
        self.args = parser.parse_args()
        self.program = str(pathlib.Path(self.args.program).resolve())
        self.work = pathlib.Path(self.args.work).resolve()
        self.work.mkdir(parents=True, exist_ok=True)
        self.inputs = self.work / "inputs"
        self.environment = dict(os.environ, FASTSCENE_MODELS=str(self.work / "models"), OMP_WAIT_POLICY="passive")
        self.failures, self.done = [], 0

    def run(self, args, code=None, environment=None, **kwargs):
        """Runs the program; text of stdout and stderr in .text. Wants this exit code, if one is given."""
        command = [self.program, *map(str, args)]
        result = subprocess.run(command, cwd=self.work, env={**self.environment, **(environment or {})},
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **kwargs)
        result.text = result.stdout.decode(errors="replace")
        if code is not None and result.returncode != code:
            raise Failure(f"exit code {result.returncode}, expected {code}: {' '.join(command)}\n{tail(result.text)}")
        return result

    def need(self, *names):
        """Makes the inputs that commands read: "run", "rooms", "holes"."""
        self.inputs.mkdir(exist_ok=True)
        makers = {
            "run": ["make", PROMPT, "-o", self.inputs / "run", *TINY],
            "rooms": ["rooms", "dataset", "--count", 4, "--views", 2, "--size", "128x64", "--film", "clean", "--cell",
                      0.3, "--cell-samples", 8, "--pixel-samples", 1, "--outside-detail", 0, "--seed", 2, "-o",
                      self.inputs / "rooms"],
            "holes": ["inpaint", "dataset", self.inputs / "rooms", "-o", self.inputs / "holes", "--size", 64,
                      "--held-out", 50, "--seed", 3],
        }
        for name in ["run", "rooms", "holes"]:
            if name in names and not (self.inputs / (name + ".done")).exists():
                self.run(makers[name], 0)
                (self.inputs / (name + ".done")).touch()

    def attempt(self, name, act):
        """One disturbance: counted, its failure kept for the end."""
        self.done += 1
        try:
            act()
        except Failure as failure:
            self.failures.append(f"{name}: {failure}")
            print(f"FAILED  {name}: {failure}", flush=True)

    def end(self, what):
        print(f"{self.done - len(self.failures)} of {self.done} {what}")
        sys.exit(1 if self.failures else 0)


def tail(text, lines=6):
    return "\n".join(text.rstrip().splitlines()[-lines:])


def contents(folder):
    """Names and hashes of all files that two runs must have in common; logs and times are left out."""
    out = {}
    for path in sorted(pathlib.Path(folder).rglob("*")):
        if path.is_file() and path.name not in VARYING and path.suffix not in (".log", ".svg"):
            out[str(path.relative_to(folder))] = hashlib.sha256(path.read_bytes()).hexdigest()
    return out


def difference(expected, found):
    """A sentence, or nothing if both are the same."""
    missing = sorted(expected.keys() - found.keys())
    more = sorted(found.keys() - expected.keys())
    other = sorted(name for name in expected.keys() & found.keys() if expected[name] != found[name])
    parts = [f"{word}: {', '.join(names[:4])}{' …' if len(names) > 4 else ''}"
             for word, names in [("missing", missing), ("left over", more), ("other bytes", other)] if names]
    return "; ".join(parts)


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


# name: (inputs, arguments with {out} for the folder and {in} for the inputs). All of them resume or start anew when
# called again, and end in the same bytes.
COMMANDS = {
    "make": ([], ["make", PROMPT, "-o", "{out}/scene", *TINY]),
    "splat": (["run"], ["splat", "--colmap", "{in}/run/views", "-o", "{out}/scene", *SPLAT]),
    "edit": (["run"], ["edit", "{in}/run", "remove the armchair", "-o", "{out}/scene"]),
    "batch": ([], ["batch", "--count", 2, "--jobs", 2, "-o", "{out}/set", "--stage", "panorama", *PANORAMA]),
    "export-room": (["run"], ["export", "{in}/run", "{out}/room.glb"]),
    "export-usda": (["run"], ["export", "{in}/run", "{out}/room.usda"]),
    "export-views": (["run"], ["export", "{in}/run", "{out}/labelled", "--what", "views"]),
    "export-npy": (["run"], ["export", "{in}/run", "{out}/labels.npy"]),
    "convert-spz": (["run"], ["convert", "{in}/run", "{out}/scene.spz"]),
    "convert-sog": (["run"], ["convert", "{in}/run", "{out}/scene.sog"]),
    "render": (["run"], ["render", "{in}/run", "--size", "80x60", "-o", "{out}/a.png", "--depth", "{out}/d.exr"]),
    "render-film": (["run"], ["render", "{in}/run", "--path", "{in}/run/views/transforms.json", "-o", "{out}/frames"]),
    "rooms-dataset": ([], ["rooms", "dataset", "--count", 4, "--views", 2, "--size", "64x32", "--film", "clean",
                           "--cell", 0.4, "--cell-samples", 2, "--pixel-samples", 1, "--outside-detail", 0, "-o",
                           "{out}/rooms"]),
    "dataset-export": (["rooms"], ["dataset", "export", "{in}/rooms", "--format", "webdataset", "--shard-samples", 2,
                                   "-o", "{out}/shards"]),
    "inpaint-dataset": (["rooms"], ["inpaint", "dataset", "{in}/rooms", "-o", "{out}/holes", "--size", 64, "--held-out",
                                    50, "--seed", 3]),
    "inpaint-train": (["rooms", "holes"],
                      ["inpaint", "train", "{in}/holes", "-o", "{out}/net", "--width", 4, "--blocks", 1, "--size", 64,
                       "--batch", 1, "--held-out", 2, "--holes", "harmonic", "--adversarial", 0, "--log-steps", 1,
                       "--steps", 6, "--checkpoint-minutes", 0, "--threads", 1]),
    "depth-train": ([], ["depth", "train", "--painted", 1, "--steps", 4, "--height", 32, "--channels", 4, "--batch", 1,
                         "--eval-steps", 1000, "--checkpoint-minutes", 0, "--threads", 1, "-o", "{out}/net"]),
}


def arguments(campaign, name, out):
    needs, args = COMMANDS[name]
    campaign.need(*needs)
    return [str(a).replace("{out}", str(out)).replace("{in}", str(campaign.inputs)) for a in args]


def now():
    return time.monotonic()
