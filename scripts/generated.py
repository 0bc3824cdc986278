"""Shared by scripts that generate files: the command line, and --check, which compares without writing."""

import argparse
import filecmp
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def stale_files(folder, write_all, foreign):
    """Files of the folder that differ from what would be written, or should not exist. `foreign(path)`: not ours."""
    with tempfile.TemporaryDirectory() as fresh:
        fresh = pathlib.Path(fresh)
        write_all(fresh)
        names = {path.relative_to(top) for top in (folder, fresh) for path in top.rglob("*") if path.is_file()}
        return sorted(str(name) for name in names if not foreign(name)
                      and not ((folder / name).exists() and (fresh / name).exists()
                               and filecmp.cmp(folder / name, fresh / name, shallow=False)))


def main(description, script, folder, write_all, foreign=lambda path: False):
    """The main program of a script. `folder`: below the project's root; write_all(folder) writes all its files."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=ROOT / folder)
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if a file is not as generated")
    arguments = parser.parse_args()
    if not arguments.check:
        write_all(arguments.folder)
        return 0
    stale = stale_files(arguments.folder, write_all, foreign)
    for name in stale:
        print(f"{name}: not as scripts/{script} writes it; run the script", file=sys.stderr)
    return 1 if stale else 0
