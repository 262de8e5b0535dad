#!/usr/bin/env python3
"""Odd places and narrow limits: languages with decimal commas, names with anything in them, a home that cannot be
written, few files, little memory, two processes on one folder. The same bytes, or a clear refusal."""
import os
import pathlib
import shutil
import subprocess
import time

from campaign import (COMMANDS, PANORAMA, PROMPT, SPLAT, Campaign, Failure, arguments, contents, difference, fresh,
                      tail)

campaign = Campaign(__doc__)
USUAL = ["panorama", "splat", "export-room", "export-usda", "export-npy", "convert-spz", "convert-sog", "render",
         "rooms-dataset", "inpaint-train"]
COMMANDS["panorama"] = ([], ["panorama", PROMPT, "-o", "{out}/scene", *PANORAMA])
NAMES = ["with blanks  and\ttab", "quote'd \"twice\"", "#1 100%25 %s%n $HOME `x`", "Kühlschrank-Ünïcödé-漢字-🛋", "-dash",
         "semi;colon&amp=<b>", "a\\backslash", "n" * 255, "ü" * 127, "colon:name", "new\nline"]


def expect(condition, text):
    if not condition:
        raise Failure(text)


def reference(name):
    place = fresh(campaign.work / "reference" / name)
    campaign.run(arguments(campaign, name, place), 0)
    return contents(place)


def same(name, expected, out, environment=None, **kwargs):
    campaign.run(arguments(campaign, name, out), 0, environment, **kwargs)
    if found := difference(expected, contents(out)):
        raise Failure(found)


def in_german():
    """An environment with decimal commas, or nothing where no such locale can be made."""
    folder = campaign.work / "locale"
    if not (folder / "de_DE.UTF-8").exists():
        folder.mkdir(exist_ok=True)
        if not shutil.which("localedef"):
            return None
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")], check=False,
                       capture_output=True)
    if not (folder / "de_DE.UTF-8").exists():
        return None
    return {"LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}


def odd_name(name, expected, odd):
    out = fresh(campaign.work / "odd")
    place = out / odd
    place.mkdir()
    same(name, expected, place)


def odd_file(odd):
    """The odd name is that of the file itself."""
    campaign.need("run")
    out = fresh(campaign.work / "odd")
    for ending, args in [(".png", ["render", campaign.inputs / "run", "--size", "40x30", "-o"]),
                         (".ply", ["convert", campaign.inputs / "run"]),
                         (".glb", ["export", campaign.inputs / "run"])]:
        stem = odd.encode()[:255 - len(ending)].decode(errors="ignore")
        target = out / (stem + ending)
        campaign.run([*args, target], 0)
        expect(target.stat().st_size > 0, f"{target} is empty")
        if ending == ".ply":
            campaign.run(["convert", target, out / "again.splat"], 0)


def limited(name, expected, shell):
    out = fresh(campaign.work / "limited")
    args = arguments(campaign, name, out)
    command = ["bash", "-c", f'{shell}; exec "$@"', "_", campaign.program, *args]
    result = subprocess.run(command, cwd=campaign.work, env=campaign.environment, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300, check=False)
    text = result.stdout.decode(errors="replace")
    if result.returncode == 0:
        expect(not difference(expected, contents(out)), f"other bytes: {difference(expected, contents(out))}")
    else:
        expect(result.returncode == 1, f"exit code {result.returncode} under {shell}\n{tail(text)}")
        expect("fastscene: " in text and "internal error" not in text, f"under {shell}: {tail(text)}")
        campaign.run(args, 0)
        expect(not difference(expected, contents(out)), "other bytes when gone on with")


def two_at_once(name, expected):
    out = fresh(campaign.work / "two")
    args = arguments(campaign, name, out)
    start = lambda: subprocess.Popen([campaign.program, *args], cwd=campaign.work, env=campaign.environment,
                                     stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    first = start()
    time.sleep(0.3)
    second = start()
    texts = [p.communicate(timeout=300)[0].decode(errors="replace") for p in (first, second)]
    for process, text in zip((first, second), texts):
        if process.returncode != 0:
            expect(process.returncode == 1 and "another fastscene" in text,
                   f"exit code {process.returncode} beside another\n{tail(text)}")
    expect(0 in (first.returncode, second.returncode), "neither of two finished")
    campaign.run(args, 0)
    if found := difference(expected, contents(out)):
        raise Failure(f"after two at once {found}")


german = in_german()
if not german:
    print("a locale with decimal commas: skipped (localedef or its de_DE is missing)")
verbs = campaign.args.only or USUAL
for verb in verbs:
    whole = reference(verb)
    out_folder = fresh(campaign.work / "out")
    if german:
        campaign.attempt(f"{verb}, decimal commas", lambda: same(verb, whole, out_folder, german))
    unhomely = {"HOME": "/proc/1/nowhere", "XDG_CACHE_HOME": "", "XDG_CONFIG_HOME": "", "TMPDIR": "/proc/1/nowhere"}
    campaign.attempt(f"{verb}, no home", lambda: same(verb, whole, fresh(campaign.work / "out"), unhomely))
    for odd_one in NAMES[:campaign.args.rounds] if campaign.args.rounds else NAMES:
        campaign.attempt(f"{verb} in {odd_one[:40]!r}", lambda: odd_name(verb, whole, odd_one))
    for limit in ["ulimit -n 24", "ulimit -v 1500000", "ulimit -f 40", "ulimit -s 1024"]:
        campaign.attempt(f"{verb}, {limit}", lambda: limited(verb, whole, limit))
    if verb in ("panorama", "splat", "rooms-dataset", "inpaint-train"):
        campaign.attempt(f"{verb}, two at once", lambda: two_at_once(verb, whole))
for odd_one in NAMES:
    campaign.attempt(f"files named {odd_one[:40]!r}", lambda: odd_file(odd_one))
campaign.end("surroundings borne")
