"""Hertz: a cylinder on a cylinder."""
import math

from .contacts import VARIANTS, contact
from .mesh import Mesh, fields, graded, history, node_set, part, segment_set, smooth, start
from .problem import Problem, Value

POISSON = 0.3
PLANE = 1 - POISSON ** 2  # E* = E / PLANE beside a rigid body, half of that beside its equal; E = 1

# Cylinders ----------------------------------------------------------------------------------------------------------

HALF_WIDTH = 0.04


def quarter_disc(mesh, part_id, step, growth, width, up):
    """A quarter of a disc, one brick thick, whose rim touches z = 0 at x = 0, above (up = 1) or below. Its ids; the
    node of the pole is ids[-1][0][0], the equator is ids[0]."""
    across = graded(step, 1.5 * HALF_WIDTH, 1.0, growth)

    def place(x, y, z):
        most, norm = max(x, z), math.hypot(x, z)
        share = 1 - most + most * most / norm if norm > 0 else 1
        # Both axes turn with `up`, so the bricks stay right-handed.
        return x * share, width - y if up > 0 else y, up * (1 - z * share)

    return mesh.block(part_id, across, [0.0, width], [1 - q for q in reversed(across)], place,
                      lambda i, j, k: ("x" if i == 0 else "") + "y")


def cylinders_deck(level, variant):
    h = HALF_WIDTH / 2 / 2 ** level
    growth = 1.4 ** (1 / 2 ** level)
    mesh = Mesh()
    upper = quarter_disc(mesh, 1, h, growth, h, 1)
    lower = quarter_disc(mesh, 2, 1.17 * h, growth, h, -1)
    equators = [[n for row in ids[0] for n in row] for ids in (upper, lower)]
    # Half of the approach each, for the half width that was chosen.
    move = cylinder_approach(HALF_WIDTH) / 2
    return (start("cylinder on cylinder (Hertz)", "E = R = density = 1, plane strain", 6.5, 0.5, 0.55)
            + history([upper[0][0][0], lower[0][0][0], upper[-1][0][0]]) + part(1, 1, 1, "upper") + part(2, 1, 1, "lower")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON)
            + node_set(1, equators[0]) + node_set(2, equators[1])
            + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 3, 2, 1, -1.0) + fields(2, 3, 2, 1, 1.0)
            + smooth(1, 3.5, move) + "*DAMPING_GLOBAL\n" + fields(0, 3.0)
            + segment_set(1, upper[-1]) + segment_set(2, lower[-1]) + contact(variant, kinds=(0, 0), scale=40.0, soft_scale=1.0, segment_scale=20.0, depth=h / 10) + mesh.text() + "*END\n")


def cylinder_load(half_width):
    """Force per length of two equal cylinders of R = 1: b² = 4 P R* / π E*, R* = R / 2, E* = E / 2 (1 − ν²)."""
    return math.pi * half_width ** 2 / (4 * PLANE)


def cylinder_approach(half_width):
    """Of the middles of two cylinders, each loaded at both ends of a diameter (Johnson 1985, equation 5.57)."""
    return 2 * cylinder_load(half_width) * PLANE / math.pi * (2 * math.log(4 / half_width) - 1)


def cylinder_values(run, level, variant):
    width = HALF_WIDTH / 2 / 2 ** level
    found = run.shares(1, lambda p: abs(math.hypot(p[0], p[2] - 1) - 1) < 1e-6).values()
    total = sum(force[2] for _, force, _ in found)
    load = 2 * total / width
    # Σ F x² / Σ F = b² / 4 for Hertz' pressure.
    half = 2 * math.sqrt(sum(force[2] * x * x for (x, _, _), force, _ in found) / total)
    ideal = math.sqrt(4 * load * PLANE / math.pi)
    # The peak of Hertz' distribution with the force that the nodes within half of its width carry.
    inner = [(force[2], area * math.sqrt(1 - (x / ideal) ** 2)) for (x, _, _), force, area in found if x < ideal / 2]
    tops = sorted(run.nodes.values(), key=lambda rows: rows[0][11])
    approach = tops[0][-1][2] - tops[-1][-1][2]
    return [Value("half width", half, ideal),
            Value("peak pressure", sum(f for f, _ in inner) / sum(w for _, w in inner), 2 * load / math.pi / ideal),
            Value("approach", approach, cylinder_approach(ideal))]


CYLINDERS = Problem(
    "hertz_cylinders", "Hertz: cylinder on cylinder", """\
Two equal cylinders, half of each by symmetry, in plane strain (one brick thick; E = R = ρ = 1, ν = 0.3); their equators are
pushed together smoothly over the time 3.5, damped, and held until 6.5. The meshes do not match: the lower one is 1.17 times as
coarse. With the force P per length (Hertz 1881; Johnson, Contact Mechanics, 1985, equations 4.45 and 5.57):

    b² = 4 P (1 − ν²) R / π E      p₀ = 2 P / π b      δ = 2 P (1 − ν²) / π E · (2 ln(4 R / b) − 1)

The half width is measured by Σ F x² / Σ F = b² / 4 over the nodes of the upper one, the peak pressure is that of Hertz'
distribution with the force of the nodes within b / 2, both where the nodes are at the end: in plane strain the surface shrinks by (1 + ν)(1 − 2 ν) p / E. δ is the approach of the
equators. The nominal half width is 0.04, for small strains; the meshes have 2, 4 and 8 bricks over it. The contact is that of the
segments of the rims. SOFT 0: SFSA = SFSB = 40, SOFT 1: SOFSCL = 1, SOFT 2: SFSA = SFSB = 20, mortar: SFSA = SFSB = 40 and PENMAX a tenth of a brick; TSSFAC = 0.55.
""", cylinders_deck, cylinder_values, VARIANTS, cause="""\
The half width by the moment of the forces weighs the nodes at the rim most, where the pressure has its steepest slope, so it needs
more bricks than the other two. The springs are an elastic layer between the bodies that adds to the approach; its thickness falls with
the edges.
""")
