#!/usr/bin/env python3
"""Writes the decks of data/benchmarks: problems with a published or a closed-form answer. Deterministic."""
import math
import sys

sys.dont_write_bytecode = True  # keeps the source tree clean

import generated
from benchmark_decks.problems import PROBLEMS


class Mesh:
    """Nodes, joined where they coincide, and bricks."""

    def __init__(self):
        self.nodes, self.ids, self.bricks = [], {}, []

    def node(self, point):
        key = tuple(round(c, 9) for c in point)
        if key not in self.ids:
            self.nodes.append(point)
            self.ids[key] = len(self.nodes)
        return self.ids[key]

    def block(self, count, place):
        """count³ bricks; `place`: the point of (r, s, t) in [0, 1]³."""
        def corner(i, j, k):
            return self.node(place(i / count, j / count, k / count))
        for k in range(count):
            for j in range(count):
                for i in range(count):
                    self.bricks.append([corner(i + a, j + b, k + c) for c in (0, 1)
                                        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])

    def text(self, part=1):
        lines = ["*NODE"]
        lines += [f"{i:8d}{x:16.8g}{y:16.8g}{z:16.8g}" for i, (x, y, z) in enumerate(self.nodes, 1)]
        lines += ["*ELEMENT_SOLID"]
        lines += [f"{i:8d}{part:8d}" + "".join(f"{n:8d}" for n in brick) for i, brick in enumerate(self.bricks, 1)]
        return "\n".join(lines) + "\n"


def ball(radius, centre, count):
    """A cube of count³ bricks, half as wide as the ball, and six blocks between its faces and the surface."""
    half = 0.5 * radius / math.sqrt(3) * 1.2
    mesh = Mesh()

    def moved(p):
        return tuple(c + d for c, d in zip(p, centre))

    def bulged(p):
        """A point of the inner cube, its faces bulging outwards."""
        largest = max(abs(c) for c in p)
        if largest == 0:
            return p
        length = math.sqrt(sum(c * c for c in p))
        grown = 1 + 0.25 * (largest / half) * (largest * math.sqrt(3) / length - 1)
        return tuple(c * grown for c in p)

    mesh.block(count, lambda r, s, t: moved(bulged(tuple(half * (2 * q - 1) for q in (r, s, t)))))
    # The outward axis of each block and the axes across it, right-handed.
    for axis, sign in ((0, 1), (0, -1), (1, 1), (1, -1), (2, 1), (2, -1)):
        first, second = ((axis + 1) % 3, (axis + 2) % 3) if sign > 0 else ((axis + 2) % 3, (axis + 1) % 3)

        def place(r, s, t, axis=axis, sign=sign, first=first, second=second):
            on_cube = [0.0] * 3
            on_cube[axis], on_cube[first], on_cube[second] = sign * half, half * (2 * r - 1), half * (2 * s - 1)
            direction = [0.0] * 3
            direction[axis] = float(sign)
            direction[first] = math.tan(math.pi / 4 * (2 * r - 1))
            direction[second] = math.tan(math.pi / 4 * (2 * s - 1))
            length = math.sqrt(sum(c * c for c in direction))
            inner = bulged(tuple(on_cube))
            return moved(tuple((1 - t) * a + t * radius * b / length for a, b in zip(inner, direction)))

        mesh.block(count, place)
    return mesh


def rubber_ball():
    """A ball of Mooney–Rivlin rubber at 30 m/s onto a frictionless wall; mm, ms, kg, GPa."""
    mesh = ball(25.0, (0.0, 0.0, 25.5), 5)
    head = """*KEYWORD
*TITLE
rubber ball, 30 m/s, onto a frictionless wall
$ mm, ms, kg
*CONTROL_TERMINATION
     3.0
*DATABASE_GLSTAT
    0.01
*DATABASE_RWFORC
    0.01
*DATABASE_NODOUT
    0.01
*DATABASE_HISTORY_NODE
{history}
*PART
ball
         1         1         1
*SECTION_SOLID
         1         1
*MAT_MOONEY-RIVLIN_RUBBER
         1    1.1E-6     0.495    5.5E-4    1.4E-4

*RIGIDWALL_PLANAR
         0
       0.0       0.0       0.0       0.0       0.0       1.0       0.0
*INITIAL_VELOCITY_GENERATION
         1         2       0.0       0.0       0.0     -30.0

"""
    assert len(mesh.bricks) == 875
    poles = [min(range(len(mesh.nodes)), key=lambda n, at=at: math.dist(mesh.nodes[n], at)) + 1
             for at in ((0.0, 0.0, 0.5), (0.0, 0.0, 50.5), (25.0, 0.0, 25.5))]
    return head.replace("{history}", "".join(f"{n:10d}" for n in poles)) + mesh.text() + "*END\n"


def ring_point(radius, width, r, angle):
    """Between a circle (r = 0) and a square of half `width` (r = 1)."""
    c, s = math.cos(angle), math.sin(angle)
    on_square = width / max(abs(c), abs(s))
    return ((1 - r) * radius + r * on_square) * c, ((1 - r) * radius + r * on_square) * s


def disc_quads(mesh, radius, density, z):
    """A square of quads whose sides bulge, and four blocks around it; 4 `density` quads along each side."""
    side, rings, half = round(4 * density), round(2 * density), 0.5 * radius
    quads = []

    def block(columns, rows, place):
        def corner(i, j):
            return mesh.node(place(i / columns, j / rows) + (z,))
        for j in range(rows):
            for i in range(columns):
                quads.append([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)])

    block(side, side, lambda r, s: (half * (2 * r - 1), half * (2 * s - 1)))
    for quarter in range(4):
        c, s = round(math.cos(quarter * math.pi / 2)), round(math.sin(quarter * math.pi / 2))

        def place(r, t, c=c, s=s):
            angle = math.pi / 4 * (2 * r - 1)
            inner, outer = (half, half * (2 * r - 1)), (radius * math.cos(angle), radius * math.sin(angle))
            x, y = ((1 - t) * a + t * b for a, b in zip(inner, outer))
            return c * x - s * y, s * x + c * y

        block(side, rings, lambda r, t, place=place: place(1 - r, t))
    return quads


def plate_bricks(mesh, hole, head, width, z, density):
    """A square plate with a hole, finer below the bolt's head."""
    around, layers = 16 * density, 2 * density
    radii = [hole + (head - hole) * i / (3 * density) for i in range(3 * density + 1)]
    shares = [i / (3 * density) for i in range(1, 3 * density + 1)]

    def point(ring, step, layer):
        angle = 2 * math.pi * (step % around) / around + math.pi / 4
        height = z[0] + (z[1] - z[0]) * layer / layers
        if ring < len(radii):
            return radii[ring] * math.cos(angle), radii[ring] * math.sin(angle), height
        return ring_point(head, width, shares[ring - len(radii)], angle) + (height,)

    bricks = []
    for layer in range(layers):
        for ring in range(len(radii) + len(shares) - 1):
            for step in range(around):
                bricks.append([mesh.node(point(ring + a, step + b, layer + c))
                               for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])
    return bricks


def bolted_joint(density=1, shell=16, solid=-1):
    """Two plates between the heads of a bolt with 28.8 kN of preload; mm, ms, kg, kN. The heads are shells, the shank is
    one spotweld beam between their middles."""
    hole, head_radius, thick, width, plate = 6.0, 10.0, 6.4, 24.0, 6.0
    mesh, solids = Mesh(), []
    for part, z in ((1, (0.0, plate)), (2, (-plate, 0.0))):
        # A mesh of its own for each plate: they touch, and share no nodes.
        own = Mesh()
        solids += [(part, [n + len(mesh.nodes) for n in brick])
                   for brick in plate_bricks(own, hole, head_radius, width, z, density)]
        mesh.nodes += own.nodes
    quads, middles = [], []
    for part, z in ((3, plate + thick / 2), (4, -plate - thick / 2)):
        own = Mesh()
        quads += [(part, [n + len(mesh.nodes) for n in quad]) for quad in disc_quads(own, head_radius, density, z)]
        middles.append(own.node((0.0, 0.0, z)) + len(mesh.nodes))
        mesh.nodes += own.nodes
    aside = len(mesh.nodes) + 1
    mesh.nodes.append((50.0, 0.0, 0.0))
    lines = [f"""*KEYWORD
*TITLE
bolted joint, 28.8 kN of preload
$ mm, ms, kg, kN
*CONTROL_TERMINATION
     0.6
*CONTROL_ENERGY
         2         2         2         2
*CONTROL_CONTACT
$ SSTHK: the heads are thicker than their elements are wide
       0.1
                                                           1
*DATABASE_GLSTAT
    0.01
*DATABASE_RCFORC
    0.01
*DATABASE_SLEOUT
    0.01
*DATABASE_NODOUT
    0.01
*DATABASE_BINARY_D3PLOT
     0.1
*DATABASE_HISTORY_NODE
{middles[0]:10d}{middles[1]:10d}
*PART
upper plate
         1         1         1
*PART
lower plate
         2         1         1
*PART
head
         3         2         2
*PART
nut
         4         2         2
*PART
shank
         5         3         3
*SECTION_SOLID
         1{solid:10d}
*SECTION_SHELL
         2{shell:10d}                   5
{thick:10g}{thick:10g}{thick:10g}{thick:10g}
*SECTION_BEAM
         3         9       1.0       2.0       1.0
      10.0      10.0       0.0       0.0
*MAT_PIECEWISE_LINEAR_PLASTICITY
         1   7.85E-6     210.0       0.3      0.35       1.0


*MAT_PIECEWISE_LINEAR_PLASTICITY
         2   7.85E-6     210.0       0.3      0.40       1.0


*MAT_SPOTWELD
         3   7.85E-6     210.0       0.3      0.90       1.0

*INITIAL_AXIAL_FORCE_BEAM
         1         1
*SET_BEAM
         1
         1
*DEFINE_CURVE
         1
                 0.0                 0.0
                 0.3                28.8
                10.0                28.8
*CONTACT_AUTOMATIC_SINGLE_SURFACE
         1         0         2
       0.2

*SET_PART_LIST
         1
         1         2         3         4
*DAMPING_GLOBAL
         0       5.0
"""]
    lines += ["*NODE\n"] + [f"{i:8d}{x:16.8g}{y:16.8g}{z:16.8g}\n" for i, (x, y, z) in enumerate(mesh.nodes, 1)]
    number = iter(range(2, 10 ** 8))
    lines += ["*ELEMENT_SOLID\n"] + [f"{next(number):8d}{part:8d}" + "".join(f"{n:8d}" for n in brick) + "\n"
                                     for part, brick in solids]
    lines += ["*ELEMENT_SHELL\n"] + [f"{next(number):8d}{part:8d}" + "".join(f"{n:8d}" for n in quad) + "\n"
                                     for part, quad in quads]
    lines += ["*ELEMENT_BEAM\n", f"{1:8d}{5:8d}{middles[0]:8d}{middles[1]:8d}{aside:8d}\n", "*END\n"]
    return "".join(lines)


def spot_welded_sheets(weld="beam", load="peel", solid=2):
    """Two flat sheets, three welds in a row, planes of symmetry at both ends of the row; mm, ms, kg, kN. The lower sheet
    is clamped at x = 25, the upper one pulled up there (peel) or along the sheets at x = 0 (shear)."""
    width, length, thick, columns, rows = 60.0, 25.0, 3.0, 27, 11
    nodes, quads = [], []
    for part, z in ((1, 0.0), (2, thick)):
        first = len(nodes) + 1
        nodes += [(length * i / rows, width * j / columns, z) for j in range(columns + 1) for i in range(rows + 1)]
        quads += [(part, [first + i + a + (rows + 1) * (j + b) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])
                  for j in range(columns) for i in range(rows)]
    sheets, half = len(nodes), math.sqrt(math.pi) * 1.5
    welds, lower, upper = [], [], []
    for y in (10.0, 30.0, 50.0):
        at = ((10.0, y),) if weld == "beam" else tuple((10.0 + a * half, y + b * half)
                                                      for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
        first = len(nodes) + 1
        nodes += [corner + (z,) for z in (0.0, thick) for corner in at]
        lower += range(first, first + len(at))
        upper += range(first + len(at), first + 2 * len(at))
        welds.append(list(range(first, first + 2 * len(at))))
    pulled = [n for n in range(sheets // 2 + 1, sheets + 1) if nodes[n - 1][0] == (length if load == "peel" else 0.0)]
    sets = [lower, upper, pulled, [n for n in range(1, sheets // 2 + 1) if nodes[n - 1][0] == length],
            [n for n in range(1, sheets + 1) if nodes[n - 1][1] in (0.0, width)]]
    element, contact = ("BEAM", "SPOTWELD") if weld == "beam" else ("SOLID", "TIED_NODES_TO_SURFACE")
    section = ("         3         9       1.0       2.0       1.0\n       6.0       6.0" if weld == "beam"
               else f"         3{solid:10d}")
    direction, scale = (3, 0.1) if load == "peel" else (1, -0.005)
    lines = [f"""*KEYWORD
*TITLE
spot-welded sheets, {weld} welds, {load}
$ mm, ms, kg, kN
*CONTROL_TERMINATION
     3.0
*CONTROL_ENERGY
         2         2         2         2
*DATABASE_GLSTAT
    0.01
*DATABASE_RCFORC
   0.002
*DATABASE_NODOUT
    0.01
*DATABASE_HISTORY_NODE
{pulled[0]:10d}
*PART
lower sheet
         1         1         1
*PART
upper sheet
         2         1         1
*PART
welds
         3         3         3
*SECTION_SHELL
         1        16                   3
{thick:10g}{thick:10g}{thick:10g}{thick:10g}
*SECTION_{element}
{section}
*MAT_ELASTIC
         1   7.85E-6     210.0       0.3
$ Weak welds, so that the sheets stay elastic: NRR = 0.5 kN, NRS = NRT = 1 kN.
*MAT_SPOTWELD
         3   7.85E-6     210.0       0.3      0.35       1.0
                 0.5       1.0       1.0
*CONTROL_HOURGLASS
         5       0.1
*BOUNDARY_SPC_SET
         4         0         1         1         1         1         1         1
*BOUNDARY_SPC_SET
         5         0         0         1         0         1         0         1
*BOUNDARY_PRESCRIBED_MOTION_SET
         3{direction:10d}         0         1{scale:10g}
*DEFINE_CURVE
         1
                 0.0                 0.0
                10.0                10.0
*DAMPING_GLOBAL
         0       5.0
"""]
    for side in (1, 2):
        lines.append(f"*CONTACT_{contact}_ID\n{side:10d}\n{side:10d}{side:10d}         4         3\n       0.0\n\n")
    for number, members in enumerate(sets, 1):
        rows_of_eight = [members[i:i + 8] for i in range(0, len(members), 8)]
        lines.append(f"*SET_NODE_LIST\n{number:10d}\n"
                     + "".join("".join(f"{n:10d}" for n in row) + "\n" for row in rows_of_eight))
    lines += ["*NODE\n"] + [f"{i:8d}{x:16.8g}{y:16.8g}{z:16.8g}\n" for i, (x, y, z) in enumerate(nodes, 1)]
    lines += ["*ELEMENT_SHELL\n"] + [f"{i:8d}{part:8d}" + "".join(f"{n:8d}" for n in quad) + "\n"
                                     for i, (part, quad) in enumerate(quads, 1)]
    lines += [f"*ELEMENT_{element}\n"] + [f"{len(quads) + i:8d}{3:8d}" + "".join(f"{n:8d}" for n in corners) + "\n"
                                          for i, corners in enumerate(welds, 1)]
    return "".join(lines + ["*END\n"])


DECKS = {"rubber_ball.k": rubber_ball, "bolted_joint.k": bolted_joint, "spot_welded_sheets.k": spot_welded_sheets}


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in DECKS.items():
        (folder / name).write_text(make(), encoding="utf-8")
    for problem in PROBLEMS:
        level, variant = problem.small
        deck = problem.deck(level, problem.variants[variant])
        (folder / f"{problem.name}.k").write_text(deck, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(generated.main(__doc__, "make_benchmarks.py", "data/benchmarks", write_all))
