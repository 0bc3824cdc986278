#!/usr/bin/env python3
"""Tries the programs that scripts/machines.py has built: those of Linux in a root that holds nothing else and in the
oldest Debian of the mirror, those of arm64 by QEMU, those of Windows by Wine. Whatever they print and write must be
what the usual programs print and write, byte for byte, apart from times and the separators in names of folders. Runs
may differ where the C library or the processor rounds otherwise; those that do are counted.

usage: check_machines.py GAPCHECK CHECK_C [MACHINE …] [--mirror URL] [--small] [--page docs/machines.md]
GAPCHECK and CHECK_C: the usual programs, of the same commit. --small: every tenth deck. --page: puts the table into
that page. Needs root, for chroot, and the packages of scripts/machines/packages.txt. Exit 1: something differs.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
sys.path.insert(0, str(ROOT / "tests/bench"))
sys.path.insert(0, str(ROOT / "tests/apps/lsp"))
import client  # noqa: E402
from machines import ALL, MACHINES, PROGRAMS  # noqa: E402
from page import section  # noqa: E402
from record_outputs import dates, normal  # noqa: E402

OLD_DEBIAN = "bullseye"
STARTERS = {"linux-x86-64": [], "linux-arm64": ["qemu-aarch64-static"], "windows-x86-64": ["/usr/lib/wine/wine64"]}
# A folder, a deck and its include as they are called in another country.
PLACE, DECK, INCLUDE = "Gehäuse prüfen", "größe 1.k", "teile/netz größe.k"
LOGS = ["clean/messag", "soft2/messag", "smp/d3hsp"]
CHECK_C = ["-all", "-list", "-title", "-typ", "-typkey", "-timestep"]


class Programs:
    """gapcheck and check-c of one machine, and how they are started on this one."""

    def __init__(self, gapcheck, check_c, starter=()):
        self.paths = {"gapcheck": gapcheck.resolve(), "check-c": check_c.resolve()}
        self.starter = list(starter)

    def call(self, program, arguments, folder):
        command = [*self.starter, self.paths[program], *arguments]
        return subprocess.run(command, cwd=folder, capture_output=True, timeout=900)


def programs_of(machine):
    folder = PROGRAMS / machine.name
    paths = (folder / f"{program}{machine.ending}" for program in ("gapcheck", "check-c"))
    return Programs(*paths, STARTERS[machine.name])


def plain(data, top):
    """Without times, versions and what separates folders."""
    text = dates.sub(b"", data).decode("utf-8", "surrogateescape")
    return normal(re.sub(r"\\+", "/", text).replace(f"Z:{top}", "TOP").replace(str(top), "TOP"), "NONE")


def take_files(folder, top):
    """What every file below a folder holds, by its name; the folder is removed."""
    paths = [path for path in folder.rglob("*") if path.is_file()]
    files = {str(path.relative_to(folder)): plain(path.read_bytes(), top) for path in paths}
    shutil.rmtree(folder, ignore_errors=True)
    return files


def copy_inputs(top):
    shutil.copytree(ROOT / "data", top / "data")
    shutil.copytree(ROOT / "tests/apps/fixtures", top / "logs")
    place = top / PLACE
    (place / INCLUDE).parent.mkdir(parents=True)
    shutil.copy(ROOT / "data/include/plates_mesh.k", place / INCLUDE)
    deck = (ROOT / "data/include_parameter.k").read_text().replace("include/plates_mesh.k", INCLUDE.replace("/", "\\"))
    (place / DECK).write_bytes(deck.encode())
    (place / "crlf.k").write_bytes(deck.replace("\n", "\r\n").encode())
    # Half a surrogate, and bytes that are in no text.
    (place / "broken.k").write_bytes(deck.replace("*END\n", "*INCLUDE\n").encode() + b"\xed\xa0\x80\xff\xc3.k\n")


class Comparison:
    """Calls the programs of two machines in two copies of the same folder, and keeps what differs."""

    def __init__(self, usual, other, place):
        self.sides = [(usual, place / "usual"), (other, place / "other")]
        for _, top in self.sides:
            copy_inputs(top)
        self.calls, self.files, self.rounded, self.differences = {}, 0, 0, []

    def same(self, program, arguments, folder=".", writes=None, other=None, rounds=False):
        """Exit code, output, errors and files in the folder `writes` are the same. `other`: what the other is told.
        `rounds`: all but the exit code may be otherwise, which is counted."""
        seen = []
        for (programs, top), words in zip(self.sides, (arguments, other or arguments)):
            done = programs.call(program, words, top / folder)
            files = take_files(top / writes, top) if writes else {}
            seen.append({"exit": done.returncode, "output": plain(done.stdout, top), "errors": plain(done.stderr, top),
                         **{f"file {name}": text for name, text in files.items()}})
        command = "check-c" if program == "check-c" else arguments[0]
        self.calls[command] = self.calls.get(command, 0) + 1
        self.files += len(seen[0]) - 3
        if rounds and seen[0]["exit"] == seen[1]["exit"] and seen[0].keys() == seen[1].keys():
            self.rounded += seen[0] != seen[1]
            return
        for what in sorted(seen[0].keys() | seen[1].keys()):
            first, second = seen[0].get(what), seen[1].get(what)
            if first != second:
                call = f"{command} {' '.join(arguments[1:])}, {what}"
                self.differences.append(f"{call}: {first_difference(first, second)}")

    def same_server(self):
        first, second = (serve(programs, top) for programs, top in self.sides)
        self.calls["lsp"] = 1
        if first != second:
            self.differences.append(f"lsp: {first_difference(first, second)}")

    def count(self):
        calls = ", ".join(f"{count} × {command}" for command, count in sorted(self.calls.items()))
        rounded = f"; {self.rounded} runs rounded otherwise" if self.rounded else ""
        return f"{calls}; {self.files} files written{rounded}"


def first_difference(first, second):
    lines = [str(text).splitlines() for text in (first, second)]
    for number, (a, b) in enumerate(zip(*lines), 1):
        if a != b:
            return f"line {number}: {a[:200]!r}, not {b[:200]!r}"
    return f"{len(lines[0])} lines, not {len(lines[1])}"


def try_deck(seen, deck):
    folder, name, fixed = str(deck.parent), deck.name, f"fixed {deck.stem}"
    seen.same("gapcheck", ["audit", name, "--no-config", "--fail-on", "note"], folder)
    seen.same("gapcheck", ["audit", name, "--no-config", "--format", "json", "--list"], folder)
    if deck.parent.name in ("data", "fix"):
        seen.same("gapcheck", ["fix", name, "-o", fixed], folder, f"{folder}/{fixed}")


def try_names(seen, windows):
    seen.same("gapcheck", ["audit", f"{PLACE}/{DECK}", "--format", "json"], other=windows and
              ["audit", f"{PLACE}\\{DECK}", "--format", "json"])
    seen.same("gapcheck", ["audit", "data/**/thickness_s*.k"], other=windows and ["audit", "data\\**\\thickness_s*.k"])
    for name in ("crlf.k", "broken.k", "none ß.k"):
        seen.same("gapcheck", ["audit", name], PLACE)
    seen.same("gapcheck", ["fix", DECK, "-o", "verschoben 😀"], PLACE, f"{PLACE}/verschoben 😀")
    seen.same("gapcheck", ["audit", DECK, "--output", "none/report"], PLACE)
    for top in (top for _, top in seen.sides):
        (top / "seiten ö").mkdir()
        (top / "seiten ö/größe.html").write_text("what was there before")
    seen.same("gapcheck", ["audit", f"{PLACE}/{DECK}", "--html", "seiten ö/größe.html", "-o", "seiten ö/text"],
              writes="seiten ö")
    for _ in range(2):  # the second call continues the first one
        seen.same("gapcheck", ["audit", DECK, "--results", "bisher ü"], PLACE)
    if windows:  # finds names in Latin-1 too; on Linux a name is its bytes
        deck = seen.sides[1][1] / PLACE / DECK
        deck.write_bytes(deck.read_text().encode("latin-1"))
        seen.same("gapcheck", ["audit", DECK, "--format", "csv"], PLACE)


def compare(usual, machine, small):
    """What all machines are asked."""
    windows = machine.ending == ".exe"
    if windows:  # makes its settings, which several programs at once must not
        subprocess.run([*STARTERS[machine.name], "wineboot", "--init"], check=True, capture_output=True)
    with tempfile.TemporaryDirectory() as place:
        seen = Comparison(usual, programs_of(machine), pathlib.Path(place))
        decks = sorted(path.relative_to(ROOT) for path in (ROOT / "data").rglob("*.k"))[::10 if small else 1]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda deck: try_deck(seen, deck), decks))
        seen.same_server()
        try_names(seen, windows)
        for log in LOGS:
            seen.same("check-c", [*CHECK_C, log], "logs")
            seen.same("gapcheck", ["messag", log, "--format", "json"], "logs")
        seen.same("gapcheck", ["explain", "GC101"])
        for deck in decks:
            if deck.parent.name in ("benchmarks", "workshop", "tutorial"):
                seen.same("gapcheck", ["run", deck.name, "-o", "lauf ö", "--cycles", "50", "--ignore-unsupported"],
                          str(deck.parent), f"{deck.parent}/lauf ö", rounds=machine.name != "linux-x86-64")
        if 2 * seen.rounded > seen.calls.get("run", 0):
            seen.differences.append(f"{seen.rounded} runs differ: too many for roundings")
        return seen


def kernel(machine):
    """The oldest Linux that the C library of a static program runs on."""
    notes = subprocess.run(["readelf", "-n", PROGRAMS / machine.name / "gapcheck"], check=True, capture_output=True,
                           text=True).stdout
    return "Linux " + re.search(r"OS: Linux, ABI: (\d+\.\d+)", notes)[1]


def needed_libraries(machine):
    """What the programs of a machine load when they start."""
    needed = set()
    for path in (PROGRAMS / machine.name).iterdir():
        if path.name in ("LICENSE", "NOTICE"):
            continue
        shown = subprocess.run([machine.tool("objdump"), "-p", path], check=True, capture_output=True, text=True).stdout
        needed.update(re.findall(r"^\s*(?:DLL Name:|NEEDED)\s+(\S+)", shown, re.MULTILINE))
        if "INTERP" in shown:
            needed.add("a loader of shared libraries")
    return sorted(needed)


def serve(programs, top):
    """What the language server says of two decks and of a card."""
    drive = "/Z%3A" if programs.starter and "wine" in programs.starter[0] else ""
    client.uri_of = lambda path: f"file://{drive}{urllib.parse.quote(os.path.abspath(path))}"
    start = top / "gapcheck"
    start.write_text(f'#!/bin/sh\nexec {" ".join([*programs.starter, str(programs.paths["gapcheck"])])} "$@"\n')
    start.chmod(0o755)
    server = client.Client(str(start), str(top))
    server.start()
    said = {}
    for deck in ("data/two_plates.k", f"{PLACE}/{DECK}"):
        server.open(deck)
        said[f"{deck} in the log"] = re.sub(r"[\d.]+ m?s", "", server.audited())
        said[deck] = server.wait(lambda message: message.get("method") == "textDocument/publishDiagnostics" and
                                 message["params"]["diagnostics"])["params"]
    said["hover"] = server.request("textDocument/hover", server.at("data/two_plates.k", 20, 12))
    said["exit"] = server.stop()
    return plain(json.dumps(said, ensure_ascii=False, indent=1).replace(client.uri_of(top), str(top)).encode(), top)


def in_root(tree, machine, usual):
    """What the programs below another root do differently from the usual ones here, with a deck and a log."""
    shutil.copy(ROOT / "data/two_plates.k", tree)
    shutil.copy(ROOT / "tests/apps/fixtures/soft2/messag", tree)
    for program in ("gapcheck", "check-c"):
        shutil.copy(PROGRAMS / machine.name / program, tree)
    different = []
    for program, arguments in (("gapcheck", ["audit", "two_plates.k"]), ("check-c", [*CHECK_C, "messag"]),
                               ("gapcheck", ["fix", "two_plates.k", "-o", "fixed"])):
        there = ["chroot", tree, f"/{program}", *arguments]
        seen = []
        for call in (lambda: subprocess.run(there, capture_output=True), lambda: usual.call(program, arguments, tree)):
            done = call()
            seen.append((done.returncode, plain(done.stdout, tree), plain(done.stderr, tree),
                         take_files(tree / "fixed", tree)))
        if seen[0] != seen[1]:
            different.append(f"{program} {' '.join(arguments)} below {tree}: {seen[0]}, not {seen[1]}"[:500])
    return different


def old_debian(mirror):
    """A base system of the oldest Debian that the mirror has, made once."""
    tree = MACHINES / OLD_DEBIAN
    if not tree.exists():
        making = MACHINES / f"{OLD_DEBIAN}-unfinished"
        shutil.rmtree(making, ignore_errors=True)
        subprocess.run(["debootstrap", "--variant=minbase", OLD_DEBIAN, making, mirror], check=True,
                       stdout=subprocess.DEVNULL)
        making.rename(tree)
    return tree


def check(machine, usual, arguments):
    """A row of the table, and what differs."""
    seen = compare(usual, machine, arguments.small)
    libraries, different = needed_libraries(machine), seen.differences
    tried = {"linux-x86-64": "here", "linux-arm64": "QEMU", "windows-x86-64": "Wine"}[machine.name]
    if machine.system == "Linux" and libraries:
        different.append(f"needs {', '.join(libraries)}")
    if machine.name == "linux-x86-64":
        with tempfile.TemporaryDirectory() as empty:
            different += in_root(pathlib.Path(empty), machine, usual)
        different += in_root(old_debian(arguments.mirror), machine, usual)
        tried = f"here, in an empty root, in Debian {OLD_DEBIAN}"
    sizes = [f"{(PROGRAMS / machine.name / (program + machine.ending)).stat().st_size / 1e6:.1f} MB"
             for program in ("gapcheck", "check-c")]
    needs = ", ".join(libraries) if libraries else kernel(machine)
    row = f"| {machine.name} | {' | '.join(sizes)} | {needs} | {tried} | {seen.count()} | {len(different) or 'none'} |"
    print(f"{machine.name}: {tried}: {seen.count()}: {len(different)} differences; needs {needs}; {', '.join(sizes)}")
    for difference in different:
        print(f"  {difference}")
    sys.stdout.flush()
    return row, different


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck", type=pathlib.Path)
    parser.add_argument("check_c", type=pathlib.Path)
    parser.add_argument("machines", nargs="*", metavar="MACHINE")
    parser.add_argument("--mirror", default="http://deb.debian.org/debian")
    parser.add_argument("--small", action="store_true")
    parser.add_argument("--page", type=pathlib.Path)
    arguments = parser.parse_args()
    for program in (arguments.gapcheck, arguments.check_c):
        if not program.is_file():
            parser.error(f"{program}: is not there; build it first, or give the path of the program")
    wine = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
    os.environ.update(WINEPREFIX=wine.name, WINEDEBUG="-all", LC_ALL="C.UTF-8")
    usual = Programs(arguments.gapcheck, arguments.check_c)
    checked = [check(machine, usual, arguments) for machine in ALL if machine.name in arguments.machines or
               not arguments.machines]
    if arguments.page:
        head = ["| machine | gapcheck | check-c | needs | tried | calls | differences |",
                "|---|---:|---:|---|---|---|---|"]
        table = "\n".join(head + [row for row, _ in checked])
        arguments.page.write_text(section("machines", arguments.page.read_text(), table))
    sys.exit(1 if any(different for _, different in checked) else 0)


if __name__ == "__main__":
    main()
