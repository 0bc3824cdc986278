#!/usr/bin/env python3
"""Writes the table of docs/theory/impact-energy.md: what shell plates leave in the contact after they have hit each other.

    scripts/impact_energy.py BUILD/tests/solver/gapcheck_test_solver

The tests All/PlateImpact.* record mean, least and greatest over eight phases, and the cycles of an impact.
"""
import argparse
import json
import pathlib
import re
import subprocess
import tempfile

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "theory" / "impact-energy.md"
BEGIN, END = "<!-- impacts: begin -->\n", "<!-- impacts: end -->"
NAME = re.compile(r"impact_(\w+?)_([A-Z_]+)_soft_(\d)_tssfac_([\d.]+)_start_(\d)(\d)$")
STARTS = {"00": "moved (SNLOG 0)", "10": "forced (SNLOG 1)", "01": "IGNORE 1", "02": "IGNORE 2"}
TYPES = {"SINGLE_SURFACE": "13", "SURFACE_TO_SURFACE": "a3", "NODES_TO_SURFACE": "a5", "GENERAL": "26"}


def measured(program, chosen):
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        subprocess.run([program, f"--gtest_filter={chosen}", f"--gtest_output=json:{file.name}"], check=True,
                       stdout=subprocess.DEVNULL)
        tests = json.load(open(file.name))["testsuites"]
    for suite in tests:
        for case in suite["testsuite"]:
            for key, value in case.items():
                if match := NAME.match(key):
                    yield match.groups(), tuple(float(number) for number in value.split())


def percent(share):
    return f"{round(100 * share, 1) + 0.0:.1f} %"  # no "-0.0"


def table(program, chosen):
    rows = {}
    for (shape, kind, soft, tssfac, *start), numbers in measured(program, chosen):
        rows.setdefault((shape, TYPES[kind], soft, tssfac), {})["".join(start)] = numbers
    lines = ["| impact | type | SOFT | TSSFAC | mean | least | greatest | cycles | the same for |",
             "|---|---|---:|---:|---:|---:|---:|---:|---|"]
    for (shape, kind, soft, tssfac), starts in rows.items():
        while starts:
            numbers = next(iter(starts.values()))
            same = [start for start, others in starts.items() if others == numbers]
            names = "all starts" if len(same) == len(STARTS) else ", ".join(STARTS[start] for start in same)
            mean, least, greatest, cycles = numbers
            lines.append(f"| {shape} | {kind} | {soft} | {tssfac} | {percent(mean)} | {percent(least)} | "
                         f"{percent(greatest)} | {cycles:.0f} | {names} |")
            for start in same:
                del starts[start]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--small", action="store_true", help="one shape of plates only")
    given = parser.parse_args()
    chosen = "All/PlateImpact.*/" + ("flat" if given.small else "*")
    text = PAGE.read_text()
    first, last = text.index(BEGIN) + len(BEGIN), text.index(END)
    PAGE.write_text(text[:first] + table(given.program, chosen) + text[last:])


if __name__ == "__main__":
    main()
