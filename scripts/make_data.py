#!/usr/bin/env python3
"""Writes the example decks of data/ and the findings that each must give, in closed form. Deterministic."""

import sys

sys.dont_write_bytecode = True  # keeps the source tree clean

import generated
from data_decks import edges, plates, solids, thickness


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for make in plates.DECKS + edges.DECKS + thickness.DECKS + solids.DECKS:
        deck = make()
        assert deck.name == make.__name__
        deck.write(folder)


def foreign(path):
    return path.name == "README.md" or path.parts[0] in ("benchmarks", "fix", "tutorial", "workshop")


if __name__ == "__main__":
    sys.exit(generated.main(__doc__, "make_data.py", "data", write_all, foreign))
