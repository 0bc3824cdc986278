#!/usr/bin/env python3
"""Runs the decks of data/benchmarks with several elements and meshes and writes docs/theory/solver-benchmarks.md.

    scripts/solver_benchmarks.py GAPCHECK    the program; takes some minutes on an idle machine
"""
import argparse
import pathlib
import re
import resource
import subprocess
import tempfile

import make_benchmarks

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "theory" / "solver-benchmarks.md"
# Shells, solids, mesh; solids, mesh. Mesh 2 has half the edge lengths, and takes some minutes for each row.
JOINTS = [(2, 1, 1), (16, 1, 1), (2, -1, 1), (16, -1, 1)]
BARS = [(1, 1), (2, 1), (-1, 1)]
# Weld, ELFORM of bricks, load.
WELDS = [(weld, solid, load) for load in ("peel", "shear") for weld, solid in (("beam", 9), ("brick", 1), ("brick", 2))]


def run(program, deck, folder, options):
    """Runs a deck; its nodes over time, the last states of glstat, milliseconds of processor time per cycle."""
    path = folder / "deck.k"
    path.write_text(deck, encoding="ascii")
    start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([program, "run", path, "-o", folder / "out", "--jobs", "1", *options], capture_output=True,
                          text=True, check=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start
    cycles = int(re.search(r"cycle (\d+)", done.stdout)[1])
    text = (folder / "out" / "glstat").read_text(encoding="ascii")

    def last(label):
        return float(re.findall(rf"^ {re.escape(label)}[ .]*\.\s*(\S+)", text, re.MULTILINE)[-1])
    nodes = {}
    for line in (folder / "out" / "nodout").read_text(encoding="ascii").splitlines():
        # Columns of 12 behind ten of the id; the blocks of rotations have other headings.
        if "nodal point  x-disp" in line:
            kind = "moved"
        elif "nodal point  x-rot" in line:
            kind = "turned"
        elif re.match(r"^ *\d+ [ -]\d\.\d{5}E", line) and kind == "moved":
            values = [float(line[10 + 12 * i:22 + 12 * i]) for i in range(12)]
            nodes.setdefault(int(line[:10]), []).append(values)
    return {"nodes": nodes, "last": last, "milliseconds": 1000 * seconds / cycles}


def joint_row(program, folder, options, shell, solid, density):
    result = run(program, make_benchmarks.bolted_joint(density, shell, solid), folder, options)
    upper, lower = (result["nodes"][n] for n in sorted(result["nodes"]))
    short = lower[-1][2] - upper[-1][2]
    ratio = result["last"]("total energy / initial energy")
    hourglass = result["last"]("hourglass energy") / result["last"]("internal energy")
    return (f"| {shell} | {solid} | {density} | {short:.2f} | {100 * hourglass:.1f} % | "
            f"{result['last']('sliding interface energy'):.2f} | {ratio:.4f} | {result['milliseconds']:.2f} |")


def bar_row(program, folder, options, solid, density):
    result = run(program, make_benchmarks.taylor_bar(density, solid), folder, options)
    bottom, top, rim = (result["nodes"][n][-1] for n in ordered(result["nodes"]))
    return (f"| {solid} | {density} | {top[11] - bottom[11]:.2f} | {rim[9]:.2f} | "
            f"{result['last']('total energy / initial energy'):.4f} | {result['milliseconds']:.2f} |")


def weld_row(program, folder, options, weld, solid, load):
    result = run(program, make_benchmarks.spot_welded_sheets(weld, load, solid), folder, options)
    axis, strength = ("z", 1.5) if load == "peel" else ("x", 3.0)
    rcforc = (folder / "out" / "rcforc").read_text(encoding="ascii")
    greatest = max(abs(float(force)) for force in re.findall(rf"SURFA +1 .* {axis} +(\S+)", rcforc))
    failed = re.findall(r"failed at time +(\S+)", (folder / "out" / "messag").read_text(encoding="ascii"))
    return (f"| {load} | {weld} | {solid} | {greatest:.3f} | {strength:.3f} | {100 * (greatest / strength - 1):.2f} % | "
            f"{len(failed)} | {result['last']('total energy / initial energy'):.4f} | {result['milliseconds']:.2f} |")


def ordered(nodes):
    """Of the bar: the middle of its foot, of its top, and the rim of its foot."""
    first = {n: nodes[n][0] for n in nodes}
    rim = max(first, key=lambda n: first[n][9])
    top = max(first, key=lambda n: first[n][11])
    return [next(n for n in first if n not in (rim, top)), top, rim]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--small", action="store_true", help="a few cycles of one deck of each kind, to try the script")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    options = ["--cycles", "20"] if arguments.small else []
    joints, bars, welds = (JOINTS[:1], BARS[:1], WELDS[:1]) if arguments.small else (JOINTS, BARS, WELDS)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        joint_rows = "\n".join(joint_row(program, folder, options, *joint) for joint in joints)
        bar_rows = "\n".join(bar_row(program, folder, options, *bar) for bar in bars)
        weld_rows = "\n".join(weld_row(program, folder, options, *one) for one in welds)
    PAGE.write_text(TEXT.format(joints=joint_rows, bars=bar_rows, welds=weld_rows), encoding="utf-8")


TEXT = """# Benchmarks of the solver

`scripts/solver_benchmarks.py` runs the problems of `data/benchmarks` with several elements and meshes and writes this page; no
number is typed by hand, except those of the literature. Milliseconds per cycle are processor time of one thread; compare
them with each other, not with other machines.

## Bolted joint

`bolted_joint.k`: two plates of 6 mm between the heads of a bolt. The heads are shells of 6.4 mm, the shank is one spotweld beam
(ELFORM 9, `*MAT_SPOTWELD`) between their middles, and `*INITIAL_AXIAL_FORCE_BEAM` pulls it to 28.8 kN within 0.3 ms. The shank
gets shorter as the heads bend plastically and dent the plates.

| shells | solids | mesh | shortening in mm | hourglass share | sliding energy in J | energy ratio | ms per cycle |
|---:|---:|---:|---:|---:|---:|---:|---:|
{joints}

## Taylor bar

`taylor_bar.k`: a copper rod, 32.4 mm long, with a radius of 3.2 mm, hits a frictionless wall at 227 m/s (E = 117 GPa,
ν = 0.35, yield stress 400 MPa, hardening 100 MPa, 8930 kg/m³). After 80 µs published calculations have lengths of 21.3 to
21.7 mm and radii of the foot of 6.9 to 7.2 mm (Kamoulakos 1990, Zhu and Cescotto 1995, Camacho and Ortiz 1997, as commonly
quoted). The energy ratio leaves out the work of the bulk viscosity, as LS-DYNA's does.

| solids | mesh | length in mm | radius of the foot in mm | energy ratio | ms per cycle |
|---:|---:|---:|---:|---:|---:|
{bars}

## Spot-welded sheets

`spot_welded_sheets.k`: two sheets of 3 mm with three [welds](solver-beams.md#spotwelds) in a row, beams that
`*CONTACT_SPOTWELD` ties, or bricks that `*CONTACT_TIED_NODES_TO_SURFACE` ties. Planes of symmetry at both ends of the row make
the three alike. One sheet is clamped 15 mm behind the row; the other one is pulled up there (peel) or along the sheets at its
other end (shear), faster and faster, until the welds fail at NRR = 0.5 kN or NRS = 1 kN. The balance of the sheet says what the
three carry then: 1.5 or 3 kN. The greatest force is that of the tie between lower sheet and welds in rcforc, every 2 µs; the
force grows by 0.2 % (peel) or 0.15 % (shear) in that time.

| load | weld | ELFORM | greatest force in kN | closed form in kN | error | failed | energy ratio | ms per cycle |
|---|---|---:|---:|---:|---:|---:|---:|---:|
{welds}

## Elsewhere

| problem | where |
|---|---|
| rubber ball onto a wall (`rubber_ball.k`) | `rubber_ball_test.cpp` |
| Hertz: spheres and cylinders, penalty and mortar | [accuracy](solver-accuracy.md), `hertz_test.cpp` |
| press fit of rings (Lamé), INTERFERENCE and mortar | [mortar](solver-mortar.md) |
| sliding block, rods that hand over their momentum | [accuracy](solver-accuracy.md) |
| cantilevers, twisted beam | [shells](solver-full-shells.md), [solids](solver-solids.md), [beams](solver-beams.md) |
"""

if __name__ == "__main__":
    main()
