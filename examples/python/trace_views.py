"""Pictures of a room with what they show, pixel by pixel: training data.     trace_views.py OUT.png"""
import sys

import numpy as np

import fastscene

room = fastscene.make_traced_room("a small study with a desk", seed=2, cell=0.2, cell_samples=16, outside_detail=0)
camera = fastscene.Pinhole.with_fov(160, 120, 80)
for yaw in (0, 120, 240):
    pose = fastscene.world_from_camera_at((0, 0, 0), yaw_deg=yaw, pitch_deg=-10)
    shot = room.perspective(camera, pose, samples=16)
    names, counts = np.unique(shot.object[shot.object >= 0], return_counts=True)
    largest = room.objects[names[counts.argmax()]]["name"]
    print(f"yaw {yaw}: {len(names)} things, most of {largest}; {np.nanmin(shot.range):.2f} m to the nearest")
fastscene.save_picture(sys.argv[1], shot.rgb8())
