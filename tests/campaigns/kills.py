#!/usr/bin/env python3
"""Killed at random moments (SIGKILL) and started again, a command ends in the bytes of one that never was."""
import random
import signal
import subprocess
import time

from campaign import Campaign, Failure, arguments, contents, difference, fresh, now

USUAL = ["make", "splat", "edit", "batch", "export-views", "render-film", "rooms-dataset", "dataset-export",
         "inpaint-dataset", "inpaint-train", "depth-train"]

campaign = Campaign(__doc__)


def kill_at(args, seconds):
    with subprocess.Popen([campaign.program, *args], cwd=campaign.work, env=campaign.environment,
                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)


def disturb(name, expected, took, draw):
    out = fresh(campaign.work / "out")
    args = arguments(campaign, name, out)
    for _ in range(draw.choice([1, 1, 2])):
        kill_at(args, draw.uniform(0.02, took))
    # Scenes of a batch that was killed go on by themselves; who comes next waits for them.
    for _ in range(60):
        result = campaign.run(args)
        if "another fastscene is working" not in result.text:
            break
        time.sleep(1)
    if result.returncode != 0:
        raise Failure(f"exit code {result.returncode} after a kill\n{result.text[-600:]}")
    if found := difference(expected, contents(out)):
        raise Failure(f"after a kill {found}")
    rest = [str(p.relative_to(out)) for p in out.rglob("*.part*")]
    if rest:
        raise Failure(f"left over: {', '.join(rest[:4])}")


for verb in campaign.args.only or USUAL:
    place = fresh(campaign.work / "out")
    command = arguments(campaign, verb, place)
    begin = now()
    campaign.run(command, 0)
    seconds = now() - begin
    whole = contents(place)
    random_moments = random.Random(f"{campaign.args.seed} {verb}")
    print(f"{verb}: {seconds:.1f} s, killed {campaign.args.rounds} times", flush=True)
    for turn in range(campaign.args.rounds):
        campaign.attempt(f"{verb}, round {turn + 1}", lambda: disturb(verb, whole, seconds, random_moments))
campaign.end("kills left no trace")
