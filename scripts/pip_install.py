#!/usr/bin/env python3
"""Installs the Python package as from nothing: clones the project, makes a virtual environment, installs with pip, which
builds the library, and audits a deck with what is installed. Nothing is taken from the network: pip runs without one, with
Debian's python3-venv, python3-pip, python3-setuptools, python3-wheel, python3-numpy, python3-dev and pybind11-dev besides
scripts/packages.txt. Prints each command with its seconds, then the version and the number of penetrations.

usage: pip_install.py FOLDER [--python PROGRAM]
FOLDER is made and must be new. Needs root or user namespaces; builds the whole library.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
OFFLINE = ["unshare", "--net", *(["--map-root-user"] if os.geteuid() else [])]
DECK, COUNT = "data/two_plates.k", 18
SCRIPT = f"""
import pathlib, sys, gapcheck
assert pathlib.Path(gapcheck.__file__).is_relative_to(sys.argv[1]), gapcheck.__file__
print(gapcheck.__version__, len(gapcheck.audit("{DECK}").penetrations))
"""


def run(command, place, shown=None):
    """What a command prints; ends the script with its output if it fails."""
    # Neither a build folder nor modules nor a compiler cache of the caller.
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "GAPCHECK_", "PIP_"))}
    begin = time.perf_counter()
    done = subprocess.run([str(word) for word in command], cwd=place, env={**environment, "CCACHE_DISABLE": "1"},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(f"{time.perf_counter() - begin:7.1f} s  {shown or ' '.join(str(word) for word in command)}", flush=True)
    if done.returncode != 0:
        sys.exit(done.stdout)
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--python", default="/usr/bin/python3")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True)
    clone, environment = arguments.folder / "gapcheck", arguments.folder / "environment"
    run(["git", "clone", "--quiet", ROOT, clone], arguments.folder, "git clone")
    run([arguments.python, "-m", "venv", "--system-site-packages", "--without-pip", environment], arguments.folder,
        "python3 -m venv --system-site-packages --without-pip environment")
    python = environment / "bin" / "python"
    run([*OFFLINE, python, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-cache-dir", "."], clone,
        "python -m pip install --no-build-isolation --no-index .")
    printed = run([*OFFLINE, python, "-c", SCRIPT, environment], clone, f"python -c 'gapcheck.audit(\"{DECK}\")'").split()
    print(f"gapcheck {printed[0]}, {printed[1]} penetrations")
    return 0 if printed[1:] == [str(COUNT)] else 1


if __name__ == "__main__":
    sys.exit(main())
