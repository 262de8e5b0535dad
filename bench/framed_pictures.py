"""Photographs, prints in black and white and paintings of the views in FOLDER, as FOLDER/*.webp."""

import subprocess
import sys

import numpy as np

WIDTH, HEIGHT = 720, 480
PHOTOS = ["sea_dusk", "city_night", "peaks_evening", "garden"]
PRINTS = ["sea_day", "peaks", "peaks_winter", "misty_firs", "rooftops", "birches"]
PAINTINGS = ["peaks_evening", "birches", "garden", "street", "sea_storm", "peaks"]
BRIGHTEST = 0.89  # of paper and paint, sRGB
QUALITY = 82  # of WebP: 20 to 40 kB a picture


def read(name):
    raw = subprocess.run(
        ["ffmpeg", "-nostdin", "-v", "error", "-i", name, "-vf", f"scale={WIDTH}:{HEIGHT}:flags=area", "-f", "rawvideo",
         "-pix_fmt", "rgb24", "-"], stdout=subprocess.PIPE, check=True).stdout
    return np.frombuffer(raw, np.uint8).reshape(HEIGHT, WIDTH, 3).astype(np.float32) / 255


def write(name, picture):
    raw = (np.clip(picture, 0, BRIGHTEST) * 255 + 0.5).astype(np.uint8).tobytes()
    subprocess.run(
        ["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{WIDTH}x{HEIGHT}",
         "-i", "-", "-c:v", "libwebp", "-quality", str(QUALITY), name], input=raw, check=True)


def stretched(picture, low, high):
    """From the darkest and brightest percentile to these values."""
    a, b = np.percentile(picture, [1, 99])
    return low + (picture - a) / max(b - a, 1e-3) * (high - low)


def black_and_white(picture):
    """Through a yellow filter, with a contrasty paper, faintly warm."""
    gray = stretched(picture @ np.float32([0.38, 0.54, 0.08]), 0.02, 0.96)
    gray = np.clip(gray, 0, 1)
    gray = 0.35 * gray + 0.65 * gray * gray * (3 - 2 * gray)
    return 0.9 * gray[..., None] * np.float32([1, 0.985, 0.955])  # paper is no brighter


def box_mean(a, radius):
    """Means over squares of 2 radius + 1, by sums along both axes."""
    for axis in (0, 1):
        padded = np.pad(a, [(radius + 1, radius) if i == axis else (0, 0) for i in range(a.ndim)], mode="edge")
        sums = np.cumsum(padded, axis=axis, dtype=np.float64)
        n = a.shape[axis]
        take = [slice(None)] * a.ndim
        upper, lower = take.copy(), take.copy()
        upper[axis], lower[axis] = slice(2 * radius + 1, 2 * radius + 1 + n), slice(0, n)
        a = ((sums[tuple(upper)] - sums[tuple(lower)]) / (2 * radius + 1)).astype(np.float32)
    return a


def painted(picture, radius=4):
    """Kuwahara et al., 1976: each pixel takes the mean of the most even of the four squares that it is a corner of."""
    margin = 2 * radius
    picture = np.pad(picture, [(margin, margin), (margin, margin), (0, 0)], mode="reflect")
    gray = picture.mean(axis=2)
    mean, square = box_mean(picture, radius), box_mean(gray * gray, radius)
    variance = square - box_mean(gray, radius) ** 2
    best, least = None, None
    for dy in (-radius, radius):
        for dx in (-radius, radius):
            m, v = (np.roll(a, (dy, dx), (0, 1)) for a in (mean, variance))
            best = m if best is None else np.where((v < least)[..., None], m, best)
            least = v if least is None else np.minimum(v, least)
    gray = best.mean(axis=2, keepdims=True)
    # Ridges of paint along the edges of strokes.
    height = box_mean(best.mean(axis=2), 1)
    relief = height - np.roll(height, (1, 1), (0, 1))
    gray, best, relief = (a[margin:-margin, margin:-margin] for a in (gray, best, relief))
    return stretched(gray + 1.25 * (best - gray), 0.06, 0.9) + 0.35 * relief[..., None]


def main(folder):
    for names, kind, change in ((PHOTOS, "photo", lambda p: stretched(p, 0.03, 0.91)), (PRINTS, "print", black_and_white),
                                (PAINTINGS, "painting", painted)):
        for name in names:
            write(f"{folder}/{kind}_{name}.webp", change(read(f"{folder}/{name}.png")))


main(sys.argv[1])
