#!/usr/bin/env python3
"""Writes the tables and pictures of docs/theory/long-runs.md: the momentum that flush bars hand over, and the energy of free
bodies over ten million cycles.

    scripts/long_runs.py PROGRAM [--cycles N]

With ten million cycles it takes about twenty minutes.
"""
import argparse
import math
import pathlib
import re
import subprocess
import tempfile

from chart import svg
from state_energy import notes

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "theory" / "long-runs.md"
PICTURES = ROOT / "docs" / "theory" / "long-runs"


def run(program, deck, folder, *options):
    """Runs a deck in a folder of its own and returns what the program prints at the end."""
    folder.mkdir()
    path = folder / "deck.k"
    path.write_text("*KEYWORD\n" + deck + "*END\n", encoding="ascii")
    text = subprocess.run([program, "run", path, "-o", folder / "run", *options], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL).stdout
    if not re.search(r"^(Normal end|Ended)", text, re.MULTILINE):
        raise RuntimeError(f"{path} was not run")
    return text


def cubes(part, start, counts, side, shift=(0.0, 0.0, 0.0)):
    """A brick of i × j × k cubes; ids from 10000 · part on."""
    ni, nj, nk = counts
    first = 10000 * part

    def node(i, j, k):
        return first + i + (ni + 1) * (j + (nj + 1) * k)

    nodes = ["*NODE"]
    for k in range(nk + 1):
        for j in range(nj + 1):
            for i in range(ni + 1):
                x, y, z = (start[a] + shift[a] + side * (i, j, k)[a] for a in range(3))
                nodes.append(f"{node(i, j, k)},{x:.12g},{y:.12g},{z:.12g}")
    solids = ["*ELEMENT_SOLID"]
    for k in range(nk):
        for j in range(nj):
            for i in range(ni):
                corners = [node(i + a, j + b, k + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                solids.append(f"{first + len(solids)},{part}," + ",".join(map(str, corners)))
    return "\n".join(nodes + solids) + f"\n*PART\npart\n{part},1,1\n"


# Bars ---------------------------------------------------------------------------------------------------------------

YOUNG, DENSITY, SIDE, LENGTH, SPEED = 400.0, 4.0, 0.4, 10, 0.01


def bars(n, soft, single, shift, ihq=4):
    """Two bars of 10 × n × n cubes, flush or shifted by a share of a cube; the first one hits the second."""
    contact = "SINGLE_SURFACE\n0" if single else "SURFACE_TO_SURFACE\n1,2,3,3"
    return (cubes(1, (0, 0, 0), (LENGTH, n, n), SIDE)
            + cubes(2, (LENGTH * SIDE + 1e-6, 0, 0), (LENGTH, n, n), SIDE, (0, shift * SIDE, shift * SIDE))
            + f"*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,{DENSITY},{YOUNG},0.\n"
            f"*INITIAL_VELOCITY_GENERATION\n1,2,0.,{SPEED},0.,0.\n0.,0.,0.,0.,0.,1.\n"
            f"*CONTACT_AUTOMATIC_{contact}\n0.\n1.,1.\n{soft}\n"
            f"*CONTROL_TERMINATION\n2.\n*DATABASE_MATSUM\n2.\n*CONTROL_HOURGLASS\n{ihq},0.1\n")


def momentum(folder):
    """x momentum of part 2 in the last state of matsum."""
    text = (folder / "run" / "matsum").read_text(encoding="ascii")
    return float(re.findall(r"mat\.#= *2 .*?x-mom= *(\S+)", text, re.DOTALL)[-1])


def rods(ratio):
    """The same in one dimension: rods of ten elements and a spring, `ratio` times as stiff as a rod, between their ends.
    Share of the momentum that the second one has at the end; without viscosity."""
    n = LENGTH
    mass = ([0.5] + [1.0] * (n - 1) + [0.5]) * 2
    x, v, spring, step = [0.0] * len(mass), [1.0] * (n + 1) + [0.0] * (n + 1), ratio / n, 0.05
    for _ in range(1000):
        force = [0.0] * len(mass)
        for start in (0, n + 1):
            for i in range(start, start + n):
                pull = x[i + 1] - x[i]
                force[i] += pull
                force[i + 1] -= pull
        push = spring * max(0.0, x[n] - x[n + 1])
        force[n] -= push
        force[n + 1] += push
        for i, m in enumerate(mass):
            v[i] += step * force[i] / m
            x[i] += step * v[i]
    return sum(m * u for m, u in zip(mass[n + 1:], v[n + 1:])) / n


def spring_ratio(n):
    """Springs of SOFT = 0 over the stiffness of a bar: 2 (n + 1)² nodes with 0.1 K A² / V each, K = E / 3."""
    return 2 * (n + 1)**2 * 0.1 * YOUNG / 3 * SIDE / (YOUNG * (n * SIDE)**2 / (LENGTH * SIDE))


def bar_table(program, folder, small):
    sizes = range(1, 3 if small else 5)
    curves, rows = {}, []

    def row(soft, contact, shift, shares):
        rows.append(f"| {soft} | {contact} | {shift:g} | " + " | ".join(f"{share:.3f}" for share in shares) + " |")

    def shares(*setting):
        found = []
        for n in sizes:
            place = folder / "_".join(map(str, ("bars", n, *setting)))
            run(program, bars(n, *setting), place)
            found.append(momentum(place) / (SPEED * DENSITY * LENGTH * n**2 * SIDE**3))
        return found

    for soft in (0,) if small else (0, 1, 2):
        for single in (False, True):
            for shift in (0.0, 0.1, 0.5):
                found = shares(soft, single, shift)
                row(soft, "single surface" if single else "by parts", shift, found)
                if not single and not shift:
                    curves[f"SOFT = {soft}"] = list(zip(sizes, found))
    row(0, "by parts, IHQ 1", 0.1, shares(0, False, 0.1, 1))
    closed = [rods(spring_ratio(n)) for n in sizes]
    row(0, "rods and a spring", 0, closed)
    curves["rods and a spring"] = list(zip(sizes, closed))
    picture = svg(curves, "cubes over the width of the bar", "momentum handed over", bands=((0.99, 1.0, ""),))
    (PICTURES / "bars.svg").write_text(picture, encoding="ascii")
    head = "| SOFT | contact | shift [cubes] | " + " | ".join(f"n = {n}" for n in sizes) + " |"
    return "\n".join([head, "|---:|---|---:|" + "---:|" * len(sizes), *rows]) + "\n"


# Free bodies --------------------------------------------------------------------------------------------------------

STEEL = "*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n"
SPIN = "*INITIAL_VELOCITY_GENERATION\n1,2,10.,0.,0.,0.\n0.,0.,0.,1.,2.,3.\n"


def block(n):
    return cubes(1, (-2.5 * n,) * 3, (n, n, n), 5) + "*SECTION_SOLID\n1,1\n" + STEEL


def plate(triangles, skew):
    """2 × 2 quads, or twice as many triangles, of side 5 and thickness 1, whose nodes are moved by up to `skew`."""
    nodes = ["*NODE"]
    for j in range(3):
        for i in range(3):
            x = 5 * i - 5 + skew / 2 * ((7 * i + 3 * j) % 5 - 2)
            y = 5 * j - 5 + skew / 2 * ((3 * i + 11 * j) % 5 - 2)
            nodes.append(f"{1 + i + 3 * j},{x},{y},0.")
    shells = ["*ELEMENT_SHELL"]
    for j in range(2):
        for i in range(2):
            a = 1 + i + 3 * j
            b, c, d = a + 1, a + 4, a + 3
            for corners in ((a, b, c, c), (c, d, a, a)) if triangles else ((a, b, c, d),):
                shells.append(f"{len(shells)},1," + ",".join(map(str, corners)))
    return ("\n".join(nodes + shells) + "\n*PART\nplate\n1,1,1\n*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n" + STEEL)


def shaken():
    """Velocities of 1 mm/ms in the plane of a plate and a tenth of it out of the plane; no two nodes share one."""
    lines = ["*INITIAL_VELOCITY_NODE"]
    for node in range(1, 10):
        lines.append(f"{node},{math.sin(12.9898 * node):.4f},{math.sin(78.233 * node):.4f},"
                     f"{math.sin(37.719 * node) / 10:.4f}")
    return "\n".join(lines) + "\n"


def breathes():
    """A lone brick whose corners move away from its centre; without viscosity."""
    lines = ["*INITIAL_VELOCITY_NODE"]
    for corner in range(8):
        lines.append(f"{10000 + corner}," + ",".join("1." if corner >> axis & 1 else "-1." for axis in range(3)))
    return "\n".join(lines) + "\n*CONTROL_BULK_VISCOSITY\n1e-30,1e-30\n"


def bodies():
    """Decks by name, those that turn and those that vibrate."""
    turning = {"bricks, IHQ 4": block(2) + SPIN + hourglass(4), "skewed quads, IHQ 4": plate(False, 1) + SPIN + hourglass(4),
               "triangles": plate(True, 1) + SPIN}
    turning.update({f"bricks, IHQ {ihq}": block(2) + SPIN + hourglass(ihq) for ihq in (1, 2, 3, 5)})
    vibrating = {"square quads, IHQ 4": plate(False, 0) + shaken() + hourglass(4),
                 "skewed quads, IHQ 4": plate(False, 1) + shaken() + hourglass(4),
                 "triangles": plate(True, 1) + shaken(), "one brick": block(1) + breathes()}
    return turning, vibrating


def hourglass(ihq):
    return f"*CONTROL_HOURGLASS\n{ihq},0.1\n"


def kinetic_energy(folder, cycles, windows=100):
    """The largest kinetic energy of each of `windows` parts of a run over the initial one: [(million cycles, share)]."""
    text = (folder / "run" / "glstat").read_text(encoding="ascii")
    energies = [float(value) for value in re.findall(r"^ kinetic energy\.+\s*(\S+)", text, re.MULTILINE)]
    size = max(1, len(energies) // windows)
    return [((i + size / 2) / len(energies) * cycles / 1e6, max(energies[i:i + size]) / energies[0])
            for i in range(0, len(energies), size)]


def body_table(program, folder, cycles, most):
    rows = []
    for motion, decks in zip(("turns", "vibrates"), bodies()):
        curves = {}
        for number, (name, deck) in enumerate(list(decks.items())[:most]):
            place = folder / f"{motion}_{number}"
            text = run(program, f"{deck}*CONTROL_TERMINATION\n1e9\n*DATABASE_GLSTAT\n{3e-8 * cycles:g}\n", place,
                       "--cycles", str(cycles))
            early = re.search(r"^Ended with an error at time \S+, cycle (\d+)", text, re.MULTILINE)
            curve = kinetic_energy(place, int(early[1]) if early else cycles)
            rows.append(f"| {name} | {motion} | {min(share for _, share in curve):.5f} | "
                        f"{max(share for _, share in curve):.5f} | "
                        f"{f'ends with an error in cycle {int(early[1]):,}' if early else notes(text) or 'nobody'} |")
            if len(curves) < 4:
                curves[name] = curve
        picture = svg(curves, "million cycles", "largest kinetic energy over the initial one")
        (PICTURES / f"{motion}.svg").write_text(picture, encoding="ascii")
    head = ["| body | motion | least | greatest | end, and who differs |", "|---|---|---:|---:|---|"]
    return "\n".join(head + rows) + "\n"


def replace(text, name, table):
    first, last = (text.index(f"<!-- {name}: {edge} -->") for edge in ("begin", "end"))
    first = text.index("\n", first) + 1
    return text[:first] + table + text[last:]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--cycles", type=int, default=10_000_000, help="of the free bodies")
    parser.add_argument("--only", choices=("bars", "bodies"))
    parser.add_argument("--small", action="store_true", help="the smallest bars, two bodies, few cycles: to test this script")
    given = parser.parse_args()
    program, cycles = given.program.resolve(), 2000 if given.small else given.cycles
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        if given.only != "bodies":
            table = bar_table(program, pathlib.Path(folder), given.small)
            PAGE.write_text(replace(PAGE.read_text(encoding="utf-8"), "bars", table), encoding="utf-8")
        if given.only != "bars":
            table = body_table(program, pathlib.Path(folder), cycles, 1 if given.small else None)
            PAGE.write_text(replace(PAGE.read_text(encoding="utf-8"), "bodies", table), encoding="utf-8")


if __name__ == "__main__":
    main()
