"""A thin elastic ring between rigid plates."""
import functools
import math

from .contacts import VARIANTS, contact
from .mesh import Mesh, curve, even, fields, history, part, start
from .problem import Problem, Value

THICKNESS, POISSON = 0.02, 0.3  # E = R = density = 1
STIFFNESS = THICKNESS ** 3 / 12 / (1 - POISSON ** 2)  # E I of a strip of unit width
SMALL, LARGE = 0.1, 0.6  # way of each plate
STAGE, GAP, PLATE = 1000.0, 1e-4, 0.04


def motion(number):
    """To the small way, a rest, to the large way, a rest; each a STAGE long."""
    points = [(0.0, 0.0)]
    for begin, first, last in ((0, 0.0, SMALL + GAP), (2, SMALL + GAP, LARGE + GAP)):
        points += [((begin + q) * STAGE, first + (last - first) * q ** 3 * (10 - 15 * q + 6 * q * q)) for q in even(40)[1:]]
        points.append(((begin + 2) * STAGE, last))
    return curve(number, points)


def ring_deck(level, variant):
    """A quarter of the ring; the plate below moves up. Shells of ELFORM 2 where the variant names no other."""
    count, mesh = 10 * 2 ** level, Mesh()
    width = math.pi / 2 / count
    soft, _, shell = variant.partition(", ELFORM ")

    def held(i, j):
        return ("x" if i == 0 else "") + "y" + ("z" if i == count else "")

    # Plane strain: nodes turn about y only, those on the planes of symmetry not at all.
    ring = mesh.sheet(1, even(count, 0.0, math.pi / 2), [0.0, width],
                      lambda a, y: (math.sin(a), y, -math.cos(a)), held,
                      lambda i, j: "xyz" if i in (0, count) else "xz")
    mesh.sheet(2, [-0.2, 1.0], [-width, 2 * width], lambda x, y: (x, y, -1.0 - THICKNESS / 2 - PLATE / 2 - GAP))
    return (start("ring between rigid plates (elastica)", "E = R = density = 1, plane strain", 4 * STAGE, 10.0, 0.6)
            + history([ring[0][0], ring[0][-1]]) + part(1, 1, 1, "ring") + part(2, 2, 2, "plate")
            + "*SECTION_SHELL\n" + fields(1, int(shell or 2), None, 2) + fields(THICKNESS) + "*SECTION_SHELL\n" + fields(2, 2) + fields(PLATE)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON) + "*MAT_RIGID\n" + fields(2, 1.0, 1.0, 0.3)
            + fields(1.0, 4, 7) + "\n" + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n" + fields(2, 3, 2, 1) + motion(1)
            + "*DAMPING_GLOBAL\n" + fields(0, 0.03) + contact(soft, scale=1.0, soft_scale=0.1) + mesh.text() + "*END\n")


@functools.lru_cache
def integrals(m):
    """∫ dθ / √(m + sin θ) and ∫ sin θ dθ / √(m + sin θ) from 0 to π / 2."""
    count, top = 4000, math.sqrt(math.pi / 2)
    first = second = 0.0
    for i in range(count):  # θ = u²: no singularity at m = 0
        u = top * (i + 0.5) / count
        sine = math.sin(u * u)
        weight = 2 * u / math.sqrt(m + sine) * top / count
        first, second = first + weight, second + weight * sine
    return first, second


def elastica(way):
    """P R² / E I, distance of the lines of contact from the middle and half width of the ring over R."""
    def height(m):
        first, second = integrals(m)
        return math.pi / 2 * second / first
    if height(0.0) < 1 - way:  # the ring touches at its pole
        low, high = 0.0, 1e4
        for _ in range(100):
            m = (low + high) / 2
            low, high = (m, high) if height(m) < 1 - way else (low, m)
        root = integrals(m)[0] / (math.pi / 2)
        return root ** 2, 0.0, 2 * (math.sqrt(m + 1) - math.sqrt(m)) / root
    first, second = integrals(0.0)
    root = second / (1 - way)
    lift = math.pi / 2 - first / root
    return root ** 2, lift, lift + 2 / root


def ring_values(run, level, variant):
    width = math.pi / 2 / (10 * 2 ** level)

    def load(end):
        """Of the whole ring, over the last fifth of a rest."""
        inside = [abs(f[2]) for t, f in run.rcforc(1, "A") if end - 0.2 * STAGE < t <= end]
        return 2 * sum(inside) / len(inside) / width / STIFFNESS
    ring = {n for corners in run.shells_of(1) for n in corners}
    forces = [(f.position[0], abs(f.force[2])) for f in run.node_forces() if f.node in ring]
    lift = sum(x * f for x, f in forces) / sum(f for _, f in forces)
    side = max(run.nodes.values(), key=lambda rows: rows[0][9])
    small, (large, edge, half) = elastica(SMALL)[0], elastica(LARGE)
    return [Value("load at 0.1", load(2 * STAGE), small), Value("load at 0.6", load(4 * STAGE), large),
            Value("lines of contact", lift, edge), Value("half width", side[-1][9], half)]


RING = Problem(
    "ring", "Ring between rigid plates", """\
A thin elastic ring (E = R = ρ = 1, ν = 0.3, thickness 0.02, plane strain; a quarter by symmetry) is pressed slowly between two rigid,
frictionless plates, damped, and rests where each plate has moved by 0.1 and by 0.6. It bends without stretching, so the closed form is the
elastica (Frisch-Fay, Flexible Bars, 1962): the force P / 2 in a quarter is the same everywhere, and with the angle θ of the tangent,
I = E t³ / 12 (1 − ν²) and the curvature κ₀ at the plate

    E I θ'² / 2 = E I κ₀² / 2 + P / 2 sin θ      ∫ ds from θ = 0 to π / 2: π R / 2      ∫ sin θ ds: R less the way of the plate

Small ways have P = δ E I / 0.1488 R³ with the shortening δ of the diameter. At P R² = 2.786 E I, way 0.282 R, the ring is flat at the
plate (κ₀ = 0). From there on a flat piece of it lies on the plate without pressure: it touches along two lines, x = c, at the ends of that
piece, with P / 2 each, and P grows as (∫₀ √sin θ dθ)² E I / h² with the half height h. Given are P R² / E I at both rests, from rcforc; c, by
Σ F x / Σ F of ncforc; and the half width of the ring, by nodout. Shells of ELFORM 2 where nothing else is said; the meshes have 10,
20 and 40 along the quarter. SFSA = SFSB = 1, SOFSCL = 0.1.
""", ring_deck, ring_values, VARIANTS + ("SOFT 1, ELFORM 16",), cause="""\
The ring of straight shells is a polygon, and only nodes touch the plate: both of order 2. What remains on the finest mesh with mortar
contact is the depth of its pressure, the other contacts have hardly any: the ring is soft beside their springs.
""")
