#!/usr/bin/env python3
"""Counts the instructions of small cases and compares them with those on record.

    instructions.py GAPCHECK            fails if a count has changed by more than 3 %, and names the functions that changed
    instructions.py GAPCHECK --update   writes instructions.json

GAPCHECK is the program of the release build as ./test makes it: rooms in large units. Counts are those of valgrind's callgrind on
one thread; they do not depend on the load of the machine, and hardly on the machine. A change that is meant writes the
record anew, in the same commit.
"""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

RECORD = pathlib.Path(__file__).with_suffix(".json")
LONGEST = 160  # characters of a function name that are on record
MOST = 0.03  # largest change of a count
LISTED = 0.02  # functions with at least this share of a case are on record

MATERIAL = "*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n"
CONTACT = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n"


def plates(n, apart, more=""):
    """A deck with two plates of n x n shells, 1 thick, with edges of 5; the upper one `apart` higher, and a third aside."""
    lines = ["*KEYWORD", "*CONTROL_TERMINATION", "1."]
    for part in (1, 2):
        lines += ["*PART", "plate", f"{part},1,1"]
    lines += ["*SECTION_SHELL", "1,2", "1."]
    nodes, shells = ["*NODE"], ["*ELEMENT_SHELL"]
    row = n + 1
    for part in (1, 2):
        first = (part - 1) * row * row + 1
        for j in range(row):
            for i in range(row):
                x, y = 5 * i + 1.7 * (part - 1), 5 * j + 1.3 * (part - 1)
                nodes.append(f"{first + j * row + i:8}{x:16.6f}{y:16.6f}{apart * (part - 1):16.6f}")
        for j in range(n):
            for i in range(n):
                a = first + j * row + i
                shells.append("".join(f"{v:8}" for v in ((part - 1) * n * n + j * n + i + 1, part, a, a + 1, a + 1 + row, a + row)))
    return "\n".join(lines + nodes + shells) + "\n" + MATERIAL + more + "*END\n"


FALLING = "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.,0.,-2000.\n\n"
DECKS = {
    "mesh": plates(60, 2.0),
    "apart": plates(60, 50.0, CONTACT),
    "touching": plates(60, 0.9, CONTACT),
    "moving": plates(24, 1.0001, FALLING),
    "impact": plates(24, 1.0001, FALLING + CONTACT),
}
# Name, deck, arguments. OUT is a folder to write into.
CASES = [
    ("reading", "mesh", ["audit", "DECK", "--select", "GC101"]),
    ("surfaces", "apart", ["audit", "DECK", "--select", "GC101"]),
    ("decisions", "touching", ["audit", "DECK", "--select", "GC101"]),
    ("exact decisions", "touching", ["audit", "DECK", "--select", "GC101", "--exact"]),
    ("all rules", "touching", ["audit", "DECK"]),
    ("writers", "touching", ["audit", "DECK", "--format", "json", "--output", "OUT/a.json", "--html", "OUT/a.html", "--vtu", "OUT/a.vtu"]),
    ("elements", "moving", ["run", "DECK", "-o", "OUT/run", "--cycles", "60"]),
    ("contact", "impact", ["run", "DECK", "-o", "OUT/run", "--cycles", "60"]),
]


def count(program, folder, deck, arguments):
    """Instructions of one call, and by function without what it calls."""
    out = folder / "out"
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir()
    words = [word.replace("DECK", str(deck)).replace("OUT", str(out)) for word in arguments]
    profile = folder / "profile"
    call = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", program, *words, "--jobs", "1"]
    run = subprocess.run(call, capture_output=True, text=True, cwd=folder)
    if run.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(words)}: exit {run.returncode}\n{run.stderr[-2000:]}")
    listing = subprocess.run(["callgrind_annotate", "--threshold=99", str(profile)], capture_output=True, text=True).stdout
    total, functions = 0, {}
    for line in listing.splitlines():
        found = re.match(r"\s*([\d,]+) \([^)]*\)\s+(.*)", line)
        if not found:
            continue
        instructions = int(found[1].replace(",", ""))
        if found[2].startswith("PROGRAM TOTALS"):
            total = instructions
        elif total:
            name = re.sub(r" \[[^\]]*\]$", "", found[2].split(":", 1)[-1])[:LONGEST]
            functions[name] = functions.get(name, 0) + instructions
    if total == 0:
        raise SystemExit(f"callgrind_annotate printed no totals:\n{listing[:500]}")
    return total, {name: value for name, value in functions.items() if value >= LISTED * total}


def changed_functions(before, now):
    """The functions whose counts have changed most, in words."""
    changes = {name: now.get(name, 0) - before.get(name, 0) for name in {*before, *now}}
    worst = sorted(changes, key=lambda name: -abs(changes[name]))[:4]
    return [f"    {changes[name]:+,} {name}" for name in worst if changes[name] != 0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--record", type=pathlib.Path, default=RECORD, metavar="FILE", help="instead of instructions.json")
    parser.add_argument("--only", nargs="+", metavar="CASE", help="only these cases")
    arguments = parser.parse_args()
    program = str(pathlib.Path(arguments.program).resolve())
    record = {} if arguments.update else json.loads(arguments.record.read_text())
    counts, failures = {}, []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for deck, text in DECKS.items():
            (folder / f"{deck}.k").write_text(text)
        for case, deck, words in CASES:
            if arguments.only and case not in arguments.only:
                continue
            total, functions = count(program, folder, folder / f"{deck}.k", words)
            counts[case] = {"instructions": total, "functions": functions}
            if arguments.update:
                print(f"{case:16}{total:>16,}")
                continue
            before = record[case]["instructions"]
            print(f"{case:16}{total:>16,}  {100 * (total / before - 1):+.2f} %")
            if abs(total / before - 1) > MOST:
                failures.append(f"{case}: {before:,} instructions on record, {total:,} now")
                failures += changed_functions(record[case]["functions"], functions)
    if arguments.update:
        arguments.record.write_text(json.dumps(counts, indent=1) + "\n")
    if failures:
        print("\n".join(failures), file=sys.stderr)
        print(f"If this is meant: {pathlib.Path(__file__).name} GAPCHECK --update, in the same commit", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
