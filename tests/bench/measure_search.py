#!/usr/bin/env python3
"""Times the searches for candidates on all scenes and rewrites their table in docs/benchmarks.md.

usage: measure_search.py BUILD_FOLDER DOC [--shells 2000,20000,200000] [--rounds N]
"""

import argparse
import os
import pathlib
import subprocess

from page import machine, section


def rows_of(program, shells, rounds, jobs):
    out = subprocess.run([program, str(shells), str(rounds), str(jobs)], check=True, capture_output=True, text=True).stdout
    rows = []
    for line in out.splitlines():
        name, count, searches, pairs, grid, sweep, tree, chosen, kinds, ratio = line.split(";")
        times = " | ".join(f"{float(t) * 1e3:.2f} ms" for t in (grid, sweep, tree, chosen))
        rows.append((float(ratio), f"| {name} | {int(count):,} | {jobs} | {int(searches)} | {int(pairs):,} | {times} "
                                   f"| {kinds} | {ratio} |"))
        print(rows[-1][1], flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("doc", type=pathlib.Path)
    parser.add_argument("--shells", type=lambda text: [int(n) for n in text.split(",")], default=[2000, 20000, 200000])
    parser.add_argument("--rounds", type=int, default=7)
    arguments = parser.parse_args()
    program = arguments.build / "tests/bench/gapcheck_search_bench"
    rows = []
    for jobs in sorted({1, os.cpu_count()}):
        for shells in arguments.shells:
            rows += rows_of(program, shells, arguments.rounds, jobs)
    table = [f"{machine()}; medians of {arguments.rounds} rounds, the searches in turn.", "",
             "| scene | shells | threads | searches | pairs | bucket grid | sorted sweep | box tree | chosen | it took | ratio |",
             "|---|---|---|---|---|---|---|---|---|---|---|", *[text for _, text in rows], "",
             f"Largest ratio: {max(ratio for ratio, _ in rows):.2f}."]
    text = arguments.doc.read_text(encoding="utf-8")
    arguments.doc.write_text(section("search", text, "\n".join(table)), encoding="utf-8")


if __name__ == "__main__":
    main()
