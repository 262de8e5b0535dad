"""The whole: a sentence becomes a scene in a folder, as `fastscene make` does, and a film's path in it.
make_scene.py FOLDER"""
import sys

import fastscene

folder = sys.argv[1]


def on_progress(work, done, total):
    if done == total:
        print(work, "done", file=sys.stderr)


# Sizes for trying it out; without them: the preset of `quality`.
report = fastscene.make_scene(
    "a small study with a desk", folder, quality="draft", seed=1, on_progress=on_progress,
    panorama_width=128, panorama_cell=0.25, panorama_cell_samples=8, panorama_pixel_samples=2,
    panorama_outside_detail=0, walk_room_viewpoints=2, views_size=48, views_points=4000, splat_count=2000,
    splat_steps=30)
print(f"{folder}: {report['seconds']:.0f} s")

path = fastscene.plan_film(folder, "tour", fps=24)
path.save(folder + "/tour.json")
path.save(folder + "/tour.chan")  # for Blender
print(f"a tour of {path.frames} frames; the last camera:\n{path.world_from_camera(path.frames - 1).round(2)}")
