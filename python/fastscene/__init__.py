"""From a sentence to a 3D indoor scene you can walk through: rooms, pictures of them, Gaussian splats.

Lengths are metres; the world is x right, y down, z forward; poses are 4 x 4 matrices, target first
(world_from_camera). docs/python.md has examples.
"""
from ._core import *  # noqa: F401,F403
from ._core import __version__  # noqa: F401
