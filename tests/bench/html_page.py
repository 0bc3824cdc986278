#!/usr/bin/env python3
"""Measures the pages of --html: how long they take to write, their size, and how long Chromium takes to open them.
Rewrites the table of docs/html.md.

usage: html_page.py GAPCHECK MAKE_PLATES WORK_FOLDER DOC [--runs N] [--sizes 100,300,700]
"""

import argparse
import pathlib
import statistics
import subprocess
import sys

from page import machine, run_once, section

sys.path.append(str(pathlib.Path(__file__).parents[1] / "apps"))
from chromium import Browser, program  # noqa: E402


def opened(page, runs):
    """Median seconds from the request to the first picture, each time in a new browser."""
    seconds = []
    for _ in range(runs):
        with Browser() as browser:
            seconds.append(browser.open(page))
            if browser.errors or not browser.value("document.querySelector('#canvas')?.dataset.camera"):
                raise SystemExit(f"{page}: not drawn; {browser.errors}")
    return statistics.median(seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("gapcheck", "make_plates", "work", "doc"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--sizes", type=lambda text: [int(n) for n in text.split(",")], default=[100, 300, 700])
    arguments = parser.parse_args()
    if program() is None:
        raise SystemExit("Chromium is not installed")
    arguments.work.mkdir(parents=True, exist_ok=True)
    rows = ["| shells | audit | audit with --html | page | opens in |", "|---|---|---|---|---|"]
    for n in arguments.sizes:
        deck, page = arguments.work / f"plates_{n}.k", arguments.work / f"plates_{n}.html"
        subprocess.run([arguments.make_plates, str(n), deck], check=True)
        plain = [str(arguments.gapcheck), "audit", "--fail-on", "never", str(deck)]
        with_page = plain + ["--html", str(page)]
        run_once(plain)  # warms the file cache
        pairs = [(run_once(plain), run_once(with_page)) for _ in range(arguments.runs)]
        if any(run[2] != 0 for pair in pairs for run in pair):
            raise SystemExit(f"{deck}: the audit has failed")
        audit, written = (statistics.median(pair[i][0] for pair in pairs) for i in (0, 1))
        rows.append(f"| {2 * n * n:,} | {audit:.2f} s | {written:.2f} s | {page.stat().st_size / 1e6:.1f} MB "
                    f"| {opened(page, arguments.runs):.2f} s |")
        print(rows[-1], flush=True)
        deck.unlink()
        page.unlink()
    head = f"{machine()}; medians of {arguments.runs} runs; WebGL drawn by the processor, without a graphics card."
    arguments.doc.write_text(section("pages", arguments.doc.read_text(), "\n".join([head, "", *rows])))


if __name__ == "__main__":
    main()
