#!/usr/bin/env python3
"""The Python module: its types against the stubs, arrays that share memory, errors, callbacks, Ctrl-C, threads.
test_module.py WORK_FOLDER"""
import ast
import gc
import os
import pathlib
import re
import shutil
import signal
import sys
import threading
import time
import unittest

import numpy as np

import fastscene
from fastscene import _core

WORK = pathlib.Path(sys.argv.pop(1))
STUBS = pathlib.Path(fastscene.__file__).with_name("_core.pyi")


def box_views(count=6, size=32):
    """A striped box from its middle: views and points."""
    camera = fastscene.Pinhole.with_fov(size, size, 90)
    x, y = np.meshgrid(np.arange(size) + 0.5, np.arange(size) + 0.5)
    rays = np.stack([(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, np.ones_like(x)], axis=-1)
    views, positions, colors = [], [], []
    for i in range(count):
        pose = fastscene.world_from_camera_at((0.1, 0, 0), yaw_deg=360 * i / count)
        directions = rays @ pose[:3, :3].T
        wall = np.where(directions > 0, 2.0, -2.0)
        points = pose[:3, 3] + directions * ((wall - pose[:3, 3]) / directions).min(axis=-1, keepdims=True)
        color = (128 + 100 * np.sin(3 * points)).astype(np.uint8)
        views.append(fastscene.View(camera, pose, color))
        positions.append(points.reshape(-1, 3))
        colors.append(color.reshape(-1, 3))
    return fastscene.ViewSet(views, np.concatenate(positions), np.concatenate(colors))


class Stubs(unittest.TestCase):
    """What a type checker is told is what there is."""

    def test_names_and_arguments(self):
        tree = ast.parse(STUBS.read_text())
        functions = {n.name: n for n in tree.body if isinstance(n, ast.FunctionDef)}
        classes = {n.name: n for n in tree.body if isinstance(n, ast.ClassDef)}
        there = {n for n in dir(_core) if not n.startswith("_")}
        self.assertEqual(there, set(functions) | set(classes))
        for name, node in functions.items():
            self.check(name, node, getattr(_core, name).__doc__)
        for name, node in classes.items():
            methods = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
            fields = {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
            public = {n for n in vars(getattr(_core, name)) if not n.startswith("_")}
            if not issubclass(getattr(_core, name), BaseException):
                self.assertEqual(public, {n for n in methods if not n.startswith("__")} | fields, name)
            for method, inner in methods.items():
                if not any(isinstance(d, ast.Name) and d.id == "property" for d in inner.decorator_list):
                    self.check(f"{name}.{method}", inner, getattr(getattr(_core, name), method).__doc__)

    def check(self, name, node, doc):
        if name.endswith("__len__"):
            return
        signature = re.match(r"\w+\((.*)\) ->", doc.strip().split("\n")[0])
        self.assertTrue(signature, f"{name}: {doc}")
        depth, part, parts = 0, "", []
        for c in signature.group(1) + ",":
            depth += (c in "([{") - (c in ")]}")
            if c == "," and depth == 0:
                parts.append(part.strip())
                part = ""
            else:
                part += c
        found = [re.split(r"[:=]", p.lstrip("*"))[0].strip() for p in parts if p]
        found = [p for p in found if p not in ("self", "arg0")]
        args = node.args
        stated = [a.arg for a in args.args + args.kwonlyargs if a.arg != "self"]
        stated += [args.kwarg.arg] if args.kwarg else []
        self.assertEqual([p if p != "kwargs" else "settings" for p in found], stated, name)


class Arrays(unittest.TestCase):
    def test_splats_share_their_memory(self):
        splats = fastscene.Splats(5, sh_degree=1)
        mean = splats.mean_m
        mean[2] = (1, 2, 3)
        self.assertTrue(np.array_equal(splats.mean_m[2], (1, 2, 3)))
        self.assertTrue(np.shares_memory(splats.mean_m, mean))
        self.assertEqual(splats.sh_rest.shape, (5, 3, 3))
        splats.rotation = np.tile([1.0, 0, 0, 0], (5, 1))
        del splats
        gc.collect()
        self.assertEqual(mean[2, 1], 2)  # the array keeps them alive

    def test_other_shapes_are_refused(self):
        splats = fastscene.Splats(5)
        with self.assertRaisesRegex(fastscene.UsageError, "mean_m: expected 5 rows, found 4"):
            splats.mean_m = np.zeros((4, 3))
        with self.assertRaisesRegex(fastscene.UsageError, "expected an array of N x 3, found 5 x 2 of float64"):
            splats.sh0 = np.zeros((5, 2))
        splats.low_pass_px2 = 0.25
        with self.assertRaisesRegex(fastscene.UsageError, "low_pass_px2: expected 0.1 to 1, found 0.01"):
            splats.low_pass_px2 = 0.01
        self.assertEqual(splats.low_pass_px2, 0.25)
        camera = fastscene.Pinhole.with_fov(8, 8, 90)
        with self.assertRaisesRegex(fastscene.UsageError, "height x width x 3 of uint8, found 8 x 8 x 3 of float64"):
            fastscene.View(camera, None, np.zeros((8, 8, 3)))
        with self.assertRaisesRegex(fastscene.UsageError, "expected a rotation and a place"):
            fastscene.View(camera, np.eye(4) * 2, np.zeros((8, 8, 3), np.uint8))

    def test_pictures_and_formats_come_back(self):
        picture = np.arange(8 * 16 * 3, dtype=np.uint8).reshape(8, 16, 3)
        fastscene.save_picture(WORK / "p.png", picture)
        self.assertTrue(np.array_equal(fastscene.load_rgb8(str(WORK / "p.png")), picture))
        self.assertEqual(fastscene.psnr(picture, picture), float("inf"))
        splats = fastscene.Splats(20)
        splats.mean_m[:] = np.random.default_rng(0).normal(size=(20, 3))
        splats.rotation[:, 0] = 1
        splats.log_scale[:] = -3
        for name in ("a.ply", "a.spz", "a.compressed.ply"):
            fastscene.save_splats(WORK / name, splats)
            again = fastscene.load_splats(WORK / name)
            self.assertEqual(len(again), 20)
            self.assertLess(np.abs(np.sort(again.mean_m[:, 0]) - np.sort(splats.mean_m[:, 0])).max(), 0.01)

    def test_poses_turn_as_said(self):
        pose = fastscene.world_from_camera_at((1, 2, 3), yaw_deg=90)
        self.assertTrue(np.allclose(pose @ [0, 0, 1, 1], [2, 2, 3, 1], atol=1e-6))


class Errors(unittest.TestCase):
    def test_texts_are_those_of_the_program(self):
        with self.assertRaisesRegex(fastscene.Error, "nowhere.ply"):
            fastscene.load_splats("nowhere.ply")
        with self.assertRaises(fastscene.UsageError):
            fastscene.save_splats(WORK / "a.xyz", fastscene.Splats(1))
        with self.assertRaisesRegex(fastscene.UsageError, "unknown setting stepz; did you mean steps?"):
            fastscene.fit_splats(box_views(), stepz=3)
        with self.assertRaisesRegex(fastscene.UsageError, "steps: expected a whole number, found 'many'"):
            fastscene.fit_splats(box_views(), steps="many")
        with self.assertRaisesRegex(fastscene.UsageError, "expected a number from 0 to 1"):
            fastscene.fit_splats(box_views(), steps=1, coarse=3.0)
        with self.assertRaises(fastscene.UsageError):
            fastscene.understand_prompt("")
        with self.assertRaisesRegex(fastscene.Error, 'unknown key "stile"; did you mean "style"'):
            fastscene.make_traced_room({"format": "fastscene-room", "version": 1, "room": "bedroom", "stile": "boho"})


class Training(unittest.TestCase):
    SETTINGS = dict(count=500, steps=40)

    def test_steps_are_told_and_the_seed_decides(self):
        told = []
        fitted = fastscene.fit_splats(box_views(), seed=3, on_step=lambda *a: told.append(a), **self.SETTINGS)
        self.assertEqual([t[0] for t in told], list(range(1, 41)))
        self.assertGreater(np.mean([t[3] for t in told[-5:]]), np.mean([t[3] for t in told[:5]]) + 1)
        again = fastscene.fit_splats(box_views(), seed=3, **self.SETTINGS)
        self.assertTrue(np.array_equal(again.splats.mean_m, fitted.splats.mean_m))
        picture = fastscene.render_splats(fitted.splats, fastscene.Pinhole.with_fov(32, 32, 90))
        self.assertEqual(picture.color.shape, (32, 32, 3))
        self.assertGreater(picture.alpha.mean(), 0.5)

    def test_what_a_callback_raises_ends_the_training(self):
        def on_step(step, steps, loss, psnr):
            if step == 5:
                raise ValueError("enough")
        with self.assertRaisesRegex(ValueError, "enough"):
            fastscene.fit_splats(box_views(), on_step=on_step, count=500, steps=100000)

    def test_ctrl_c_stops_it(self):
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            fastscene.fit_splats(box_views(), count=500, steps=1000000)
        self.assertLess(time.monotonic() - start, 20)

    def test_other_threads_go_on(self):
        counted = [0]
        done = threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        fastscene.fit_splats(box_views(), count=500, steps=600)
        done.set()
        thread.join()
        self.assertGreater(counted[0], 5)  # with the lock held, one or two


class Rooms(unittest.TestCase):
    def test_a_document_is_the_room_of_its_sentence(self):
        sentence = "a small study with a red armchair"
        words = fastscene.understand_prompt(sentence + " and a zorblax")
        self.assertIn("zorblax", str(words["not_understood"]))
        document = fastscene.plan_document(sentence, seed=4)
        coarse = dict(cell=0.3, cell_samples=4, outside_detail=0)
        seen = []
        a = fastscene.make_traced_room(sentence, seed=4, on_progress=lambda *p: seen.append(p), **coarse)
        b = fastscene.make_traced_room(document, seed=4, **coarse)
        self.assertTrue(seen)
        self.assertEqual([o["name"] for o in a.objects], [o["name"] for o in b.objects])
        one, other = a.panorama(64, samples=16), b.panorama(64, samples=16)
        self.assertTrue(np.allclose(one.range, other.range, atol=1e-3))
        self.assertGreater(len(a.walkable()["polygon_m"]), 3)
        self.assertGreater(a.clearance((0, 0, 0)), 0.1)
        shot = a.perspective(fastscene.Pinhole.with_fov(33, 25, 90), samples=16)
        self.assertAlmostEqual(a.distance((0, 0, 0), (0, 0, 1)), float(shot.range[12, 16]), places=4)
        self.assertEqual(shot.object.dtype, np.int32)
        a.save_glb(WORK / "room.glb")
        self.assertEqual((WORK / "room.glb").read_bytes()[:4], b"glTF")

    def test_networks_are_loaded_when_one_is_used(self):
        def torch_is_loaded():
            return "libtorch" in pathlib.Path("/proc/self/maps").read_text()

        self.assertFalse(torch_is_loaded())
        tiny = dict(quality="draft", last_stage="depth", panorama_width=128, panorama_cell=0.3, panorama_cell_samples=8)
        fastscene.make_scene("a bedroom", WORK / "scene", depth_backend="egformer", **tiny)
        self.assertTrue((WORK / "scene/depth/range.exr").exists())
        self.assertTrue(torch_is_loaded())


if __name__ == "__main__":
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    unittest.main()
