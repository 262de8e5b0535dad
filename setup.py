"""Builds the extension with CMake; all else is in pyproject.toml."""
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
NAME = "_core" + sysconfig.get_config_var("EXT_SUFFIX")


def run(*command):
    print(*command, flush=True)
    subprocess.run(command, cwd=ROOT, check=True)


class CMakeExtension(build_ext):
    """$FASTSCENE_BUILD_DIR, or the build of ./fastscene if it is for this Python, or a build of its own."""

    def build_extension(self, ext):
        version = f"{sys.version_info.major}.{sys.version_info.minor}"
        usual = ROOT / "build/release"
        own = ROOT / f"build/python{version}"
        folder = pathlib.Path(os.environ.get("FASTSCENE_BUILD_DIR") or (usual if self.is_ours(usual) else own))
        if not (folder / "build.ninja").exists():
            run("cmake", "--preset", "release", "-B", str(folder), "-DFASTSCENE_TESTS=OFF",
                f"-DPython_EXECUTABLE={sys.executable}")
        run("cmake", "--build", str(folder), "--target", "fastscene_python")
        made = folder / "python/fastscene" / NAME
        if not made.exists():
            sys.exit(f"{made}: not built; is pybind11 there, and {folder} for Python {version}?")
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(made, target)

    @staticmethod
    def is_ours(folder):
        if not (folder / "build.ninja").exists():
            return False
        text = (folder / "build.ninja").read_text(encoding="utf-8", errors="replace")
        return f"python/fastscene/{NAME}" in text


setup(ext_modules=[Extension("fastscene._core", sources=[])], cmdclass={"build_ext": CMakeExtension})
