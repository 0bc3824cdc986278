#!/usr/bin/env python3
"""Runs other people's decks with the verification solver and writes docs/solver-runs.md with its pictures.

    scripts/solver_runs.py GAPCHECK DECKS            GAPCHECK: the program; DECKS: the folder with the decks
    scripts/solver_runs.py GAPCHECK DECKS --table    only the section of all decks, in two minutes
"""
import argparse
import base64
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

sys.dont_write_bytecode = True  # keeps the source tree clean

from chart import svg
import run_table
from state_energy import notes, ratios

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE, PICTURES = ROOT / "docs" / "solver-runs.md", ROOT / "docs" / "solver-runs"

# Roll forming comes without its parts: sections and materials have the numbers of the parts.
PARTS = "".join(f"*PART\npart {i}\n{i:10}{i:10}{i:10}\n" for i in range(1, 6))

# Name, deck, end time (None: the deck's own), keywords in front of it, arguments, viewing direction, interval of forces.
RUNS = [
    ("two_body_impact", "two_body_impact/main.k", None, "", [], (1, -2, 1), 1.5e-5),
    ("ball_plate", "ball_plate/ball_plate.k", None, "", [], (1, -2, 1), 0.02),
    ("car6", "car6/car6_crash.k", 0.02, "", [], (1, -2, 1), 2e-5),
    ("roll_forming", "roll_forming/model.k", 0.005, PARTS, ["--ignore-unsupported"], (1, -1, 2), 1e-5),
]

# With --small: DECKS is data/workshop.
SMALL = [("push_shell_shell", "push_shell_shell.k", None, "", [], (1, -2, 1), 0.005)]

# Reading results ----------------------------------------------------------------------------------------------------


def array(text, name):
    """A data array of a .vtu file, flat."""
    tag = re.search(rf'<DataArray ([^>]*Name="{name}"[^>]*)/>', text)[1]
    start = text.index('encoding="base64">\n_') + len('encoding="base64">\n_') + int(re.search(r'offset="(\d+)"', tag)[1])

    def decoded(first, count):
        """So many bytes, encoded by themselves or as the beginning of more."""
        return base64.b64decode(text[first:first + (count + 2) // 3 * 4])[:count]
    blocks = struct.unpack("<Q", decoded(start, 24)[:8])[0]
    sizes = struct.unpack(f"<{3 + blocks}Q", decoded(start, 8 * (3 + blocks)))[3:]
    data, raw = decoded(start + (8 * (3 + blocks) + 2) // 3 * 4, sum(sizes)), b""
    for size in sizes:
        raw += zlib.decompress(data[:size])
        data = data[size:]
    size, code = {"Float32": (4, "f"), "Float64": (8, "d"), "Int32": (4, "i"), "Int64": (8, "q"), "UInt8": (1, "B")}[
        re.search(r'type="(\w+)"', tag)[1]]
    return struct.unpack(f"<{len(raw) // size}{code}", raw)


def glstat(folder):
    """Columns over time: energy ratio, and the last state's energies."""
    text = (folder / "glstat").read_text(encoding="ascii")

    def column(label):
        return [float(v) for v in re.findall(rf"^ {re.escape(label)}\.*\s*(\S+)", text, re.MULTILINE)]
    return {label: column(label) for label in
            ("time.", "kinetic energy", "internal energy", "hourglass energy ", "sliding interface energy",
             "external work", "total energy.", "total energy / initial energy")}


def forces(folder):
    """Half the sum of the magnitudes of all nodal contact forces over time, from ncforc, which contains both sides."""
    sums = {}
    for block in (folder / "ncforc").read_text(encoding="ascii").split("\n forces (t=")[1:]:
        time = float(block.split(")")[0])
        rows = [line for line in block.splitlines()[4:] if line.strip()]
        total = sum(math.hypot(float(line[16:30]), float(line[30:44]), float(line[44:58])) / 2 for line in rows[::2])
        sums[time] = sums.get(time, 0) + total
    return sorted(sums.items())


# Picture ------------------------------------------------------------------------------------------------------------

HEX_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
TET_FACES = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3))


def outer_faces(text):
    """Polygons (positions of points) with their cell: shells, and faces of solids that no other solid has."""
    connectivity, offsets, types = (array(text, name) for name in ("connectivity", "offsets", "types"))
    faces, solids, start = [], {}, 0
    for cell, (end, kind) in enumerate(zip(offsets, types)):
        nodes = connectivity[start:end]
        start = end
        if kind in (5, 9):
            faces.append((nodes, cell))
        for corners in {12: HEX_FACES, 10: TET_FACES}.get(kind, ()):
            face = tuple(nodes[i] for i in corners)
            key = tuple(sorted(face))
            solids[key] = None if key in solids else (face, cell)
    return faces + [face for face in solids.values() if face]


def unit(v):
    length = math.sqrt(sum(c * c for c in v)) or 1.0
    return tuple(c / length for c in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def colour(share, shade):
    """Grey without plastic strain, over yellow to red."""
    low, high = ((190, 200, 210), (250, 210, 60)) if share < 0.5 else ((250, 210, 60), (200, 30, 30))
    t = 2 * share if share < 0.5 else 2 * share - 1
    return "#" + "".join(f"{int(shade * (a + t * (b - a))):02x}" for a, b in zip(low, high))


def picture(path, view, size=640):
    """The deformed mesh seen along `view`, coloured by plastic strain."""
    text = path.read_text(encoding="ascii")
    flat, strain = array(text, "Points"), array(text, "plastic_strain")
    points = [flat[i:i + 3] for i in range(0, len(flat), 3)]
    toward = unit(view)
    right = unit(cross((0, 0, 1), toward))
    up = cross(toward, right)
    flat_points = [(dot(p, right), dot(p, up), dot(p, toward)) for p in points]
    faces = sorted(outer_faces(text), key=lambda f: sum(flat_points[n][2] for n in f[0]) / len(f[0]))
    used = [flat_points[n] for nodes, _ in faces for n in nodes]
    low = [min(p[i] for p in used) for i in (0, 1)]
    high = [max(p[i] for p in used) for i in (0, 1)]
    scale = (size - 20) / max(high[0] - low[0], high[1] - low[1])
    height = int((high[1] - low[1]) * scale) + 20
    most = max(strain) if strain else 0
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size} {height}">',
           f'<rect width="{size}" height="{height}" fill="white"/>',
           '<g stroke="#333" stroke-width="0.3" stroke-linejoin="round">']
    for nodes, cell in faces:
        corners = [points[n] for n in nodes]
        a = tuple(q - p for p, q in zip(corners[0], corners[2]))
        b = tuple(q - p for p, q in zip(corners[1], corners[-1]))
        shade = 0.55 + 0.45 * abs(dot(unit(cross(a, b)), toward))
        place = " ".join(f"{10 + (flat_points[n][0] - low[0]) * scale:.1f},"
                         f"{height - 10 - (flat_points[n][1] - low[1]) * scale:.1f}" for n in nodes)
        out.append(f'<polygon points="{place}" fill="{colour(strain[cell] / most if most > 0 else 0, shade)}"/>')
    return "\n".join(out + ["</g></svg>"]) + "\n", most


# The page -----------------------------------------------------------------------------------------------------------


def run(program, decks, folder, name, deck, until, front, more, view, interval):
    path, results = folder / f"run_{name}.k", folder / name
    path.write_text(f"*KEYWORD\n{front}*DATABASE_NCFORC\n{interval}\n*INCLUDE\n{pathlib.Path(deck).name}\n*END\n",
                    encoding="ascii")
    command = [program, "run", path, "-o", results, "--vtu", "-I", decks / pathlib.Path(deck).parent, *more]
    command += ["--until", str(until)] if until else []
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{deck}: {done.stderr.strip()}")
    end = re.search(r"at time (\S+), cycle (\d+)", done.stdout)
    energies = glstat(results)
    drawn, strain = picture(sorted(results.glob("*.vtu"))[-1], view)
    (PICTURES / f"{name}.svg").write_text(drawn, encoding="ascii")
    curve = forces(results)
    (PICTURES / f"{name}_force.svg").write_text(svg({"contact force": curve}, "time", "sum of nodal contact forces"),
                                                encoding="ascii")
    ratio = energies["total energy / initial energy"]
    total = energies["total energy."][-1]
    row = (f"| {name} | {end[1]} | {int(end[2]):,} | {min(ratio):.4f} to {max(ratio):.4f} | "
           f"{ratios(done.stdout)[1]:.4f} | {notes(done.stdout)} | "
           f"{100 * energies['hourglass energy '][-1] / total:.1f} % | "
           f"{100 * energies['sliding interface energy'][-1] / total:.2f} % | "
           f"{max((f for _, f in curve), default=0):.4g} | {strain:.3g} |")
    return row, f"## {name}\n\n![deformed](solver-runs/{name}.svg)\n\n![force](solver-runs/{name}_force.svg)\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="GAPCHECK")
    parser.add_argument("decks", metavar="DECKS", type=pathlib.Path)
    parser.add_argument("--small", action="store_true", help="one short run of a deck of data/workshop, to test this script")
    parser.add_argument("--table", action="store_true", help="only rewrite the section of all decks")
    arguments = parser.parse_args()
    program, decks = pathlib.Path(arguments.program).resolve(), arguments.decks.resolve()
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        table = run_table.section(program, decks, folder, *((20, 3) if arguments.small else ()))
        if arguments.table:
            text = PAGE.read_text(encoding="utf-8")
            before, after = text.split(run_table.BEGIN)[0], text.split(run_table.END + "\n")[-1]
            PAGE.write_text(before + table + after, encoding="utf-8")
            return
        done = [run(program, decks, pathlib.Path(folder), *one) for one in (SMALL if arguments.small else RUNS)]
    PAGE.write_text("""# Runs of other people's decks

The verification solver on decks that were not written for it; `scripts/solver_runs.py` runs them and writes this page.
Units are those of the decks. The pictures show the last state, coloured by plastic strain (grey: none, red: the most).
Contact forces are the magnitudes summed over all nodes of both sides and halved, since a single-surface contact has no
resultant.

| deck | end time | cycles | energy ratio | by the state | who parts from the works | hourglass share | sliding share | largest contact force | plastic strain |
|---|---:|---:|---|---:|---|---:|---:|---:|---:|
""" + "\n".join(row for row, _ in done) + """

Shares are of the total energy at the end. "By the state" is the ratio at the end from the energy that elements and contacts
store ([energy of the state](theory/state-energy.md)). The deck of roll_forming comes without `*PART`: its parts were added with the
sections and materials of the same numbers, and mesh refinement (`*CONTROL_ADAPTIVE`) is left out. Its yield curve is
used as given: from 0 to 13 over a plastic strain of 1, where SIGY is 201. So the strip has hardly any strength and is
drawn out to a thread: it is not the intended forming. It ends at a tenth of the deck's time: the thinner the thread, the
smaller its elements and with them the time step. The nodes of rigid bodies and welds of car6 pass through its pole, and a
warning says so.

""" + "\n".join(text for _, text in done) + "\n" + table, encoding="utf-8")


if __name__ == "__main__":
    main()
