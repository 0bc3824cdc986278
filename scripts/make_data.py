#!/usr/bin/env python3
"""Writes the example decks of data/ and the findings that each must give, in closed form. Deterministic."""

import argparse
import filecmp
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True  # keeps the source tree clean

from data_decks import edges, plates, solids, thickness


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for make in plates.DECKS + edges.DECKS + thickness.DECKS + solids.DECKS:
        deck = make()
        assert deck.name == make.__name__
        deck.write(folder)


def stale_files(folder):
    """Files of the folder that differ from what would be written, or should not be there."""
    with tempfile.TemporaryDirectory() as fresh:
        fresh = pathlib.Path(fresh)
        write_all(fresh)
        names = {path.relative_to(top) for top in (folder, fresh) for path in top.rglob("*") if path.is_file()}
        return sorted(str(name) for name in names - {pathlib.Path("README.md")}
                      if name.parts[0] != "workshop" and not ((folder / name).exists() and (fresh / name).exists()
                              and filecmp.cmp(folder / name, fresh / name, shallow=False)))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    root = pathlib.Path(__file__).resolve().parent.parent
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=root / "data")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if a file is not as generated")
    arguments = parser.parse_args()
    if not arguments.check:
        write_all(arguments.folder)
        return 0
    stale = stale_files(arguments.folder)
    for name in stale:
        print(f"{name}: not as scripts/make_data.py writes it; run the script", file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
