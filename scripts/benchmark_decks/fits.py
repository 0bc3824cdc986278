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

CLEARANCE = 0.0005  # of the radii, the hole has the radius 1
RIM, BLOCK, LOADED = 16.0, 0.6, 0.1
HALF_ANGLE = math.radians(64)


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


def edge_of_pin(level):
    return math.pi / 28 / 2 ** level


def growth_of_pin(level):
    return 1.3 ** (1 / 2 ** level)


def pin_angles(level):
    """From the middle of the contact on: even up to 75 degrees, the last eighth of the circle as the first one."""
    edge, quarter = edge_of_pin(level), math.pi / 2
    first = even(round(quarter / 2 / edge), 0.0, quarter / 2)
    side = [quarter / 2 + q for q in graded(edge, quarter / 3, quarter, growth_of_pin(level))]
    return first[:-1] + side[:-1] + [math.pi - q for q in reversed(first)]


def pin_mesh(mesh, level, radius, width):
    """Half of a disc, x > 0: a square block, its sides bulged by half, and a ring around it. Ids of both layers of the rim by
    angle, and of the nodes near the middle."""
    angles = pin_angles(level)
    first = round(math.pi / 4 / edge_of_pin(level))
    across, along = [math.tan(a) for a in angles[:first + 1]], [-1 / math.tan(a) for a in angles[first:-first]]

    def bulged(x, y, z):
        most, norm = max(x, abs(z)), math.hypot(x, z)
        share = BLOCK * (1 - (most - most * most / norm) / 2) if norm > 0 else 1
        return x * share, y, z * share

    ids = mesh.block(1, across, [0.0, width], along, bulged, lambda i, j, k: ("x" if i == 0 else "") + "y")
    inner = [n for plane in ids for row in plane for n in row if math.hypot(*mesh.nodes[n - 1][::2]) < LOADED]
    layers = [[ids[0][j][:-1] + [plane[j][-1] for plane in ids] + ids[-1][j][-2::-1]] for j in (0, 1)]
    depth = radius - BLOCK
    for q in reversed(graded(edge_of_pin(level), 0.2, depth, growth_of_pin(level))[:-1]):
        for j, rows in enumerate(layers):
            row = []
            for i, (angle, foot) in enumerate(zip(angles, rows[0])):
                x, _, z = mesh.nodes[foot - 1]
                row.append(mesh.add_node((x * q / depth + (1 - q / depth) * radius * math.sin(angle), j * width,
                                          z * q / depth - (1 - q / depth) * radius * math.cos(angle)),
                                         ("x" if i in (0, len(angles) - 1) else "") + "y"))
            rows.append(row)
        for i in range(len(angles) - 1):
            mesh.elements["SOLID"].append((1, [rows[k][i + a] for rows in layers for a, k in ((0, -2), (1, -2), (1, -1), (0, -1))]))
    return [rows[-1] for rows in layers], inner


def pin_deck(level, variant):
    """Half of a pin in a hole of a plate; a force pulls the middle of the pin down."""
    mesh, width = Mesh(), edge_of_pin(level)
    angles, radius = pin_angles(level), 1 - CLEARANCE
    pin, loaded = pin_mesh(mesh, level, radius, width)
    # The pin touches the hole at its lowest point.
    mesh.nodes = [(x, y, z - CLEARANCE) for x, y, z in mesh.nodes]
    plate = mesh.block(2, angles, [1 + q for q in graded(width, 0.2, RIM - 1, growth_of_pin(level))], [0.0, width],
                       lambda angle, r, y: (r * math.sin(angle), y, -r * math.cos(angle)),
                       lambda i, j, k: ("x" if i in (0, len(angles) - 1) else "") + "y")
    rim = sorted(n for layer in plate for n in layer[-1])
    force = persson_load(HALF_ANGLE) * CLEARANCE / PLANE / 2 * width
    return (start("pin in a hole (Persson)", "E = density = 1, radius of the hole 1, plane strain", 24.0, 1.0, 0.6)
            + history(loaded[:1]) + part(1, 1, 1, "pin") + part(2, 1, 1, "plate") + "*SECTION_SOLID\n" + fields(1, 1)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON) + node_set(1, loaded) + node_set(2, rim)
            + "*BOUNDARY_SPC_SET\n" + fields(2, 0, 1, 1, 1) + "*LOAD_NODE_SET\n" + fields(1, 3, 1, 1.0)
            + smooth(1, 14.0, -force / len(loaded)) + "*DAMPING_GLOBAL\n" + fields(0, 0.4)
            + segment_set(1, list(zip(*pin))) + segment_set(2, list(zip(plate[0][0], plate[1][0]))[::-1])
            + contact(variant, kinds=(0, 0), scale=10.0, soft_scale=1.0, segment_scale=20.0, depth=width / 40) + mesh.text() + "*END\n")


def pin_values(run, level, variant):
    found = run.shares(1, lambda p: abs(math.hypot(p[0], p[2] + CLEARANCE) - 1 + CLEARANCE) < 1e-6).values()
    load = 2 * sum(force[2] for _, force, _ in found) / edge_of_pin(level)
    half = half_angle_of(load * PLANE / CLEARANCE)
    # Angle around the middle of the hole, size of the force, area.
    nodes = [(math.atan2(p[0], -p[2]), math.hypot(force[0], force[2]), area) for p, force, area in found]
    spread = math.sqrt(sum(f * a * a for a, f, _ in nodes) / sum(f for _, f, _ in nodes))
    steps = [half * (i + 0.5) / 2000 for i in range(2000)]
    pressures = [persson_pressure(a, half) for a in steps]
    ideal = math.sqrt(sum(p * a * a for p, a in zip(pressures, steps)) / sum(pressures))
    # The peak of Persson's distribution with the force that the nodes within a quarter of its angle carry.
    inner = [(f, area * persson_pressure(a, half) / persson_pressure(0, half)) for a, f, area in nodes if a < half / 4]
    peak = sum(f for f, _ in inner) / sum(w for _, w in inner)
    return [Value("spread of the pressure", spread, ideal), Value("peak pressure", peak, load * persson_pressure(0, half))]


PIN = Problem(
    "pin", "Pin in a hole", """\
Half of a pin in a hole (radius R = 1, clearance ΔR = 0.0005 R; E = 1, ν = 0.3, plane strain, frictionless) of a plate that is held at
the radius 16. A force on its middle, spread over 0.1 of its radius, pulls the pin down: smoothly over the time 14, damped, and on until
24. It is that of a half angle of contact of 64°. With the force Q per length that the hole carries at the end and its half angle ε of contact
(Persson 1964; M. Ciavarella and P. Decuzzi, Int. J. Solids Struct. 38, 2001, equal materials), b = tan(ε/2), y = tan(φ/2):

    E* ΔR / Q = (2 − ln(b² + 1) − 2 b⁴) / (π (b² + 1) b²)      E* = E / (1 − ν²)

    p R / Q = 2/π √(b² − y²) / (√(b² + 1) (1 + y²)) + 1 / (2 π b² (1 + b²)) ln((√(b² + 1) + √(b² − y²)) / (√(b² + 1) − √(b² − y²)))

The spread is √(∫ p φ² / ∫ p), where the nodes are at the end; the peak pressure is that of Persson's distribution with the force of
the nodes within ε / 4. The contact is that of the segments of pin and hole. The meshes match; their bricks are 1/28, 1/56 and 1/112
of half the circle up to 75°, longer beyond and away from the surfaces. SOFT 0: SFSA = SFSB = 10, SOFT 1: SOFSCL = 1, SOFT 2:
SFSA = SFSB = 20, mortar: SFSA = SFSB = 10 and PENMAX a fortieth of a brick; TSSFAC = 0.6.
""", pin_deck, pin_values, ("SOFT 0", "SOFT 1", "SOFT 2", "mortar"), cause="""\
The hole is a polygon, whose sides are nearer to its middle than the circle is: by u e / 2 at a small distance u from a corner, with
edges e. The pin slides along the hole by 1.3 to 1.9 ΔR sin φ, so its nodes find a clearance that is smaller by a share of
0.8 e sin φ: the contact is too wide and its peak too low, with order 1 and at any clearance. That is the error of SOFT 0, 1 and 2; with springs
four times as stiff (TSSFAC = 0.3, SOFT 1) the peak of the middle mesh is 3.1 % too low in place of 2.8 %. Mortar contact takes the mean over faces: the sides of the pin lie as much inside
its circle as those of the hole, so it does not have this error. The theory takes the angle of a
point of the pin for that of the point of the hole that it touches; these differ by the way of the pin, 2.6 ΔR / R = 0.13 %.
""")
