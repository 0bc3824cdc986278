#!/usr/bin/env python3
"""Tries gapcheck as on a new machine: a Debian 12 with nothing but its base system, in a folder of its own. Runs the
commands of the README there, from the clone to the page for a browser, and puts them with their times into
docs/getting-started.md. With --more it tries the pipelines of docs/ci and the documentation site there too, each with no
packages but those of its list, and leaves the page as it is.

usage: fresh_debian.py FOLDER [--mirror URL] [--more]
Needs root, debootstrap and the network. FOLDER keeps the base system as an archive; what is tried is unpacked anew.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/bench"))
from page import machine, section  # noqa: E402

# What a user types as root in the new system; the repository replaces the address that they clone.
COMMANDS = [
    "apt-get update",
    "apt-get install -y --no-install-recommends git",
    "git clone /srv/gapcheck.git",
    "cd gapcheck",
    "./run audit data/two_plates.k",
    "./run audit data/two_plates.k --html two_plates.html",
    "./run fix data/two_plates.k -o fixed",
    "./run audit fixed/two_plates.k",
]
INSTALL = "apt-get install -y --no-install-recommends $(cat {} | grep -v '#')"
GAPCHECK = "build/release/apps/gapcheck/gapcheck"
MORE = [
    INSTALL.format("scripts/packages.txt") + " python3-dev pybind11-dev",
    "cmake --preset release -DGAPCHECK_TESTS=OFF -DGAPCHECK_PYTHON=ON && ninja -C build/release gapcheck gapcheck_python",
    INSTALL.format("scripts/site/packages.txt"),
    "python3 -B scripts/make_site.py",
    "apt-get install -y --no-install-recommends pre-commit python3-junitparser python3-yaml",
    f"python3 -B tests/ci/check_pre_commit.py {GAPCHECK}",
    f"python3 -B tests/ci/check_pipelines.py {GAPCHECK}",
]


def base_system(folder, mirror):
    """An archive of the base system, made once."""
    archive = folder / "base.tar"
    if not archive.exists():
        tree = folder / "base"
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", tree, mirror], check=True)
        subprocess.run(["tar", "-C", tree, "-cf", folder / "unfinished.tar", "."], check=True)
        (folder / "unfinished.tar").rename(archive)
        shutil.rmtree(tree)
    return archive


def unpack(archive, folder):
    tree = folder / "tree"
    if tree.exists():
        subprocess.run(["umount", tree / "proc"], check=False, stderr=subprocess.DEVNULL)
        shutil.rmtree(tree)
    tree.mkdir()
    subprocess.run(["tar", "-C", tree, "-xf", archive], check=True)
    shutil.copy("/etc/resolv.conf", tree / "etc/resolv.conf")
    subprocess.run(["git", "clone", "-q", "--bare", ROOT, tree / "srv/gapcheck.git"], check=True)
    subprocess.run(["mount", "-t", "proc", "proc", tree / "proc"], check=True)
    return tree


def run(tree, command, place):
    """One command: its last line of output, exit code, seconds."""
    environment = {"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root",
                   "LANG": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive"}
    start = time.perf_counter()
    process = subprocess.run(["chroot", tree, "/bin/bash", "-c", f"cd {place} && {command}"], env=environment,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    seconds = time.perf_counter() - start
    lines = [line for line in process.stdout.splitlines() if line.strip()]
    if process.returncode not in (0, 1):
        sys.exit(f"{command}: exit {process.returncode}\n{process.stdout[-2000:]}{process.stderr[-2000:]}")
    return (lines[-1] if lines else ""), process.returncode, seconds


def spoken(seconds):
    return f"{seconds:.1f} s" if seconds < 100 else f"{seconds:.0f} s"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--mirror", default="http://deb.debian.org/debian")
    parser.add_argument("--more", action="store_true", help="try the pipelines and the site too; writes no page")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    tree = unpack(base_system(arguments.folder, arguments.mirror), arguments.folder)
    rows, place = [], "/root"
    try:
        for command in COMMANDS + (MORE if arguments.more else []):
            if command.startswith("cd "):
                place += "/" + command[3:]
                rows.append(f"| `{command}` | | |")
                continue
            start = time.time()
            last, status, seconds = run(tree, command, place)
            shown = last if command.startswith("./run") else ""
            packages = tree / "root/gapcheck/build/.packages"
            first = command.startswith("./run") and packages.stat().st_mtime > start
            parts = f", {spoken(packages.stat().st_mtime - start)} of it for packages" if first else ""
            rows.append(f"| `{command.replace('/srv/gapcheck.git', 'ADDRESS')}` | {shown} | {spoken(seconds)}{parts} |")
            print(f"{command}: exit {status}, {seconds:.1f} s, {last}", flush=True)
            if command in MORE and status != 0:
                sys.exit(f"{command} failed")
        page = tree / "root/gapcheck/two_plates.html"
        rows.append(f"\nThe page `two_plates.html` has {page.stat().st_size / 1e6:.1f} MB. {machine()}; "
                    "no compiler cache; times of the network are in the first rows.")
    finally:
        subprocess.run(["umount", tree / "proc"], check=False)
    if arguments.more:
        return
    guide = ROOT / "docs/getting-started.md"
    table = "| command | last line | time |\n|---|---|---:|\n" + "\n".join(rows)
    guide.write_text(section("fresh", guide.read_text(), table))


if __name__ == "__main__":
    main()
