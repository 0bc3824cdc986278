"""The package as pip and CMake install it."""
import os
import pathlib
import subprocess
import sys

from conftest import DATA, ROOT

SCRIPT = """
import pathlib, sys, gapcheck
assert pathlib.Path(gapcheck.__file__).is_relative_to(sys.argv[2]), gapcheck.__file__
print(gapcheck.__version__, len(gapcheck.audit(sys.argv[1]).penetrations))
"""


def environment():
    return {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "GTEST_OUTPUT")}


def test_pip_install(build, tmp_path):
    """Offline, with Debian's setuptools, and with the module that is built already."""
    def run(*command, **more):
        done = subprocess.run(command, capture_output=True, text=True, env={**environment(), **more}, cwd=tmp_path)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout
    place = tmp_path / "environment"
    run(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", place)
    python = place / "bin" / "python"
    run(python, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", "--no-cache-dir", ROOT,
        GAPCHECK_BUILD=str(build))
    version = run(python, "-c", SCRIPT, DATA / "two_plates.k", place).split()
    assert version[1] == "18"
    shown = run(python, "-m", "pip", "show", "-f", "gapcheck")
    assert f"Version: {version[0]}" in shown and "gapcheck/py.typed" in shown and "gapcheck/_core.pyi" in shown


def test_cmake_install(build, tmp_path):
    done = subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", tmp_path], capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stderr
    folder = tmp_path / "lib/python3/dist-packages"
    here = build / "python"
    names = {path.name for path in (here / "gapcheck").iterdir() if path.is_file()}
    assert {path.name for path in (folder / "gapcheck").iterdir()} == names
    assert names == {path.name for path in (ROOT / "python/gapcheck").iterdir() if path.is_file()} | {
        path.name for path in (here / "gapcheck").glob("_core*.so")}
    done = subprocess.run([sys.executable, "-B", "-c", SCRIPT, DATA / "two_plates.k", tmp_path], capture_output=True,
                          text=True, env={**environment(), "PYTHONPATH": str(folder)})
    assert done.stdout.endswith(" 18\n"), done.stderr
