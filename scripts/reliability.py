#!/usr/bin/env python3
"""Runs the tests with hostile inputs and faults, measures decks with one gross mistake, and writes the tables of
docs/reliability.md.

    scripts/reliability.py GAPCHECK [--small | --mistakes]    GAPCHECK: the program, beside that of check-c as in a build
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/reliability.md"
sys.path.insert(0, str(ROOT / "tests/bench"))
import mistakes  # noqa: E402

# What the groups of the tests are called on the page.
INPUTS = {"decks": "decks", "logs and tables": "logs and tables of a run", "d3plot": "d3plot databases",
          "settings and tables": "settings, baselines, tables of messages", "arguments": "arguments"}
FAULTS = {"standard output": "standard output full, closed, a pipe that nobody reads",
          "full disk": "a disk that is full, early or late", "signals": "SIGTERM, SIGINT, SIGHUP",
          "memory in MB": "16 to 96 MB of memory", "descriptors": "3 to 12 open files", "threads": "no threads",
          "inputs": "inputs that are folders, pipes, devices, links, unreadable",
          "outputs": "outputs that cannot be written", "inputs that change": "inputs that change while they are read",
          "folders that vanish": "folders for results that vanish"}
# Decks of tests/bench/mistakes.py, and what is wrong with them.
MISTAKES = {"thickness_20000": "a thickness of 1000 on elements of 5, 20,000 nodes",
            "thickness_surfaces_20000": "such a thickness in a contact of two surfaces",
            "thickness_tied_20000": "such a thickness in a tied contact", "thickness_segments_20000": "such a thickness with SOFT = 2",
            "point_nodes": "10,000 nodes in one point", "point_shells": "2,500 shells in one point",
            "contacts_100000": "100,000 contacts", "contacts_same_2000": "the same contact 2,000 times",
            "includes": "230 kB of files that include each other 24³ times",
            "comments": "a file of comments that is included 9,990 times"}


def place(text, name, table):
    """The page with the table between its marks."""
    begin, end = f"<!-- {name} -->\n", f"<!-- /{name} -->"
    first, last = text.index(begin) + len(begin), text.index(end)
    return text[:first] + "\n".join(table) + "\n" + text[last:]


def summary(check, program, arguments):
    """What a test reports; it must pass."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "summary"
        done = subprocess.run([sys.executable, "-B", ROOT / f"tests/apps/hostile/check_{check}.py", program,
                               program.parent.parent / "check-c/check-c", ROOT, "--summary", file, *arguments],
                              stdout=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{check}: {done.stdout[-3000:]}")
        return json.loads(file.read_text())


def hostile_table(inputs, faults):
    lines = ["| what | number | exit 0 | exit 1 | exit 2 | other end | processor seconds |", "|---|---|---|---|---|---|---|"]
    for title, names, result in (("**hostile inputs**", INPUTS, inputs), ("**faults**", FAULTS, faults)):
        total = {}
        for ends in result["groups"].values():
            for end, count in ends.items():
                total[end] = total.get(end, 0) + count
        rows = [(title, total, f"{result['processor']:.0f}")]
        rows += [(names[group], ends, "") for group, ends in result["groups"].items()]
        for name, ends, seconds in rows:
            number = sum(ends.values())
            codes = [ends.get(f"exit {code}", 0) for code in (0, 1, 2)]
            lines.append(f"| {name} | {number:,} | {' | '.join(f'{count:,}' for count in codes)} | "
                         f"{number - sum(codes)} | {seconds} |")
    return lines


def mistakes_table(program, decks, limit):
    lines = ["| deck | MB | audit: s | MB | run, one cycle: s | MB | fix: s | MB |", "|---|---|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        mistakes.write(folder)
        for name in decks:
            path = pathlib.Path(folder) / f"{name}.k"
            cells = [MISTAKES[name], f"{path.stat().st_size / 1e6:.1f}"]
            for command in mistakes.COMMANDS:
                used = mistakes.run(str(program), command, str(path), limit)
                if used.code not in (0, 1, 2):
                    raise SystemExit(f"{name}, {command}: ended with {used.code}")
                cells += [f"{used.processor_seconds:.1f}", f"{used.memory:.0f}"]
            lines.append("| " + " | ".join(cells) + " |")
            print(lines[-1], flush=True)
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--small", action="store_true", help="a sample of the tests and one deck")
    parser.add_argument("--mistakes", action="store_true", help="only the table of decks with a mistake")
    options = parser.parse_args()
    if options.mistakes:
        table = mistakes_table(options.gapcheck, list(MISTAKES), 300)
        PAGE.write_text(place(PAGE.read_text(encoding="utf-8"), "mistakes", table), encoding="utf-8")
        return 0
    sample = ["--sample", "30"] if options.small else []
    inputs, faults = (summary(check, options.gapcheck, sample) for check in ("inputs", "faults"))
    text = place(PAGE.read_text(encoding="utf-8"), "hostile", hostile_table(inputs, faults))
    decks = ["point_shells"] if options.small else list(MISTAKES)
    PAGE.write_text(place(text, "mistakes", mistakes_table(options.gapcheck, decks, 300)), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
