#!/usr/bin/env python3
"""Runs the decks of data/workshop/ with `PROGRAM run` and keeps messag, glstat, sleout, rcforc and nodout of each, with
one state in fifty, as data/workshop/curves/. tests/apps/workshop_curves_test.cpp compares later runs with them."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

WORKSHOP = pathlib.Path(__file__).resolve().parent.parent / "data" / "workshop"
FILES = ("messag", "glstat", "sleout", "rcforc", "nodout")
FEWER = 50  # as in the test


def coarse(text):
    """The deck with longer output intervals."""
    return re.sub(r"(\*DATABASE_(?:GLSTAT|SLEOUT|NCFORC|RCFORC|NODOUT)\n)\s*(\S+)",
                  lambda found: f"{found[1]}{float(found[2]) * FEWER:10.4g}", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="path of gapcheck")
    program = parser.parse_args().program
    shutil.rmtree(WORKSHOP / "curves", ignore_errors=True)
    for deck in sorted(WORKSHOP.glob("*.k")):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / deck.name
            copy.write_text(coarse(deck.read_text(encoding="ascii")), encoding="ascii")
            subprocess.run([program, "run", copy, "-o", pathlib.Path(folder) / "out", "--quiet"], check=True,
                           stdout=subprocess.DEVNULL)
            kept = WORKSHOP / "curves" / deck.stem
            kept.mkdir(parents=True)
            # Without an interval of the deck rcforc has a thousand states.
            few = "*DATABASE_RCFORC" in copy.read_text(encoding="ascii")
            for name in FILES if few else [name for name in FILES if name != "rcforc"]:
                if (pathlib.Path(folder) / "out" / name).exists():
                    shutil.copyfile(pathlib.Path(folder) / "out" / name, kept / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
