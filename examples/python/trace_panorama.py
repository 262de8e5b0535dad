"""The room of a sentence, path traced all around.     trace_panorama.py OUT.jpg"""
import sys

import numpy as np

import fastscene

# Coarse light: quick to try out. The defaults are finer.
room = fastscene.make_traced_room("a small study with a desk", seed=2, cell=0.2, cell_samples=16, outside_detail=0)
panorama = room.panorama(width=256, samples=16)
fastscene.save_picture(sys.argv[1], panorama.rgb8(), panorama=True)
seen = panorama.range[np.isfinite(panorama.range)]
print(f"nearest {seen.min():.2f} m, farthest {seen.max():.2f} m")
