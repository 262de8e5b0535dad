#!/usr/bin/env python3
"""One seed gives the same room for any instruction set and any number of threads, and nearly the same pictures.

Rooms are compared as bytes. So are pictures with any number of threads, with AVX2 and with AVX-512. Pictures with SSE4
must have a PSNR of 40 dB or more against those, at these noisy sizes. With --other, a second program is held against the
first, such as one built for processors without AVX2.
"""
import math
import pathlib
import shutil
import subprocess

from campaign import PANORAMA, PROMPT, Campaign, Failure, fresh

# At these sizes two rays a pixel make noise of their own: 44.3 dB between SSE4 and AVX2.
LEAST_DB = 40.0
PROMPTS = pathlib.Path(__file__).resolve().parent.parent / "data" / "prompts.txt"
THREADS = [1, 2, 7]

campaign = Campaign(__doc__.splitlines()[0], [(["--other"], {"help": "another build of fastscene"}),
                                              (["--pictures"], {"type": int, "default": 2, "help": "how many scenes"})])
lines = [line.strip() for line in PROMPTS.read_text(encoding="utf-8").splitlines()]
prompts = [line for line in lines if line and not line.startswith("#")]
count = campaign.args.rounds or len(prompts)
chosen = [prompts[i * len(prompts) // count] for i in range(min(count, len(prompts)))]


def sets():
    """The instruction sets that this processor has."""
    flags = next(line for line in open("/proc/cpuinfo", encoding="ascii") if line.startswith("flags")).split()
    return ["sse4"] + (["avx2"] if "avx2" in flags else []) + (["avx512"] if "avx512vl" in flags else [])


def planned(prompt, seed, isa, threads, program=None):
    file = campaign.work / "room.json"
    file.unlink(missing_ok=True)
    mine, campaign.program = campaign.program, program or campaign.program
    try:
        campaign.run(["rooms", "plan", prompt, "--seed", seed, "--threads", threads, "-o", file], 0,
                     {"FASTSCENE_ISA": isa})
    finally:
        campaign.program = mine
    return file.read_bytes()


def same_room(prompt, seed):
    expected = planned(prompt, seed, sets()[-1], THREADS[0])
    others = list(zip(sets(), THREADS)) + [(sets()[0], THREADS[-1])]
    for isa, threads in others:
        if planned(prompt, seed, isa, threads) != expected:
            raise Failure(f"another room with {isa} and {threads} threads")
    if campaign.args.other and planned(prompt, seed, "sse4", 2, campaign.args.other) != expected:
        raise Failure(f"another room by {campaign.args.other}")


def pixels(file):
    command = ["ffmpeg", "-nostdin", "-v", "error", "-i", str(file), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    return subprocess.run(command, check=True, capture_output=True).stdout


def psnr(a, b):
    squares = sum((x - y) ** 2 for x, y in zip(pixels(a), pixels(b)))
    return math.inf if squares == 0 else 10 * math.log10(255 ** 2 * len(pixels(a)) / squares)


def picture(prompt, isa, threads):
    out = fresh(campaign.work / f"{isa}-{threads}")
    campaign.run(["panorama", prompt, "-o", out, *PANORAMA, "--threads", threads], 0, {"FASTSCENE_ISA": isa})
    return out / "panorama" / "color.png"


def same_picture(prompt):
    for isa in sets():
        first = picture(prompt, isa, THREADS[0])
        for threads in THREADS[1:]:
            if picture(prompt, isa, threads).read_bytes() != first.read_bytes():
                raise Failure(f"{isa}: another picture with {threads} threads")
    made = {isa: campaign.work / f"{isa}-{THREADS[0]}" / "panorama" / "color.png" for isa in sets()}
    if "avx512" in made and made["avx512"].read_bytes() != made["avx2"].read_bytes():
        raise Failure("avx512: another picture than with avx2")
    for isa in sets()[1:]:
        found = psnr(made["sse4"], made[isa])
        worst[isa] = min(worst.get(isa, math.inf), found)
        if found < LEAST_DB:
            raise Failure(f"sse4 and {isa}: {found:.1f} dB, expected {LEAST_DB} or more")


worst = {}
for number, text in enumerate(chosen):
    campaign.attempt(f"room of \"{text}\"", lambda: same_room(text, number))
if shutil.which("ffmpeg"):
    for text in [PROMPT, *chosen][:campaign.args.pictures]:
        campaign.attempt(f"picture of \"{text}\"", lambda: same_picture(text))
    for isa, found in worst.items():
        print(f"sse4 and {isa}: {found:.1f} dB or more")
else:
    print("pictures: skipped (ffmpeg is not installed)")
campaign.end("same everywhere")
