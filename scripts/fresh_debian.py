#!/usr/bin/env python3
"""Tries gapcheck as on a new machine: a Debian 12 with nothing but its base system, in a folder of its own. Runs the
commands of the README there, from the clone to the page for a browser, and puts them with their times into
docs/getting-started.md. With --more it tries there, after the clone, what else people work with, each with no packages but
those of its list: the Python package, binout files, the language server, the pipelines and a campaign of docs/ci, the
documentation site, and the programs for other machines. It leaves that page as it is then.

usage: fresh_debian.py FOLDER [--mirror URL] [--more [PART …]]
Needs root, debootstrap and the network. FOLDER keeps the base system as an archive; what is tried is unpacked anew.
PART: python, binout, lsp, pipelines, campaign, site, machines; the first is always tried, since it builds the others.
"""

import argparse
import pathlib
import shutil
import socket
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
HOME = "/root"  # in the new system
CLONE = COMMANDS[:4]
INSTALL = "apt-get install -y --no-install-recommends "
LISTED = INSTALL + "$(cat {} | grep -v '#')"
BUILD = "build/python"  # where pip builds
GAPCHECK = f"{BUILD}/apps/gapcheck/gapcheck"
AUDIT = """'import gapcheck; print(gapcheck.__file__, gapcheck.audit("data/two_plates.k"))'"""
MORE = {
    "python": [
        LISTED.format("scripts/packages.txt") + " pybind11-dev python3-dev python3-numpy python3-pandas python3-pip "
        "python3-setuptools python3-venv python3-wheel",
        "python3 -m venv --system-site-packages ../environment",
        "../environment/bin/pip install --no-build-isolation --no-index .",
        f"../environment/bin/python -c {AUDIT}",
        f"ninja -C {BUILD} gapcheck check-c",
    ],
    "binout": [f"python3 -B tests/apps/check_binout.py {GAPCHECK} ."],
    "lsp": [
        INSTALL + "neovim",
        f"python3 -B tests/apps/lsp/check_lsp.py {GAPCHECK} .",
        f"python3 -B tests/apps/lsp/check_sessions.py {GAPCHECK}",
        f"python3 -B tests/apps/lsp/check_findings.py {GAPCHECK} .",
        f"python3 -B tests/apps/lsp/check_clients.py {GAPCHECK} neovim",
        f"python3 -B scripts/lsp_latency.py {GAPCHECK}",
    ],
    "pipelines": [
        INSTALL + "pre-commit python3-junitparser python3-yaml",
        f"python3 -B tests/ci/check_pre_commit.py {GAPCHECK}",
        f"python3 -B tests/ci/check_pipelines.py {GAPCHECK}",
    ],
    "campaign": [
        INSTALL + "munge procps slurm-wlm",
        f"python3 -B scripts/slurm_campaign.py {GAPCHECK} ../campaign",
    ],
    "site": [
        LISTED.format("scripts/site/packages.txt"),
        f"python3 -B scripts/make_site.py --build {BUILD}",
    ],
    "machines": [
        LISTED.format("scripts/machines/packages.txt"),
        "python3 -B scripts/machines.py",
        f"python3 -B scripts/check_machines.py {GAPCHECK} {BUILD}/apps/check-c/check-c",
        "cat build/machines/programs/SHA256SUMS",
    ],
}


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
        unmount(tree)
        shutil.rmtree(tree)
    tree.mkdir()
    subprocess.run(["tar", "-C", tree, "-xf", archive], check=True)
    shutil.copy("/etc/resolv.conf", tree / "etc/resolv.conf")
    (tree / "etc/hosts").write_text(f"127.0.0.1 localhost {socket.gethostname()}\n")
    subprocess.run(["git", "clone", "-q", "--bare", ROOT, tree / "srv/gapcheck.git"], check=True)
    subprocess.run(["mount", "-t", "proc", "proc", tree / "proc"], check=True)
    # With the control groups below it, which Slurm wants.
    subprocess.run(["mount", "--rbind", "--make-rslave", "/sys", tree / "sys"], check=True)
    return tree


def unmount(tree):
    for place in ("sys", "proc"):
        subprocess.run(["umount", "--recursive", tree / place], check=False, stderr=subprocess.DEVNULL)
        if (tree / place).is_mount():
            sys.exit(f"{tree / place} is still in use; unmount it before anything is deleted")


def run(tree, command, place):
    """One command: its last line of output, exit code, seconds. All that it prints is added to the log beside the tree."""
    environment = {"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", "HOME": HOME,
                   "LANG": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive"}
    start = time.perf_counter()
    process = subprocess.run(["chroot", tree, "/bin/bash", "-c", f"cd {place} && {command}"], env=environment,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    seconds = time.perf_counter() - start
    with open(tree.parent / "log", "a", encoding="utf-8") as log:
        log.write(f"$ {command}\n{process.stdout}{process.stderr}exit {process.returncode}, {seconds:.1f} s\n\n")
    lines = [line for line in process.stdout.splitlines() if line.strip()]
    last = lines[-1] if lines else ""
    print(f"{command}: exit {process.returncode}, {seconds:.1f} s, {last}", flush=True)
    return last, process.returncode, seconds


def must_run(tree, command, place):
    last, status, seconds = run(tree, command, place)
    if status not in (0, 1):  # 1: an audit has found something
        sys.exit(f"{command} failed: see {tree.parent / 'log'}")
    return last, seconds


def spoken(seconds):
    return f"{seconds:.1f} s" if seconds < 100 else f"{seconds:.0f} s"


def try_readme(tree):
    """The rows of the table in docs/getting-started.md."""
    rows, place = [], HOME
    for command in COMMANDS:
        if command.startswith("cd "):
            place += "/" + command[3:]
            rows.append(f"| `{command}` | | |")
            continue
        start = time.time()
        last, seconds = must_run(tree, command, place)
        shown = last if command.startswith("./run") else ""
        packages = tree / "root/gapcheck/build/.packages"
        first = command.startswith("./run") and packages.stat().st_mtime > start
        parts = f", {spoken(packages.stat().st_mtime - start)} of it for packages" if first else ""
        rows.append(f"| `{command.replace('/srv/gapcheck.git', 'ADDRESS')}` | {shown} | {spoken(seconds)}{parts} |")
    page = tree / "root/gapcheck/two_plates.html"
    rows.append(f"\nThe page `two_plates.html` has {page.stat().st_size / 1e6:.1f} MB. {machine()}; "
                "no compiler cache; times of the network are in the first rows.")
    return rows


def try_more(tree, parts):
    """Whether each of the parts works; one that fails ends there, and the next one begins."""
    for command in CLONE[:-1]:
        must_run(tree, command, HOME)
    good = True
    for part in parts:
        print(f"-- {part}", flush=True)
        works = all(run(tree, command, HOME + "/gapcheck")[1] == 0 for command in MORE[part])
        print(f"-- {part}: {'works' if works else 'FAILED'}", flush=True)
        if part == "python" and not works:
            return False
        good = good and works
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--mirror", default="http://deb.debian.org/debian")
    parser.add_argument("--more", nargs="*", metavar="PART", choices=MORE, help="without PART: all")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    (arguments.folder / "log").unlink(missing_ok=True)
    tree = unpack(base_system(arguments.folder, arguments.mirror), arguments.folder)
    try:
        if arguments.more is not None:
            asked = [part for part in MORE if part == "python" or part in arguments.more or not arguments.more]
            sys.exit(0 if try_more(tree, asked) else 1)
        rows = try_readme(tree)
    finally:
        unmount(tree)
    guide = ROOT / "docs/getting-started.md"
    table = "| command | last line | time |\n|---|---|---:|\n" + "\n".join(rows)
    guide.write_text(section("fresh", guide.read_text(), table))


if __name__ == "__main__":
    main()
