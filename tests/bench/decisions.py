#!/usr/bin/env python3
"""Times certified decisions beside plain doubles and rewrites the table of docs/decision-speed.md.

usage: decisions.py BUILD_FOLDER WORK_FOLDER DOC [--rounds N] [--count PAIRS_PER_FAMILY] [deck...]
"""

import argparse
import pathlib
import subprocess

from page import machine, section


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "work", "doc"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("decks", nargs="*")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--count", type=int, default=20000)
    arguments = parser.parse_intermixed_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    plates = arguments.work / "plates_100.k"
    subprocess.run([arguments.build / "tests/bench/gapcheck_make_plates", "100", plates], check=True)
    out = subprocess.run([arguments.build / "tests/bench/gapcheck_decide_bench", "--rounds", str(arguments.rounds),
                          "--count", str(arguments.count), plates, *arguments.decks],
                         check=True, stdout=subprocess.PIPE, text=True).stdout
    print(out)
    caption = f"{machine()}; medians of {arguments.rounds} rounds, in each of which all ways take their turn."
    text = arguments.doc.read_text(encoding="utf-8")
    arguments.doc.write_text(section("decisions", text, f"{caption}\n\n{out.strip()}"), encoding="utf-8")


if __name__ == "__main__":
    main()
