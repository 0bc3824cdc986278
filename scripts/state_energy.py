#!/usr/bin/env python3
"""Writes the table of docs/theory/state-energy.md: the energy ratio of each deck of data/workshop, by work and by state.

    scripts/state_energy.py BUILD/apps/gapcheck/gapcheck
"""
import argparse
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "theory" / "state-energy.md"
BEGIN, END = "<!-- decks: begin -->\n", "<!-- decks: end -->"
FAULT = re.compile(r"^  (.+?) (created|lost) (\S+), (\S+) % of the largest energy", re.MULTILINE)
UNKNOWN = re.compile(r"^  (.+?) has no energy of its state", re.MULTILINE)


def ratios(text):
    """By the works and by the state, from what a run prints at its end."""
    return tuple(float(re.search(rf"^  {label} +(\S+)$", text, re.MULTILINE)[1])
                 for label in ("energy ratio", "by the state"))


def notes(text):
    """Who parts from the works, and who is not covered."""
    found = [f"{name} {did} {share} %" for name, did, _, share in FAULT.findall(text)]
    return ", ".join(found + [f"{name} not covered" for name in UNKNOWN.findall(text)])


def row(program, deck):
    with tempfile.TemporaryDirectory() as folder:
        text = subprocess.run([program, "run", deck, "-o", folder], check=True, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL).stdout
    works, state = ratios(text)
    return f"| {deck.stem} | {works:.5g} | {state:.5g} | {notes(text)} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--small", action="store_true", help="one deck only")
    given = parser.parse_args()
    decks = sorted((ROOT / "data" / "workshop").glob("*.k"))
    lines = ["| deck | by the works | by the state | who parts from the works by more than 1 % |", "|---|---:|---:|---|"]
    lines += [row(given.program.resolve(), deck) for deck in (decks[:1] if given.small else decks)]
    text = PAGE.read_text()
    first, last = text.index(BEGIN) + len(BEGIN), text.index(END)
    PAGE.write_text(text[:first] + "\n".join(lines) + "\n" + text[last:])


if __name__ == "__main__":
    main()
