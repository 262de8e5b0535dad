"""Trains splats on pictures that are arrays in memory: a painted box, seen from its middle.     train_splats.py OUT.ply"""
import sys

import numpy as np

import fastscene


def hit_box(origin, directions):
    """Where rays meet the inside of the box |x|, |y|, |z| <= 2 m, and its colors there."""
    wall = np.where(directions > 0, 2.0, -2.0)
    distance = ((wall - origin) / directions).min(axis=-1, keepdims=True)
    points = origin + directions * distance
    colors = (128 + 100 * np.sin(3 * (points + np.roll(points, 1, axis=-1)))).astype(np.uint8)
    return points, colors


camera = fastscene.Pinhole.with_fov(96, 96, 90)
x, y = np.meshgrid(np.arange(camera.width) + 0.5, np.arange(camera.height) + 0.5)
rays = np.stack([(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, np.ones_like(x)], axis=-1)
views, positions, colors = [], [], []
for yaw in range(0, 360, 30):
    pose = fastscene.world_from_camera_at((0.1, 0, 0), yaw_deg=yaw)
    points, color = hit_box(pose[:3, 3], rays @ pose[:3, :3].T)
    views.append(fastscene.View(camera, pose, color))
    positions.append(points[::4, ::4].reshape(-1, 3))
    colors.append(color[::4, ::4].reshape(-1, 3))


def on_step(step, steps, loss, psnr):
    if step % 50 == 0:
        print(f"step {step} of {steps}: {psnr:.1f} dB")


view_set = fastscene.ViewSet(views, np.concatenate(positions), np.concatenate(colors))
fitted = fastscene.fit_splats(view_set, seed=7, on_step=on_step, count=4000, steps=150)
fastscene.save_splats(sys.argv[1], fitted.splats)
