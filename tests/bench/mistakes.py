#!/usr/bin/env python3
"""Memory and time of decks with one gross mistake.

Each deck is small and wrong in one way: a contact thickness in another unit, thousands of nodes in one point, a
contact for each pair of parts, includes that multiply. `write` writes them into a folder, `measure` runs the commands
on them and prints a table.

    tests/bench/mistakes.py write build/mistakes
    tests/bench/mistakes.py measure build/release/apps/gapcheck/gapcheck build/mistakes
"""
import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from typing import NamedTuple, Optional

MATERIAL = "*MAT_ELASTIC\n         1  7.85e-09   210000.       0.3\n"
COMMANDS = ("audit", "run", "fix")


def part(number, thickness=1.0, material=MATERIAL):
    """A part with a section of its own; the material is given once."""
    return (f"*PART\npart {number}\n{number:10d}{number:10d}         1\n*SECTION_SHELL\n{number:10d}         2\n"
            + f"{thickness:10.4g}" * 4 + "\n" + (material if number == 1 else ""))


def plate(first, number, count, size, z, columns=None):
    """Nodes and shells of a plate of count x columns nodes, ids from `first` on."""
    columns = columns or count
    nodes, shells = [], []
    for j in range(columns):
        for i in range(count):
            nodes.append(f"{first + j * count + i:8d}{i * size:16.6g}{j * size:16.6g}{z:16.6g}")
    for j in range(columns - 1):
        for i in range(count - 1):
            a = first + j * count + i
            shells.append(f"{a:8d}{number:8d}{a:8d}{a + 1:8d}{a + 1 + count:8d}{a + count:8d}")
    return nodes, shells


def deck(parts, nodes, shells, contacts, title, extra=""):
    lines = ["*KEYWORD", "*TITLE", title, "*CONTROL_TERMINATION", "     0.001"]
    text = "\n".join(lines) + "\n" + "".join(parts) + "*NODE\n" + "\n".join(nodes)
    if shells:
        text += "\n*ELEMENT_SHELL\n" + "\n".join(shells)
    return text + "\n" + extra + "".join(contacts) + "*END\n"


def contact(keyword, number, a, b, types=(2, 2), sst=None):
    """A contact; `sst`: the thickness of both sides."""
    thickness = f"{sst:10.4g}{sst:10.4g}" if sst is not None else " " * 20
    return (f"*CONTACT_{keyword}_ID\n{number:10d}contact {number}\n{a:10d}{b:10d}{types[0]:10d}{types[1]:10d}\n"
            f"\n{'':10s}{'':10s}{thickness}\n")


def set_of_parts(number, members):
    text = f"*SET_PART_LIST\n{number:10d}\n"
    for at in range(0, len(members), 8):
        text += "".join(f"{m:10d}" for m in members[at:at + 8]) + "\n"
    return text


def thick_plates(nodes_each, keyword, sst=1000.0, tail=""):
    """Two plates of elements of 5, 3 apart, in a contact that is `sst` thick."""
    count = round(nodes_each ** 0.5)
    n1, s1 = plate(1, 1, count, 5, 0)
    n2, s2 = plate(1 + 10 ** 6, 2, count, 5, 3)
    single = "SINGLE" in keyword or "GENERAL" in keyword
    sides = (1, 0, (2, 2)) if single else (1, 2, (3, 3))
    return deck([part(1), part(2)], n1 + n2, s1 + s2,
                [contact(keyword, 1, sides[0], sides[1], sides[2], sst) + tail], "a thickness in the wrong unit",
                set_of_parts(1, [1, 2]) if single else "")


def one_point(count, shells_too):
    """`count` nodes in the middle of a plate that they are tracked against; with shells that have no size."""
    nodes, shells = plate(1, 1, 20, 5, 0)
    nodes += [f"{10000 + i:8d}{47.5:16.6g}{47.5:16.6g}{0.2:16.6g}" for i in range(count)]
    if shells_too:
        for a in range(10000, 10000 + count - 3, 4):
            shells.append(f"{a:8d}{2:8d}{a:8d}{a + 1:8d}{a + 2:8d}{a + 3:8d}")
        return deck([part(1), part(2)], nodes, shells, [contact("AUTOMATIC_SINGLE_SURFACE", 1, 1, 0)],
                    "shells in one point", set_of_parts(1, [1, 2]))
    text = "*SET_NODE_LIST\n         7\n"
    for at in range(0, count, 8):
        text += "".join(f"{10000 + i:10d}" for i in range(at, min(count, at + 8))) + "\n"
    return deck([part(1)], nodes, shells, [contact("AUTOMATIC_NODES_TO_SURFACE", 1, 7, 1, (4, 3))],
                "nodes in one point", text)


def many_contacts(count):
    """Small parts in a row; a contact for each pair of near ones."""
    parts_needed = max(10, count // 50)
    nodes, shells, parts = [], [], []
    for p in range(parts_needed):
        n, s = plate(1 + 10 * p, p + 1, 3, 5, 0.7 * p)
        nodes += n
        shells += s
        parts.append(part(p + 1))
    pairs = ((p, p + step) for step in range(1, parts_needed) for p in range(1, parts_needed - step + 1))
    contacts = [contact("AUTOMATIC_SURFACE_TO_SURFACE", i + 1, *pair, (3, 3))
                for i, pair in zip(range(count), pairs)]
    return deck(parts, nodes, shells, contacts, "a contact for each pair of parts")


def all_in_each(count):
    """Contacts that all hold the same two plates."""
    n1, s1 = plate(1, 1, 50, 5, 0)
    n2, s2 = plate(1 + 10 ** 6, 2, 50, 5, 0.7)
    contacts = [contact("AUTOMATIC_SURFACE_TO_SURFACE", i + 1, 1, 2, (3, 3)) for i in range(count)]
    return deck([part(1), part(2)], n1 + n2, s1 + s2, contacts, "the same contact many times")


def write_includes(folder):
    """230 kB that multiply to gigabytes: a file that is included by each of the files that include each other."""
    nodes, shells = plate(1, 1, 48, 5, 0)
    with open(os.path.join(folder, "includes_leaf.k"), "w") as out:
        out.write("*KEYWORD\n*NODE\n" + "\n".join(nodes) + "\n*ELEMENT_SHELL\n" + "\n".join(shells) + "\n*END\n")
    for level, (name, inner) in enumerate((("includes_inner.k", "includes_leaf.k"),
                                           ("includes_middle.k", "includes_inner.k"),
                                           ("includes.k", "includes_middle.k"))):
        with open(os.path.join(folder, name), "w") as out:
            out.write("*KEYWORD\n" + (part(1) if level == 2 else "") + f"*INCLUDE\n{inner}\n" * 24 + "*END\n")


def write_comment_includes(folder):
    """The same with nothing but comments."""
    with open(os.path.join(folder, "comments_leaf.k"), "w") as out:
        out.write("*KEYWORD\n" + "$ nothing\n" * 23000 + "*END\n")
    nodes, shells = plate(1, 1, 5, 5, 0)
    text = deck([part(1)], nodes, shells, [contact("AUTOMATIC_SINGLE_SURFACE", 1, 0, 0, (5, 0))], "comments")
    with open(os.path.join(folder, "comments.k"), "w") as out:
        out.write(text.replace("*END\n", "*INCLUDE\ncomments_leaf.k\n" * 9990 + "*END\n"))


DECKS = {
    "thickness_half_mb": lambda: thick_plates(2500, "AUTOMATIC_SINGLE_SURFACE"),
    "thickness_one_mb": lambda: thick_plates(5000, "AUTOMATIC_SINGLE_SURFACE"),
    "thickness_20000": lambda: thick_plates(10000, "AUTOMATIC_SINGLE_SURFACE"),
    "thickness_surfaces_20000": lambda: thick_plates(10000, "AUTOMATIC_SURFACE_TO_SURFACE"),
    "thickness_old_20000": lambda: thick_plates(10000, "SURFACE_TO_SURFACE"),
    "thickness_general_half_mb": lambda: thick_plates(2500, "AUTOMATIC_GENERAL"),
    "thickness_general_20000": lambda: thick_plates(10000, "AUTOMATIC_GENERAL_INTERIOR"),
    "thickness_mortar_20000": lambda: thick_plates(10000, "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"),
    "thickness_tied_20000": lambda: thick_plates(10000, "TIED_SHELL_EDGE_TO_SURFACE"),
    "thickness_segments_20000": lambda: thick_plates(10000, "AUTOMATIC_SINGLE_SURFACE",
                                                     tail=f"{2:10d}\n"),
    "point_nodes": lambda: one_point(10000, False),
    "point_shells": lambda: one_point(10000, True),
    "contacts_100000": lambda: many_contacts(100000),
    "contacts_same_2000": lambda: all_in_each(2000),
}


def write(folder):
    os.makedirs(folder, exist_ok=True)
    for name, make in DECKS.items():
        with open(os.path.join(folder, name + ".k"), "w") as out:
            out.write(make())
    write_includes(folder)
    write_comment_includes(folder)


def arguments(command, path, folder):
    if command == "run":
        return ["run", path, "--cycles", "1", "-o", folder]
    if command == "fix":
        return ["fix", path, "-o", os.path.join(folder, "fixed")]
    return [command, path]


# Starts the command from a process of its own: what the kernel reports as a child's largest memory is never less than
# what its parent had when it started it. argv: the file for the results, the limit of time, the command.
WRAPPER = """
import os, signal, sys
child = os.posix_spawn(sys.argv[3], sys.argv[3:], os.environ)
stopped = []
def stop(*_):
    stopped.append(True)
    os.kill(child, signal.SIGKILL)
signal.signal(signal.SIGALRM, stop)
signal.setitimer(signal.ITIMER_REAL, float(sys.argv[2]))
_, status, used = os.wait4(child, 0)
code = "stopped" if stopped else os.waitstatus_to_exitcode(status)
with open(sys.argv[1], "w") as out:
    print(code, used.ru_utime + used.ru_stime, used.ru_maxrss, file=out)
"""


class Measured(NamedTuple):
    """What a command took."""
    seconds: float
    processor_seconds: float
    memory: float  # largest, in MB; not less than the ten or so of the process that started it
    code: Optional[int]  # None: stopped at the limit
    last_line: str  # of its output


def measured(command, folder, limit):
    """Runs a command (program with its path, and arguments); `folder`: for the log."""
    results = os.path.join(folder, "measured")
    start = time.monotonic()
    with open(os.path.join(folder, "log"), "w+") as log:
        subprocess.run([sys.executable, "-I", "-S", "-B", "-c", WRAPPER, results, str(limit), *command],
                       stdout=log, stderr=log, check=True)
        seconds = time.monotonic() - start
        log.seek(0)
        lines = log.read().splitlines()
    with open(results) as file:
        code, processor, memory = file.read().split()
    return Measured(seconds, float(processor), int(memory) / 1024, None if code == "stopped" else int(code),
                    lines[-1] if lines else "")


def run(program, command, path, limit):
    with tempfile.TemporaryDirectory() as folder:
        return measured([os.path.abspath(program), *arguments(command, path, folder)], folder, limit)


def self_test():
    """What is measured is the command's own: neither the memory of this process, nor the time after the limit."""
    held = bytearray(300 << 20)
    with tempfile.TemporaryDirectory() as folder:
        small = measured([sys.executable, "-I", "-S", "-c", "print('end')"], folder, 60)
        large = measured([sys.executable, "-I", "-S", "-c", "x = bytearray(100 << 20); raise SystemExit(2)"], folder, 60)
        slow = measured([sys.executable, "-I", "-S", "-c", "import time; time.sleep(60)"], folder, 0.5)
    good = (small.memory < 50 and small.code == 0 and small.last_line == "end" and 100 < large.memory < 150
            and large.code == 2 and slow.code is None and slow.seconds < 30)
    if not good:
        print(small, large, slow, len(held))
    return 0 if good else 1


def measure(program, folder, names, commands, limit):
    print(f"| deck | MB | {' | '.join(f'{c}: s | MB | exit' for c in commands)} |")
    print("|---|---|" + "---|---|---|" * len(commands))
    for name in names or [*DECKS, "includes", "comments"]:
        path = os.path.join(folder, name + ".k")
        cells = [name, f"{os.path.getsize(path) / 1e6:.2f}"]
        for command in commands:
            used = run(program, command, path, limit)
            cells += [f"{used.seconds:.1f}", f"{used.memory:.0f}", "stopped" if used.code is None else str(used.code)]
        print("| " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    sub = parser.add_subparsers(dest="what", required=True)
    one = sub.add_parser("write")
    one.add_argument("folder")
    two = sub.add_parser("measure")
    two.add_argument("program")
    two.add_argument("folder")
    two.add_argument("--decks", nargs="*")
    two.add_argument("--commands", nargs="*", default=list(COMMANDS))
    two.add_argument("--limit", type=float, default=60, help="seconds after which a command is stopped")
    sub.add_parser("self-test")
    options = parser.parse_args()
    if options.what == "self-test":
        return self_test()
    if options.what == "write":
        write(options.folder)
    else:
        resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
        measure(options.program, options.folder, options.decks, options.commands, options.limit)
    return 0


if __name__ == "__main__":
    sys.exit(main())
