"""Changes splats with numpy, in their own memory, and writes another format.     edit_splats.py IN OUT.spz"""
import sys

import numpy as np

import fastscene

splats = fastscene.load_splats(sys.argv[1])
splats.mean_m[:, 1] -= 0.1  # up: y points down
gray = splats.sh0.mean(axis=1, keepdims=True)
splats.sh0[:] = 0.5 * splats.sh0 + 0.5 * gray  # half as colorful
opacity = 1 / (1 + np.exp(-splats.opacity_logit))
print(f"{len(splats)} splats, mean opacity {opacity.mean():.2f}")

half = fastscene.strongest(splats, len(splats) // 2)
fastscene.save_splats(sys.argv[2], half)
