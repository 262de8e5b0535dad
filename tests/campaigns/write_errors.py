#!/usr/bin/env python3
"""Every write may fail: full disk, broken disk, read-only file system, exceeded quota.

A shim (failing_writes.c) lets the Nth call that writes fail, once or from then on. Then the command must say so, with
the file's name and the reason, exit with 1, and keep what was there; where there is space again, the same command ends
in the bytes of a run that met no error. A command that can do without (a checkpoint) may succeed, with those bytes.
"""
import os
import random

from campaign import COMMANDS, Campaign, Failure, arguments, contents, difference, fresh, tail

ERRORS = {"ENOSPC": (28, "No space left on device"), "EIO": (5, "Input/output error"),
          "EROFS": (30, "Read-only file system"), "EDQUOT": (122, "Disk quota exceeded")}
USUAL = ["make", "splat", "edit", "batch", "export-room", "export-usda", "export-views", "export-npy", "convert-spz",
         "convert-sog", "render", "render-film", "rooms-dataset", "dataset-export", "inpaint-dataset", "inpaint-train",
         "depth-train"]

campaign = Campaign(__doc__.splitlines()[0], [(["--shim"], {"required": True, "help": "built failing_writes.c"})])


def environment(out, at, length, code):
    counter = campaign.work / "counter"
    counter.write_bytes(bytes(8))
    return {"LD_PRELOAD": os.path.abspath(campaign.args.shim), "FAIL_UNDER": str(out), "FAIL_COUNTER": str(counter),
            "FAIL_AT": str(at), "FAIL_LENGTH": str(length), "FAIL_ERRNO": str(code),
            "FAIL_LOG": str(campaign.work / "calls")}


def calls_of(args, out):
    (campaign.work / "calls").unlink(missing_ok=True)
    campaign.run(args, 0, environment(out, 0, 0, 0))
    return int.from_bytes((campaign.work / "counter").read_bytes(), "little")


def disturb(name, expected, at, length, error):
    out = fresh(campaign.work / "out")
    mine = out / "mine.txt"
    mine.write_text("of the user\n")
    args = arguments(campaign, name, out)
    code, reason = ERRORS[error]
    (campaign.work / "calls").unlink(missing_ok=True)
    result = campaign.run(args, environment=environment(out, at, length, code), timeout=300)
    failed = [line for line in (campaign.work / "calls").read_text().splitlines() if line.endswith(" FAILS")]
    failing = failed[0] if failed else "a write that was cut short"
    if result.returncode not in (0, 1):
        raise Failure(f"exit code {result.returncode} after {failing}\n{tail(result.text)}")
    if result.returncode == 1 and (str(out) not in result.text or reason not in result.text):
        raise Failure(f"no file, or not \"{reason}\" after {failing}\n{tail(result.text)}")
    if mine.read_text() != "of the user\n":
        raise Failure("a foreign file was touched")
    mine.unlink()
    if result.returncode == 0 and (found := difference(expected, contents(out))):
        raise Failure(f"success, but {found}; after {failing}\n{tail(result.text)}")
    campaign.run(args, 0)
    if found := difference(expected, contents(out)):
        raise Failure(f"gone on with: {found}; after {failing}")


for verb in campaign.args.only or USUAL:
    assert verb in COMMANDS, verb
    place = fresh(campaign.work / "out")
    command = arguments(campaign, verb, place)
    calls = calls_of(command, place)
    whole = contents(place)
    draw = random.Random(f"{campaign.args.seed} {verb}")
    rounds = campaign.args.rounds or calls
    moments = sorted(draw.sample(range(1, calls + 1), min(rounds, calls)))
    print(f"{verb}: {calls} calls that write, {len(moments)} of them fail", flush=True)
    for i, moment in enumerate(moments):
        kind = list(ERRORS)[(i + draw.randrange(4)) % 4]
        length = draw.choice([0, 0, 1])
        campaign.attempt(f"{verb}, call {moment} of {calls}, {kind}{', once' if length else ''}",
                         lambda: disturb(verb, whole, moment, length, kind))
campaign.end("write errors survived")
