"""Audits each deck of data/benchmarks and runs a few cycles of it.

    check_benchmarks.py GAPCHECK ROOT

No deck may have an error for the audit or be refused by the run, and after five cycles nodes must have moved and the
energies must balance. Exit code 1 if one fails.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

CYCLES = 5


def call(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def problems_of(program, deck, folder):
    audit = call(program, "audit", deck)
    if audit.returncode != 0:
        yield f"the audit finds errors or ends early: {audit.stdout[-500:]}{audit.stderr[-500:]}"
    done = call(program, "run", deck, "-o", folder, "--cycles", str(CYCLES), "--jobs", "1", "--force")
    if done.returncode != 0:
        yield f"the run is refused: {done.stderr[-1000:]}"
        return
    if not re.search(rf"cycle {CYCLES}\b", done.stdout):
        yield f"the run does not reach cycle {CYCLES}: {done.stdout[:300]}"
    glstat = (folder / "glstat").read_text(encoding="ascii")
    energies = [float(v) for v in re.findall(r"^ (?:kinetic energy|external work)\.* +(\S+)", glstat, re.MULTILINE)]
    if not any(energies):
        yield "nothing moves and no load works within five cycles"
    # Those that begin with energy keep it, but for the work of the bulk viscosity.
    ratios = [float(v) for v in re.findall(r"^ total energy / initial energy\.* +(\S+)", glstat, re.MULTILINE)]
    first = re.search(r"^ kinetic energy\.* +(\S+)", glstat, re.MULTILINE)
    if float(first[1]) > 0 and abs(ratios[-1] - 1) > 0.05:
        yield f"the energy ratio is {ratios[-1]}"


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    decks = sorted((root / "data/benchmarks").glob("*.k"))
    failed = 0 if decks else 1
    with tempfile.TemporaryDirectory() as folder:
        for deck in decks:
            for problem in problems_of(program, deck, pathlib.Path(folder)):
                print(f"{deck.name}: {problem}", file=sys.stderr)
                failed = 1
    print(f"{len(decks)} decks")
    return failed


if __name__ == "__main__":
    sys.exit(main())
