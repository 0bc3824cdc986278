#!/usr/bin/env python3
"""Times audits by the Python package beside those of the program, in turn, and rewrites the table `times` of a page.

usage: python_speed.py BUILD_FOLDER WORK_FOLDER DOC [--plates N] [--runs N]

BUILD_FOLDER: with GAPCHECK_BENCH and GAPCHECK_PYTHON. The deck has 2 N² shells. Times are those of whole processes, the
start of Python and the import of NumPy included; the arrays of penetrations are added up, so that they are all looked at.
"""

import argparse
import os
import pathlib
import statistics
import subprocess

from page import machine, run_once, section

SCRIPT = "import sys, gapcheck; found = gapcheck.audit(sys.argv[1]).penetrations; print(len(found), found.depth.sum())"
EMPTY = "import sys, gapcheck"


def table(arguments):
    deck = arguments.work / f"plates_{arguments.plates}.k"
    subprocess.run([arguments.build / "tests/bench/gapcheck_make_plates", str(arguments.plates), deck], check=True)
    os.environ["PYTHONPATH"] = str(arguments.build / "python")
    commands = {"`gapcheck audit`": [arguments.build / "apps/gapcheck/gapcheck", "audit", "--fail-on", "never", deck],
                "`gapcheck.audit()`, whole process": ["/usr/bin/python3", "-c", SCRIPT, deck],
                "of it: start and import": ["/usr/bin/python3", "-c", EMPTY]}
    samples = {name: [] for name in commands}
    for command in commands.values():
        run_once(command)  # warms the file cache
    for _ in range(arguments.runs):
        for name, command in commands.items():
            samples[name].append(run_once(command))
            if samples[name][-1][2] != 0:
                raise SystemExit(f"{name} fails")
    deck.unlink()
    program = [wall for wall, _, _ in samples["`gapcheck audit`"]]
    load = os.getloadavg()[0]
    rows = [machine() + f"; {2 * arguments.plates**2:,} shells, medians of {arguments.runs} runs in turn, ratios of pairs; "
            f"load of the machine {load:.1f}.", "", "| | time | memory | ratio |", "|---|---|---|---|"]
    for name, runs in samples.items():
        ratio = statistics.median(run[0] / base for run, base in zip(runs, program))
        rows.append(f"| {name} | {statistics.median(run[0] for run in runs):.2f} s | {max(run[1] for run in runs):,.0f} MB "
                    f"| {ratio:.2f} |")
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("build", "work", "doc"):
        parser.add_argument(name, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--plates", type=int, default=700)
    parser.add_argument("--runs", type=int, default=7)
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    rows = table(arguments)
    arguments.doc.write_text(section("times", arguments.doc.read_text(encoding="utf-8"), "\n".join(rows)), encoding="utf-8")
    print("\n".join(rows))


if __name__ == "__main__":
    main()
