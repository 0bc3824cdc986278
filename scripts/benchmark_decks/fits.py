"""Bodies that lie in each other: a press fit of rings, a pin in a hole."""
import math

from .contacts import contact
from .mesh import Mesh, even, fields, graded, history, node_set, part, segment_set, smooth, start
from .problem import Problem, Value

POISSON, PLANE = 0.3, 1 - 0.3 ** 2

# Press fit ----------------------------------------------------------------------------------------------------------

INNER, MIDDLE, OUTER, YOUNG, OVERLAP = 0.6, 1.0, 1.5, 1000.0, 0.002


def press_fit_deck(level, variant):
    """A quarter of two rings in plane strain that overlap; the outer one has other bricks around than the inner one."""
    mesh, walls, length = Mesh(), 3 * 2 ** level, 0.1

    def ring(part_id, inside, outside, around):
        def place(r, angle, z):
            return r * math.cos(angle), r * math.sin(angle), z
        return mesh.block(part_id, even(walls, inside, outside), even(around, 0, math.pi / 2), [0.0, length], place,
                          lambda i, j, k: "yz" if j == 0 else "xz" if j == around else "z")

    ring(1, INNER, MIDDLE + OVERLAP / 2, 12 * 2 ** level)
    outer = ring(2, MIDDLE - OVERLAP / 2, OUTER, 12 * 2 ** level)
    text = (start("press fit of two rings (Lame)", "E = 1000, density = 1, plane strain", 2.0, 0.1, 0.4)
            + history([outer[0][0][-1]]) + part(1, 1, 1, "inner") + part(2, 1, 1, "outer") + "*SECTION_SOLID\n"
            + fields(1, 1) + "*MAT_ELASTIC\n" + fields(1, 1.0, YOUNG, POISSON)
            + "*DEFINE_CURVE\n" + fields(1) + "".join(f"{x:20g}{y:20g}\n" for x, y in ((0, 0), (1, 1), (100, 1)))
            + "*DAMPING_GLOBAL\n" + fields(0, 20.0))
    if variant == "INTERFERENCE":
        text += ("*CONTACT_SURFACE_TO_SURFACE_INTERFERENCE\n" + fields(1, 2, 3, 3) + fields(0.0) + fields(10.0, 10.0)
                 + fields(0, 1))
    else:  # card B: PENMAX; card C: IGAP, IGNORE, MPAR1, MPAR2
        text += ("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n" + fields(1, 2, 3, 3) + fields(0.0)
                 + fields(100.0, 100.0) + fields(0) + fields(0.001) + fields(1, 3, 1.0, 0.01))
    return text + mesh.text() + "*END\n"


def lame_pressure(overlap):
    """Of equal materials in plane strain (Lamé 1852)."""
    e, nu = YOUNG / PLANE, POISSON / (1 - POISSON)
    aa, bb, cc = INNER ** 2, MIDDLE ** 2, OUTER ** 2
    return overlap * e / MIDDLE / ((cc + bb) / (cc - bb) + nu + (bb + aa) / (bb - aa) - nu)


def press_fit_values(run, level, variant):
    pressure = abs(run.rcforc(1, "B")[-1][1][0]) / (MIDDLE * 0.1)
    exact = lame_pressure(OVERLAP)
    growth = 2 * exact * PLANE * MIDDLE ** 2 * OUTER / (YOUNG * (OUTER ** 2 - MIDDLE ** 2))
    rim = next(iter(run.nodes.values()))
    return [Value("pressure", pressure, exact), Value("growth of the outer radius", rim[-1][0], growth)]


PRESS_FIT = Problem(
    "press_fit", "Press fit of two rings", """\
A quarter of two rings (radii 0.6, 1 and 1.5; E = 1000, ν = 0.3, ρ = 1) in plane strain, whose radii overlap by δ = 0.002. Contact
pushes them apart until the time 1: INTERFERENCE by its curve of stiffness, mortar by IGNORE = 3 and MPAR1 = 1; then damping brings
them to rest. With b the radius of the fit (Lamé 1852; equal materials):

    p = δ E' / b / ((c² + b²) / (c² − b²) + (b² + a²) / (b² − a²))      E' = E / (1 − ν²)

The pressure is that of the resultant on a quarter, F / (b · length). SFSA = SFSB = 10, mortar 100 with PENMAX = 0.001.
""", press_fit_deck, press_fit_values, ("INTERFERENCE", "mortar"), levels=(0, 1), cause="""\
What remains of the overlap is the penetration of the springs, which falls with the edges. Nodes at the ends of the quarter have the
spring of a whole node and take more than their share ([contact](../solver-contact.md#limits)).
""")

# Pin ----------------------------------------------------------------------------------------------------------------

CLEARANCE = 0.002  # of the radii, the hole has the radius 1
RIM = 16.0
CORE = 0.12
HALF_ANGLE = math.radians(50)


def persson_load(half_angle):
    """Force per length over E* and clearance, E* = E / (1 − ν²) of both (Persson 1964; Ciavarella and Decuzzi 2001)."""
    bb = math.tan(half_angle / 2) ** 2
    return math.pi * (bb + 1) * bb / (2 - math.log(bb + 1) - 2 * bb * bb)


def persson_pressure(angle, half_angle):
    """Times R / Q."""
    b, y = math.tan(half_angle / 2), math.tan(angle / 2)
    root, top = math.sqrt(max(b * b - y * y, 0.0)), math.sqrt(b * b + 1)
    return (2 / (math.pi * top) * root / (1 + y * y)
            + math.log((top + root) / (top - root)) / (2 * math.pi * b * b * (1 + b * b)))


def half_angle_of(load):
    """The half angle of contact of a force per length over E* and clearance."""
    low, high = 0.01, 1.9
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if persson_load(middle) < load else (low, middle)
    return low


def pin_deck(level, variant):
    """Half of a pin (x > 0) in a hole of a plate; the middle of the pin moves down."""
    around, mesh = 14 * 2 ** level, Mesh()
    width = math.pi / around

    def place(angle, r, y):
        return r * math.sin(angle), y, -r * math.cos(angle)

    def held(i, j, k):
        return ("x" if i in (0, around) else "") + "y"

    angles = even(around, 0, math.pi)
    growth = 1.35 ** (1 / 2 ** level)
    radii = [1 - CLEARANCE - q for q in reversed(graded(width, 0.2, 1 - CLEARANCE - CORE, 1.15))]
    pin = mesh.block(1, angles, radii, [0.0, width], lambda a, r, y: shifted(place(a, r, y), -CLEARANCE), held)
    plate = mesh.block(2, angles, [1 + q for q in graded(width, 0.2, RIM - 1, growth)], [0.0, width], place, held)
    core = sorted(n for layer in pin for n in layer[0])
    rim = sorted(n for layer in plate for n in layer[-1])
    move = 2.6 * CLEARANCE
    return (start("pin in a hole (Persson)", "E = density = 1, radius of the hole 1, plane strain", 35.0, 1.0, 0.4)
            + history(core[:1]) + part(1, 1, 1, "pin") + part(2, 1, 1, "plate") + "*SECTION_SOLID\n" + fields(1, 1)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON) + node_set(1, core) + node_set(2, rim)
            + "*BOUNDARY_SPC_SET\n" + fields(2, 0, 1, 1, 1) + "*BOUNDARY_PRESCRIBED_MOTION_SET\n"
            + fields(1, 3, 2, 1, -1.0) + smooth(1, 25.0, move) + "*DAMPING_GLOBAL\n" + fields(0, 0.4)
            + segment_set(1, list(zip(pin[0][-1], pin[1][-1]))) + segment_set(2, list(zip(plate[0][0], plate[1][0]))[::-1])
            + contact(variant, kinds=(0, 0), scale=30.0, soft_scale=1.0, segment_scale=20.0, depth=width / 10) + mesh.text() + "*END\n")


def shifted(point, z):
    return point[0], point[1], point[2] + z


def pin_values(run, level, variant):
    width = math.pi / (14 * 2 ** level)
    found = run.pressures(1, lambda p: abs(math.hypot(p[0], p[2] + CLEARANCE) - 1 + CLEARANCE) < 1e-6).values()
    load = 2 * sum(force[2] for _, force, _ in found) / width
    half = half_angle_of(load * PLANE / CLEARANCE)

    def turn(p):  # around the middle of the hole
        return math.atan2(p[0], -p[2])
    sizes = [(turn(p), math.hypot(force[0], force[2])) for p, force, _ in found]
    spread = math.sqrt(sum(f * a * a for a, f in sizes) / sum(f for _, f in sizes))
    steps = [half * (i + 0.5) / 2000 for i in range(2000)]
    pressures = [persson_pressure(a, half) for a in steps]
    ideal = math.sqrt(sum(p * a * a for p, a in zip(pressures, steps)) / sum(pressures))
    peak = max(p for _, _, p in found)
    return [Value("spread of the pressure", spread, ideal), Value("peak pressure", peak, load * persson_pressure(0, half))]


PIN = Problem(
    "pin", "Pin in a hole", """\
Half of a pin in a hole (radius R = 1, clearance ΔR = 0.002 R; E = 1, ν = 0.3, plane strain, frictionless) of a plate that is held at
the radius 16. A core of the pin of 0.12 of its radius moves down, smoothly over the time 25, and is held until 35. With the
force Q per length and the half angle ε of contact (Persson 1964; M. Ciavarella and P. Decuzzi, Int. J. Solids Struct. 38, 2001, equal
materials), b = tan(ε/2), y = tan(φ/2):

    E* ΔR / Q = (2 − ln(b² + 1) − 2 b⁴) / (π (b² + 1) b²)      E* = E / (1 − ν²)

    p R / Q = 2/π √(b² − y²) / (√(b² + 1) (1 + y²)) + 1 / (2 π b² (1 + b²)) ln((√(b² + 1) + √(b² − y²)) / (√(b² + 1) − √(b² − y²)))

The spread is √(∫ p φ² / ∫ p), where the nodes are at the end. The contact is that of the segments of pin and hole; the meshes have 14, 28 and 56 bricks
around half of it. SOFT 0:
SFSA = SFSB = 30, SOFT 1: SOFSCL = 1, SOFT 2: SFSA = SFSB = 20, mortar: SFSA = SFSB = 30 and PENMAX a tenth of a brick.
""", pin_deck, pin_values, ("SOFT 0", "SOFT 1", "SOFT 2", "mortar"), cause="""\
Coarse bricks make the contact too wide and its pressure too small; the penetration of the springs is a part of the clearance. Both
fall with the edges. The theory has a pin that is loaded in its middle and a plate without end; a rigid core and a rim hold them round, and
so make the contact narrower: with a core of 0.25 by 1.7 %, with a rim at 8 by 0.4 %, on the same mesh. It also takes the angle of a
point of the pin for that of the point of the hole that it touches; they differ by the way of the pin, 2.6 ΔR / R = 0.5 %.
""")
