#!/usr/bin/env python3
"""SIGTERM, SIGINT and SIGHUP at random moments: any command is gone within two seconds, and says so."""
import random
import signal
import subprocess
import time

from campaign import COMMANDS, PROMPT, Campaign, Failure, arguments, fresh, now, tail

# Work that takes long in single steps: as it is for users, not tiny. name: (inputs, arguments, seconds of interest).
LONG = {
    "inpaint-train-long": (["rooms", "holes"],
                           ["inpaint", "train", "{in}/holes", "-o", "{out}/net", "--width", 64, "--blocks", 8, "--size",
                            64, "--batch", 64, "--held-out", 64, "--steps", 100], 40),
    "depth-train-long": ([], ["depth", "train", "--painted", 1, "--steps", 100, "--height", 256, "--channels", 32,
                              "--batch", 4, "-o", "{out}/net"], 40),
    "make-long": ([], ["make", PROMPT, "-o", "{out}/scene", "--quality", "standard"], 60),
    "splat-long": (["run"], ["splat", "--colmap", "{in}/run/views", "-o", "{out}/scene", "--splat-count", 200000,
                             "--splat-steps", 100000, "--splat-sh-degree", 3], 20),
    "render-long": (["run"], ["render", "{in}/run", "--sphere", "--size", "8192x4096", "-o", "{out}/a.png"], 4),
    "film-long": (["run"], ["render", "{in}/run", "--path", "walkthrough", "--size", "1280x720", "-o",
                            "{out}/film.mp4"], 20),
    "rooms-dataset-long": ([], ["rooms", "dataset", "--count", 100, "--size", "2048x1024", "-o", "{out}/rooms"], 20),
    "paths-long": (["run"], ["render", "{in}/run", "--of", "room", "--sphere", "--size", "4096x2048", "-o",
                             "{out}/a.png"], 20),
    "export-baked": (["run"], ["export", "{in}/run", "{out}/room.glb", "--baked-light"], 10),
    "view": (["run"], ["view", "{in}/run", "--port", 0], 3),
    "studio": ([], ["studio", "{out}", "--port", 0, "--no-open"], 4),
    "rooms-check": ([], ["rooms", "check", "--count", 100000], 10),
}
USUAL = ["make", "batch", "view", "studio", "inpaint-train-long", "depth-train-long", "splat-long", "film-long",
         "rooms-dataset-long"]

campaign = Campaign(__doc__, [(["--longest"], {"type": float, "default": 60, "help": "seconds until a signal"}),
                              (["--patience"], {"type": float, "default": 2.0, "help": "seconds until it is answered"})])


def start(args):
    return subprocess.Popen([campaign.program, *args], cwd=campaign.work, env=campaign.environment,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def is_in_main(process):
    """Before main(), while libraries are loaded, a signal ends the process at once, as any."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        blocked = next((int(line.split()[1], 16) for line in status if line.startswith("SigBlk")), 0)
    return blocked >> (signal.SIGTERM - 1) & 1


def disturb(name, args, out, seconds, number):
    process = start(args)
    while process.poll() is None and not is_in_main(process):
        time.sleep(0.01)
    time.sleep(seconds)
    if process.poll() is not None:
        text = process.communicate()[0].decode(errors="replace")
        if process.returncode != 0:
            raise Failure(f"exit code {process.returncode} without a signal\n{tail(text)}")
        return
    process.send_signal(number)
    begin = now()
    try:
        text = process.communicate(timeout=60)[0].decode(errors="replace")
    except subprocess.TimeoutExpired:
        process.kill()
        raise Failure(f"not gone 60 s after {signal.Signals(number).name} at {seconds:.1f} s\n"
                      f"{tail(process.communicate()[0].decode(errors='replace'))}") from None
    took = now() - begin
    slowest[name] = max(slowest.get(name, 0), took)
    serves = name in ("view", "studio")
    if process.returncode not in ([0] if serves else []) + [128 + number]:
        raise Failure(f"exit code {process.returncode} after {signal.Signals(number).name}\n{tail(text)}")
    if took > campaign.args.patience:
        raise Failure(f"gone {took:.1f} s after {signal.Signals(number).name} at {seconds:.1f} s\n{tail(text)}")
    rest = [str(p.relative_to(out)) for p in out.rglob("*.part*") if p.exists()]
    if rest:
        raise Failure(f"left over: {', '.join(rest[:4])}")


slowest = {}
for verb in campaign.args.only or USUAL:
    needs, words, span = LONG.get(verb) or (*COMMANDS[verb], 3)
    campaign.need(*needs)
    draw = random.Random(f"{campaign.args.seed} {verb}")
    for turn in range(campaign.args.rounds):
        place = fresh(campaign.work / "out")
        command = [str(w).replace("{out}", str(place)).replace("{in}", str(campaign.inputs)) for w in words]
        kind = draw.choice([signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
        campaign.attempt(f"{verb}, round {turn + 1}",
                         lambda: disturb(verb, command, place, draw.uniform(0.05, min(span, campaign.args.longest)), kind))
    print(f"{verb}: gone within {slowest.get(verb, 0):.2f} s", flush=True)
campaign.end("signals answered")
