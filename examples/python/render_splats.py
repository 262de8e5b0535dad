"""Pictures of splats: a still with its depth, one all around, a turn.     render_splats.py SCENE OUT_FOLDER"""
import pathlib
import sys

import fastscene

splats, out = fastscene.load_splats(sys.argv[1]), pathlib.Path(sys.argv[2])
out.mkdir(parents=True, exist_ok=True)
renderer = fastscene.SplatRenderer(splats, background=(1, 1, 1))
camera = fastscene.Pinhole.with_fov(160, 120, 75)
still = renderer.picture(camera)
fastscene.save_picture(out / "still.png", still.rgb8())
print(f"in the middle: {still.depth_z[60, 80]:.2f} m, opacity {still.alpha[60, 80]:.2f}")
fastscene.save_picture(out / "sphere.jpg", renderer.sphere(256), panorama=True)
for i, yaw in enumerate(range(0, 90, 30)):
    turned = renderer.picture(camera, fastscene.world_from_camera_at((0, 0, 0), yaw_deg=yaw))
    fastscene.save_picture(out / f"{i:02}.png", turned.rgb8())
