"""Builds the Python package with CMake. GAPCHECK_BUILD names a build folder to use; without it, build/python is made and
used. What the package is called and needs is in pyproject.toml."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    """gapcheck._core is what CMake's target gapcheck_python makes."""

    def build_extension(self, extension):
        folder = os.environ.get("GAPCHECK_BUILD")
        if not folder:
            folder = ROOT / "build" / "python"
            subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            "-DGAPCHECK_TESTS=OFF", "-DGAPCHECK_PYTHON=ON", f"-DGAPCHECK_PYTHON_PROGRAM={sys.executable}"],
                           check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "gapcheck_python"], check=True)
        name = pathlib.Path(self.get_ext_filename(extension.name)).name
        built = pathlib.Path(folder) / "python" / "gapcheck" / name
        if not built.exists():
            sys.exit(f"{folder} has no {name}: it is built for another Python")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(built, target)


version = re.search(r"project\(gapcheck VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
work = ROOT / "build" / "wheel"
work.mkdir(parents=True, exist_ok=True)
setup(version=version, ext_modules=[Extension("gapcheck._core", [])], cmdclass={"build_ext": CMakeBuild},
      options={"build": {"build_base": str(work)}, "egg_info": {"egg_base": str(work)}})
