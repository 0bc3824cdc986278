#!/usr/bin/env python3
"""Runs the decks of data/benchmarks with several elements and meshes and writes docs/theory/solver-benchmarks.md and
the pages of docs/theory/benchmarks.

    scripts/solver_benchmarks.py GAPCHECK    the program; takes some minutes on an idle machine
"""
import argparse
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True  # keeps the source tree clean

import make_benchmarks
from benchmark_decks import page as benchmark_page
from benchmark_decks.problems import PROBLEMS
from benchmark_decks.result import Result

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE, PAGES = ROOT / "docs" / "theory" / "solver-benchmarks.md", ROOT / "docs" / "theory" / "benchmarks"
# Shells, solids, mesh.
JOINTS = [(2, 1, 1), (16, 1, 1), (2, -1, 1), (16, -1, 1)]
# Weld, ELFORM of bricks, load.
WELDS = [(weld, solid, load) for load in ("peel", "shear") for weld, solid in (("beam", 9), ("brick", 1), ("brick", 2))]


def joint_row(program, folder, options, shell, solid, density):
    result = Result(program, make_benchmarks.bolted_joint(density, shell, solid), folder, [*options, "--stats"])
    share = re.search(r"contact (\d+) % of the time", result.text)[1]
    upper, lower = (result.nodes[n] for n in sorted(result.nodes))
    short = lower[-1][2] - upper[-1][2]
    ratio = result.last("total energy / initial energy")
    hourglass = result.last("hourglass energy") / result.last("internal energy")
    return (f"| {shell} | {solid} | {density} | {short:.2f} | {100 * hourglass:.1f} % | "
            f"{result.last('sliding interface energy'):.2f} | {ratio:.4f} | {result.milliseconds:.2f} | {share} % |")


def weld_row(program, folder, options, weld, solid, load):
    result = Result(program, make_benchmarks.spot_welded_sheets(weld, load, solid), folder, options)
    axis, strength = ("z", 1.5) if load == "peel" else ("x", 3.0)
    rcforc = (folder / "out" / "rcforc").read_text(encoding="ascii")
    greatest = max(abs(float(force)) for force in re.findall(rf"SURFA +1 .* {axis} +(\S+)", rcforc))
    failed = re.findall(r"failed at time +(\S+)", (folder / "out" / "messag").read_text(encoding="ascii"))
    return (f"| {load} | {weld} | {solid} | {greatest:.3f} | {strength:.3f} | {100 * (greatest / strength - 1):.2f} % | "
            f"{len(failed)} | {result.last('total energy / initial energy'):.4f} | {result.milliseconds:.2f} |")


OLDER = {"bolted_joint": (JOINTS, joint_row), "spot_welded_sheets": (WELDS, weld_row)}


def write_older(program, folder, small, name):
    """A problem whose table has columns of its own."""
    cases, row = OLDER[name]
    options = ["--cycles", "20"] if small else []
    rows = [row(program, folder, options, *case) for case in (cases[:1] if small else cases)]
    (PAGES / f"{name}.md").write_text(PAGE_OF[name].format(rows="\n".join(rows)), encoding="utf-8")


def write_problem(program, folder, small, problem):
    options = ["--cycles", "20"] if small else []
    rows = []
    for variant in problem.variants[:1] if small else problem.variants:
        for level in problem.levels_of(variant)[:1 if small else None]:
            deck = problem.deck(level, variant)
            result = Result(program, deck, folder, options)
            values = [] if small else problem.measure(result, level, variant)
            elements = sum(line[:1] != "*" for kind in ("SOLID", "SHELL", "BEAM", "DISCRETE", "MASS")
                           for line in result.rows_of(f"*ELEMENT_{kind}"))
            rows.append(benchmark_page.Row(variant, level, elements, values, result.ratio(), result.seconds))
            if not small:
                print(rows[-1].text(), flush=True)
    drawn = "" if small else benchmark_page.picture(rows)
    if drawn:
        (PAGES / f"{problem.name}.svg").write_text(drawn, encoding="utf-8")
    (PAGES / f"{problem.name}.md").write_text(benchmark_page.page(problem, rows, bool(drawn)), encoding="utf-8")


def overview():
    """Rows of the pages that are there: title and errors of the finest meshes."""
    rows = []
    for name in [p.name for p in PROBLEMS] + list(OLDER):
        path = PAGES / f"{name}.md"
        if path.exists():
            text = path.read_text(encoding="utf-8")
            finest = re.search(r"^Finest meshes: (.*)\.$", text, re.MULTILINE)
            rows.append(f"| [{text.splitlines()[0][2:]}](benchmarks/{name}.md) | {finest[1] if finest else 'see there'} |")
    PAGE.write_text(TEXT.format(rows="\n".join(rows)), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--small", action="store_true", help="a few cycles of one deck of each kind, to try the script")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="only these problems; other pages are not rewritten")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    PAGES.mkdir(exist_ok=True)
    known = {p.name: p for p in PROBLEMS}
    with tempfile.TemporaryDirectory() as folder:
        for name in arguments.only or [*known, *OLDER]:
            if name in OLDER:
                write_older(program, pathlib.Path(folder), arguments.small, name)
            elif name in known:
                write_problem(program, pathlib.Path(folder), arguments.small, known[name])
            else:
                sys.exit(f"{name}: no such problem; known: {', '.join([*known, *OLDER])}")
    overview()


TEXT = """# Benchmarks of the solver

`scripts/solver_benchmarks.py GAPCHECK` runs the problems of `data/benchmarks` with several meshes, contacts and elements and
writes these pages; no number is typed by hand, except those of the literature. Each mesh halves the edges of the one before.
Errors are relative to the reference; s is processor time of one thread: compare them with each other, not with other machines.
`--only NAME` runs one problem.

| problem | errors of the finest meshes |
|---|---|
{rows}

## Elsewhere

| problem | where |
|---|---|
| rubber ball onto a wall (`rubber_ball.k`) | `rubber_ball_test.cpp` |
| coarse ball on a plate, penalty and mortar, exponent of the force | [accuracy](solver-accuracy.md), `hertz_test.cpp` |
| press fit by contacts of one way, meshes that do not match | [mortar](solver-mortar.md), `interference_test.cpp` |
| sliding block, rod on a wall | [accuracy](solver-accuracy.md) |
| cantilevers, twisted beam | [shells](solver-full-shells.md), [solids](solver-solids.md), [beams](solver-beams.md) |
"""

PAGE_OF = {
    "bolted_joint": """# Bolted joint

`bolted_joint.k`: two plates of 6 mm between the heads of a bolt. The heads are shells of 6.4 mm, the shank is one spotweld beam
(ELFORM 9, `*MAT_SPOTWELD`) between their middles, and `*INITIAL_AXIAL_FORCE_BEAM` pulls it to 28.8 kN within 0.3 ms. The shank
gets shorter as the heads bend plastically and dent the plates. The meshes of heads and plates match, so that up to four segments
are equally near to a node.

| shells | solids | mesh | shortening in mm | hourglass share | sliding energy in J | energy ratio | ms per cycle | of these contact |
|---:|---:|---:|---:|---:|---:|---:|---:|---:|
{rows}
""",
    "spot_welded_sheets": """# Spot-welded sheets

`spot_welded_sheets.k`: two sheets of 3 mm with three [welds](../solver-beams.md#spotwelds) in a row, beams that
`*CONTACT_SPOTWELD` ties, or bricks that `*CONTACT_TIED_NODES_TO_SURFACE` ties. Planes of symmetry at both ends of the row make
the three alike. One sheet is clamped 15 mm behind the row; the other one is pulled up there (peel) or along the sheets at its
other end (shear), faster and faster, until the welds fail at NRR = 0.5 kN or NRS = 1 kN. The balance of the sheet says what the
three carry then: 1.5 or 3 kN. The greatest force is that of the tie between lower sheet and welds in rcforc, every 2 µs; the
force grows by 0.2 % (peel) or 0.15 % (shear) in that time.

| load | weld | ELFORM | greatest force in kN | closed form in kN | error | failed | energy ratio | ms per cycle |
|---|---|---:|---:|---:|---:|---:|---:|---:|
{rows}
""",
}

if __name__ == "__main__":
    main()
