#!/usr/bin/env python3
"""Times the reading of rows beside from_chars, strtod and memchr, and rewrites the table `reading` of
docs/benchmarks.md.

usage: measure_reading.py BUILD_FOLDER DOC [--rows N] [--runs N]
"""

import argparse
import os
import pathlib
import subprocess

from page import machine, section


def cases(arguments):
    """One dictionary per case of gapcheck_reading_bench, which compares all ways before it times them."""
    program = arguments.build / "tests/bench/gapcheck_reading_bench"
    out = subprocess.run([program, str(arguments.rows), str(arguments.runs), str(os.cpu_count())], check=True,
                         capture_output=True, text=True).stdout
    return [dict(pair.split("=", 1) for pair in line.split(";")) for line in out.splitlines()]


def table(arguments):
    rows = [machine() + f"; {arguments.rows:,} rows each, medians of {arguments.runs} runs, the ways in turn. "
            "MB of text per second; one thread where nothing else is said.", "",
            f"| rows | in pieces | in pieces, {os.cpu_count()} threads | whole | whole, fresh memory | page faults per MB "
            "| from_chars | strtod | memchr | in pieces / from_chars |", "|---|---|---|---|---|---|---|---|---|---|"]
    for case in cases(arguments):
        speed = {name: int(case[name]) for name in case if name != "name"}
        ratio = speed["pieces"] / speed["from_chars"]
        rows.append(f"| {case['name']} | {speed['pieces']:,} | {speed['pieces_threads']:,} | {speed['rows']:,} "
                    f"| {speed['rows_fresh']:,} | {speed.get('rows_fresh_faults', 0):,} | {speed['from_chars']:,} "
                    f"| {speed['strtod']:,} | {speed['memchr']:,} | {ratio:.2f} |")
    return rows


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "doc"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=300000)
    parser.add_argument("--runs", type=int, default=7)
    arguments = parser.parse_args()
    body = "\n".join(table(arguments))
    text = arguments.doc.read_text(encoding="utf-8")
    arguments.doc.write_text(section("reading", text, body), encoding="utf-8")
    print(body)


if __name__ == "__main__":
    main()
