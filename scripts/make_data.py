#!/usr/bin/env python3
"""Writes the example decks of data/ and the findings that each must give, in closed form. Deterministic."""

import argparse
import pathlib

from data_decks import edges, plates, solids, thickness


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    root = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=root / "data")
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for make in plates.DECKS + edges.DECKS + thickness.DECKS + solids.DECKS:
        deck = make()
        assert deck.name == make.__name__
        deck.write(folder)


if __name__ == "__main__":
    main()
