"""A room becomes splats: panoramas, views cut from them, training, and how near the splats come.
train_on_room.py OUT.spz"""
import sys

import fastscene

room = fastscene.make_traced_room("a small study with a desk", seed=2, cell=0.2, cell_samples=16, outside_detail=0)
places = [(0, 0, 0), (0.2, 0, 0), (0, 0, 0.2)]
panoramas = [room.panorama(256, fastscene.world_from_camera_at(place), samples=8) for place in places]
views = fastscene.project_views(panoramas, size=64, points=6000)
fitted = fastscene.fit_splats(views, count=6000, steps=150)

# A place that was not trained on.
camera, pose = fastscene.Pinhole.with_fov(96, 96, 90), fastscene.world_from_camera_at((0.1, 0, 0.1), yaw_deg=45)
truth = room.perspective(camera, pose, samples=16).rgb8()
picture = fastscene.render_splats(fitted.splats, camera, pose).rgb8()
print(f"{len(views)} views, {len(fitted.splats)} splats, PSNR {fastscene.psnr(picture, truth):.1f} dB at a new place")
fastscene.save_splats(sys.argv[1], fitted.splats)
