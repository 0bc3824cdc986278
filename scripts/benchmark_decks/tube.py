"""A round tube that is crushed along its axis and folds onto itself."""
import math

from .mesh import Mesh, curve, even, fields, history, node_set, part, start
from .problem import Problem, Value

DIAMETER, THICKNESS, LENGTH, YIELD = 50.0, 1.5, 60.0, 0.25  # mm, ms, kg, kN
SPEED, RISE, WAY = 10.0, 0.2, 36.0
HALF_FOLD = math.sqrt(math.pi * DIAMETER * THICKNESS / (2 * math.sqrt(3)))  # Alexander 1960
IMPERFECTION = 0.05 * THICKNESS


def rows_of(level):
    return 24 * 2 ** level


def angle_of(level):
    """Of the sector, one shell wide: squares."""
    return 2 * LENGTH / rows_of(level) / DIAMETER


def tube_deck(level, variant):
    """A sector of the tube, clamped below; its upper end moves down. The plane y = 0 and its other side are planes of
    symmetry."""
    rows, mesh, angle = rows_of(level), Mesh(), angle_of(level)
    shell = int(variant.split(",")[0].split()[1])

    def place(a, z):
        depth = LENGTH - z  # the first half fold bulges outwards a little
        r = DIAMETER / 2 + (IMPERFECTION * math.sin(math.pi * depth / (2 * HALF_FOLD)) ** 2 if depth < 2 * HALF_FOLD else 0)
        return r * math.cos(a), r * math.sin(a), z

    def ends(i, j, lower, upper, between):
        return lower if j == 0 else upper if j == rows else between if i == 0 else ""

    tube = mesh.sheet(1, [0.0, angle], even(rows, 0.0, LENGTH), place, lambda i, j: ends(i, j, "xyz", "xy", "y"),
                      lambda i, j: ends(i, j, "xyz", "xyz", "xz"))
    cos, sin = math.cos(angle), math.sin(angle)
    thick = 0 if "SSTHK 0" in variant else 1
    self_contact = "" if "no contact" in variant else (
        "*CONTROL_CONTACT\n" + fields(0.1) + fields(*[None] * 5, thick) + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + fields(0, 0, 5) + fields(0.0) + fields(1.0, 1.0) + fields(1, 0.1, 0)
        + fields(0.0) + fields(1, 1))
    return (start("axial crush of a round tube", "mm, ms, kg, kN", WAY / SPEED + RISE / 2, 0.02)
            + history(row[0] for row in tube) + part(1, 1, 1, "tube")
            + "*SECTION_SHELL\n" + fields(1, shell, None, 5) + fields(THICKNESS)
            + "*MAT_PLASTIC_KINEMATIC\n" + fields(1, "7.85E-6", 210.0, 0.3, YIELD, 0.0, 1.0) + "\n"
            + node_set(1, tube[-1]) + node_set(2, (row[1] for row in tube[1:-1]))
            + f"*DEFINE_COORDINATE_VECTOR\n{1:10d}{cos:10.7f}{sin:10.7f}{0.0:10g}{-sin:10.7f}{cos:10.7f}{0.0:10g}\n"
            + "*BOUNDARY_SPC_SET\n" + fields(2, 1, 0, 1, 0, 1, 0, 1)
            + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 3, 0, 1, -SPEED)
            + curve(1, [(0, 0), (RISE, 1), (100, 1)]) + self_contact + mesh.text() + "*END\n")


def least_gap(points):
    """Of a chain of points in a plane: the least distance of a point from a segment more than six thicknesses along."""
    along = [0.0]
    for a, b in zip(points, points[1:]):
        along.append(along[-1] + math.dist(a, b))
    least = math.inf
    for n, p in enumerate(points):
        for i, (a, b) in enumerate(zip(points, points[1:])):
            if min(abs(along[n] - along[i]), abs(along[n] - along[i + 1])) > 6 * THICKNESS:
                side = [q - r for q, r in zip(b, a)]
                share = sum((q - r) * s for q, r, s in zip(p, a, side)) / sum(s * s for s in side)
                share = min(max(share, 0.0), 1.0)
                least = min(least, math.dist(p, [q + share * s for q, s in zip(a, side)]))
    return least


def alexander():
    """Mean force, of folds outwards and inwards, in kN."""
    return 2 * math.pi * YIELD * THICKNESS * HALF_FOLD


def abramowicz_jones():
    """With the effective crushing distance (Abramowicz and Jones 1986), in kN."""
    slender = math.sqrt(DIAMETER / THICKNESS)
    moment = YIELD * THICKNESS ** 2 / (2 * math.sqrt(3))
    return moment * (20.79 * slender + 11.90) / (0.86 - 0.568 / slender)


def tube_values(run, level, variant):
    way = SPEED * (run.history("time")[-1] - RISE / 2)
    mean = 2 * math.pi / angle_of(level) * run.last("external work") / way
    chain = [(rows[-1][9], rows[-1][11]) for _, rows in sorted(run.nodes.items())]
    return [Value("mean force in kN", mean, abramowicz_jones()),
            Value("least gap in mm", least_gap(chain), THICKNESS)]


TUBE = Problem(
    "tube", "Axial crush of a round tube", f"""\
A round tube (mean diameter D = 50 mm, t = 1.5 mm, length 60 mm, E = 210 GPa, ν = 0.3, yield stress σ = 0.25 GPa, ideally plastic), clamped
at both ends, is crushed by 36 mm at 10 m/s and folds like a concertina. The model is one row of shells between two planes of symmetry, so no
mode but this one can form. There is no exact answer. The formula of Abramowicz and Jones (Int. J. Impact Engng 4, 1986),
made for experiments, holds within some 10 to 20 %:

    P / M₀ = (20.79 √(D/t) + 11.90) / (0.86 − 0.568 √(t/D))      M₀ = σ t² / 2 √3

The denominator is the share of the length of a fold by which it gets shorter before its walls meet. Without it, with infinitely thin
walls, P = 2 π σ t h, h² = π D t / 2 √3 (Alexander 1960, mean of folds outwards and inwards): {alexander():.1f} kN. The mean force is the
external work of glstat over the way; the least gap that of the middle of the wall from itself, more than six thicknesses along, by
nodout: t where walls lie on each other. `*CONTACT_AUTOMATIC_SINGLE_SURFACE`, SOFT = 1, SSTHK = 1 where nothing else is said. The meshes have
24 and 48 shells along, 1.7 and 0.83 t long.
""", tube_deck, tube_values, ("ELFORM 2", "ELFORM 16", "ELFORM 16, SSTHK 0", "ELFORM 16, no contact"), levels=(0, 1), column="shells", cause="""\
With contact the mean force lies within the scatter of the formula; it does not converge to it, because where and when folds form
depends on the mesh, and because the way ends within a fold. Self-contact keeps the walls a thickness apart within 1 %. With SSTHK = 0 a single
surface takes at most 0.4 of the edges for the thickness, so the walls come as near as that; the force is a few percent lower. Without contact the folds
pass through each other, and the force stays near Alexander's.

Meshes with shells shorter than half of their thickness do worse, not better: with SSTHK = 1 neighbours in a sharp fold touch each other,
and the contact creates energy, of which the run warns.
""")
