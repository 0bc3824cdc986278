"""Hertz: a ball on a rigid plate, a cylinder on a cylinder."""
import math

from .contacts import VARIANTS, contact
from .mesh import Mesh, fields, graded, history, node_set, part, smooth, start
from .problem import Problem, Value

POISSON = 0.3
PLANE = 1 - POISSON ** 2  # E* = E / PLANE beside a rigid body, half of that beside its equal; E = 1

# Ball ---------------------------------------------------------------------------------------------------------------

BALL_RADIUS_OF_CONTACT = 0.1  # by the approach a²/R, R = 1


def ball_deck(level, variant):
    """An eighth of a ball, its equator pushed towards the plate below."""
    h = BALL_RADIUS_OF_CONTACT / 1.5 / 2 ** level
    growth = 1.6 ** (1 / 2 ** min(level, 1))
    across = graded(h, 0.15, 1.0, growth)
    mesh = Mesh()
    top = len(across) - 1

    def place(x, y, z):
        # From the cube to the ball: its surface wholly, its middle not at all. The pole looks down.
        cube = (x, y, z)
        most, norm = max(cube), math.sqrt(x * x + y * y + z * z)
        share = 1 - most + most * most / norm if norm > 0 else 1
        return y * share, x * share, -z * share

    ids = mesh.block(1, across, across, [1 - q for q in reversed(across)], place,
                     lambda i, j, k: ("x" if j == 0 else "") + ("y" if i == 0 else ""))
    mesh.sheet(2, [-0.2, 1.2], [-0.2, 1.2], lambda x, y: (x, y, -1.0 - PLATE / 2 - GAP))
    deepest = ids[top][0][0]
    equator = [n for row in ids[0] for n in row]
    axis = [ids[k][0][0] for k in range(top + 1)]
    depth = min(axis, key=lambda n: abs(mesh.nodes[n - 1][2] + 1 - 2 * BALL_RADIUS_OF_CONTACT))
    return (start("ball on a rigid plate (Hertz)", "E = R = density = 1", 8.0, 0.5, 0.4)
            + history([deepest, depth]) + part(1, 1, 1, "ball") + part(2, 2, 2, "plate")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*SECTION_SHELL\n" + fields(2, 2) + fields(PLATE)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON)
            + "*MAT_RIGID\n" + fields(2, 1.0, 1000.0, 0.3) + fields(1.0, 7, 7) + "\n"
            + node_set(1, equator) + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 3, 2, 1)
            + smooth(1, 5.0, -BALL_RADIUS_OF_CONTACT ** 2 - GAP) + "*DAMPING_GLOBAL\n" + fields(0, 1.5)
            + contact(variant, scale=40.0) + mesh.text() + "*END\n")


PLATE, GAP = 0.02, 1e-5


def hertz_shortening(depth, a, peak):
    """How much the axis shortens between the surface and `depth` in a half-space with Hertz' pressure; E = 1. Johnson
    (1985), equations 3.45: stresses on the axis."""
    def strain(z):
        s = z / a
        along = -1 / (1 + s * s)
        across = -(1 + POISSON) * (1 - s * math.atan2(1, s)) + 0.5 / (1 + s * s)
        return -peak * (along - 2 * POISSON * across)
    count = 2000
    return sum(strain(depth * (i + 0.5) / count) for i in range(count)) * depth / count


def ball_values(run, level, variant):
    found = run.pressures(1, lambda p: math.hypot(*p) > 1 - 1e-6).values()
    total = 4 * sum(force[2] for _, force, _ in found)
    # Σ F r² / Σ F = 2/5 a² for Hertz' pressure.
    radius = math.sqrt(2.5 * sum(4 * force[2] * (x * x + y * y) for (x, y, _), force, _ in found) / total)
    ideal = (0.75 * PLANE * total) ** (1 / 3)
    peak = 1.5 * total / (math.pi * ideal ** 2)
    pole, inside = sorted(run.nodes.values(), key=lambda rows: rows[0][11])
    short = (pole[-1][2] - inside[-1][2])
    depth = inside[0][11] - pole[0][11]
    return [Value("contact radius", radius, ideal), Value("peak pressure", max(p for _, _, p in found), peak),
            Value("shortening", short, hertz_shortening(depth, ideal, peak))]


BALL = Problem(
    "hertz_ball", "Hertz: ball on a rigid plate", """\
An eighth of a ball of bricks (E = R = ρ = 1, ν = 0.3) is pressed against a rigid plate by its equator: smoothly over the
time 5, damped, and held until 8. With the force F that the plate then carries (Hertz 1881; Johnson, Contact Mechanics, 1985):

    a³ = 3 F R / 4 E*      p₀ = 3 F / 2 π a²      E* = E / (1 − ν²)

The contact radius is measured by the forces on the nodes, Σ F r² / Σ F = 2/5 a²; the peak pressure is the greatest one at a
node; the shortening is that of the axis down to a depth of about 2 a, against the strains of Hertz' stresses (Johnson, equation
3.45). The meshes have 1.5, 3 and, with SOFT 2, 6 bricks over the contact radius, and
coarser ones behind. SOFT 0 and mortar have SFSA = SFSB = 40, SOFT 1 and 2
SOFSCL = 0.4 and SFSA = SFSB = 1.
""", ball_deck, ball_values, VARIANTS, finest={v: 1 for v in VARIANTS if v != "SOFT 2"}, cause="""\
Few bricks over the contact radius: the nodes at the rim of the contact weigh most in Σ F r², and the springs are an elastic layer as
thick as a brick. With mortar the two act against each other in the shortening of the coarse mesh: coarse strains are too large, those below an
evened pressure too small. The reference of the shortening is that of a half-space.
""")

# Cylinders ----------------------------------------------------------------------------------------------------------

HALF_WIDTH = 0.1


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
    return (start("cylinder on cylinder (Hertz)", "E = R = density = 1, plane strain", 8.0, 0.5, 0.4)
            + history([upper[0][0][0], lower[0][0][0], upper[-1][0][0]]) + part(1, 1, 1, "upper") + part(2, 1, 1, "lower")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON)
            + node_set(1, equators[0]) + node_set(2, equators[1])
            + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 3, 2, 1, -1.0) + fields(2, 3, 2, 1, 1.0)
            + smooth(1, 5.0, move) + "*DAMPING_GLOBAL\n" + fields(0, 1.5)
            + contact(variant, scale=40.0) + mesh.text() + "*END\n")


def cylinder_load(half_width):
    """Force per length of two equal cylinders of R = 1: b² = 4 P R* / π E*, R* = R / 2, E* = E / 2 (1 − ν²)."""
    return math.pi * half_width ** 2 / (4 * PLANE)


def cylinder_approach(half_width):
    """Of the middles of two cylinders, each loaded at both ends of a diameter (Johnson 1985, equation 5.57)."""
    return 2 * cylinder_load(half_width) * PLANE / math.pi * (2 * math.log(4 / half_width) - 1)


def cylinder_values(run, level, variant):
    width = HALF_WIDTH / 2 / 2 ** level
    found = run.pressures(1, lambda p: abs(math.hypot(p[0], p[2] - 1) - 1) < 1e-6).values()
    total = sum(force[2] for _, force, _ in found)
    load = 2 * total / width
    # Σ F x² / Σ F = b² / 4 for Hertz' pressure.
    half = 2 * math.sqrt(sum(force[2] * x * x for (x, _, _), force, _ in found) / total)
    ideal = math.sqrt(4 * load * PLANE / math.pi)
    tops = sorted(run.nodes.values(), key=lambda rows: rows[0][11])
    approach = tops[0][-1][2] - tops[-1][-1][2]
    return [Value("half width", half, ideal), Value("peak pressure", max(p for _, _, p in found), 2 * load / math.pi / ideal),
            Value("approach", approach, cylinder_approach(ideal))]


CYLINDERS = Problem(
    "hertz_cylinders", "Hertz: cylinder on cylinder", """\
Two equal cylinders, half of each by symmetry, in plane strain (one brick thick; E = R = ρ = 1, ν = 0.3); their equators are
pushed together smoothly over the time 5, damped, and held until 8. The meshes do not match: the lower one is 1.17 times as
coarse. With the force P per length (Hertz 1881; Johnson, Contact Mechanics, 1985, equations 4.45 and 5.57):

    b² = 4 P (1 − ν²) R / π E      p₀ = 2 P / π b      δ = 2 P (1 − ν²) / π E · (2 ln(4 R / b) − 1)

The half width is measured by Σ F x² / Σ F = b² / 4 over the nodes of the upper one, the peak pressure is the greatest one at a
node, δ is the approach of the equators. The meshes have 2, 4 and 8 bricks over the half width. SFSA = SFSB = 40, SOFSCL = 0.4.
""", cylinders_deck, cylinder_values, VARIANTS, cause="""\
The springs are an elastic layer, as thick as a brick, that adds to the approach and widens the contact: of order 1 for the approach.
The half width by the moment of the forces weighs the nodes at the rim most, where the pressure has its steepest slope, so it needs
more bricks than the other two.
""")
