"""Friction: a block on a slope with a spring, a block that sticks and slips."""
import math

from .contacts import contact
from .mesh import Mesh, even, fields, history, part, smooth, start
from .problem import Problem, Value

SLOPE, GRAVITY, SPRING, FRICTION, YOUNG = math.radians(30), 1e-3, 0.01, 0.3, 10.0


def spring(number, nodes, part_id, stiffness):
    return (f"*SECTION_DISCRETE\n{part_id:10d}\n\n*MAT_SPRING_ELASTIC\n" + fields(part_id, stiffness)
            + part(part_id, part_id, part_id, "spring")
            + f"*ELEMENT_DISCRETE\n{number:8d}{part_id:8d}{nodes[0]:8d}{nodes[1]:8d}\n")


def block_on_plane(count, turned, length, height=1.0):
    """A block of count³ bricks, a unit wide and `height` high, on a rigid sheet; `turned(point)`: where it
    stands. The mesh, and the ids of the block."""
    mesh = Mesh()
    ids = mesh.block(1, even(count), even(count), even(count, 0.0, height), lambda x, y, z: turned((x, y - 0.5, z)))
    mesh.sheet(2, [-length, length], [-2.0, 2.0], lambda x, y: turned((x, y, -0.05)))
    return mesh, ids


def wedge_deck(level, variant):
    cos, sin = math.cos(SLOPE), math.sin(SLOPE)

    def turned(p):
        # x runs up the slope.
        return cos * p[0] - sin * p[2], p[1], sin * p[0] + cos * p[2]

    count = 2 ** (level + 1)
    mesh, ids = block_on_plane(count, turned, 6.0)
    hook = ids[count // 2][count // 2][-1]
    x = mesh.nodes[hook - 1]
    anchor = mesh.add_node((x[0] + 2 * cos, x[1], x[2] + 2 * sin), "xyz", "xyz")
    end = 500.0
    return (start("block on a slope with a spring", "E = 10, density = edge = 1", end, 5.0)
            + history([hook]) + part(1, 1, 1, "block") + part(2, 2, 2, "slope")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*SECTION_SHELL\n" + fields(2, 2) + fields(0.1)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, YOUNG, 0.3) + "*MAT_RIGID\n" + fields(2, 1.0, 100.0, 0.3)
            + fields(1.0, 7, 7) + "\n" + spring(100001, (hook, anchor), 3, SPRING)
            + "*LOAD_BODY_Z\n" + fields(1) + smooth(1, 400.0, GRAVITY)
            + contact(variant, scale=1.0, soft_scale=0.1, friction=(FRICTION, FRICTION, 0.0), damping=20.0)
            + mesh.text() + "*END\n")


def wedge_values(run, level, variant):
    hook = next(iter(run.nodes.values()))
    moved = -math.hypot(hook[-1][0], hook[-1][2])
    force = run.rcforc(1, "A")[-1][1]
    cos, sin = math.cos(SLOPE), math.sin(SLOPE)
    normal, along = cos * force[2] - sin * force[0], cos * force[0] + sin * force[2]
    weight = GRAVITY
    return [Value("way", -moved, weight * (sin - FRICTION * cos) / SPRING),
            Value("friction over normal force", along / normal, FRICTION), Value("normal force", normal, weight * cos)]


WEDGE = Problem(
    "sliding_wedge", "Block on a slope with a spring", """\
A block (edge and density 1, E = 10) on a rigid slope of θ = 30°, friction μ = 0.3, held from above by a spring of k = 0.01. Gravity
grows to g = 0.001, smoothly over the time 400, many periods of the spring; the block slides down until

    k u = m g (sin θ − μ cos θ)

as in the sliding wedge of the NAFEMS contact benchmarks (Feng and Prinja 2001, CGS-4), with the balance of the slope N = m g cos θ,
T = μ N. The block has 2, 4 and 8 bricks along an edge.
""", wedge_deck, wedge_values, ("SOFT 0", "SOFT 1", "SOFT 2", "mortar"))

# Stick and slip -----------------------------------------------------------------------------------------------------

STATIC, MOVING, SPEED, PULL_FROM = 0.4, 0.25, 0.005, 100.0


def stick_slip_deck(level, variant):
    count = 2 ** (level + 1)
    mesh, ids = block_on_plane(count, lambda p: p, 40.0, FLATNESS)
    hook = ids[0][count // 2][count]
    x = mesh.nodes[hook - 1]
    lead = mesh.add_node((x[0] + 2.0, x[1], x[2]), "yz", "xyz")
    end = 1300.0
    return (start("stick and slip", "mass = edge = 1", end, 0.5)
            + history([hook, lead]) + part(1, 1, 1, "block") + part(2, 2, 2, "ground")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*SECTION_SHELL\n" + fields(2, 2) + fields(0.1)
            + "*MAT_RIGID\n" + fields(1, 1.0 / FLATNESS, YOUNG, 0.3) + fields(0.0) + "\n*MAT_RIGID\n" + fields(2, 1.0, 100.0, 0.3)
            + fields(1.0, 7, 7) + "\n" + spring(100001, (hook, lead), 3, PULL)
            + "*LOAD_BODY_Z\n" + fields(1) + smooth(1, 0.8 * PULL_FROM, WEIGHT)
            + f"*ELEMENT_MASS\n  100002{lead:8d}{1e-3:16g}\n"
            + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + fields(lead, 1, 0, 2)
            + "*DEFINE_CURVE\n" + fields(2) + "".join(
                f"{t:20g}{v:20g}\n" for t, v in ((0, 0), (PULL_FROM, 0), (PULL_FROM + 1, SPEED), (1e5, SPEED)))
            + contact(variant, scale=1.0, soft_scale=0.1, friction=(STATIC, MOVING, DECAY), damping=20.0)
            + mesh.text() + "*END\n")


WEIGHT, PULL, DECAY, FLATNESS = 0.01, 1e-3, 1e4, 0.1


def stick_slip_values(run, level, variant):
    block, lead = sorted(run.nodes.values(), key=lambda rows: rows[0][9])
    times = run.times
    force = [PULL * (b[0] - a[0]) for a, b in zip(block, lead)]
    # The first slip: from the greatest force to the next least one.
    top = next(i for i in range(1, len(force) - 1) if times[i] > PULL_FROM and force[i - 1] < force[i] >= force[i + 1]
               and force[i] > 0.9 * STATIC * WEIGHT)
    low = next(i for i in range(top + 1, len(force) - 1) if force[i] <= force[i + 1])
    omega = math.sqrt(PULL)
    half = math.hypot((STATIC - MOVING) * WEIGHT, SPEED * PULL / omega)
    return [Value("greatest force", force[top], MOVING * WEIGHT + half),
            Value("least force", force[low], MOVING * WEIGHT - half),
            Value("time between", times[low] - times[top], math.pi / omega)]


STICK_SLIP = Problem(
    "stick_slip", "Stick and slip", """\
A flat rigid block (1 x 1 x 0.1, mass 1, weight N = 0.01) on a rigid plane is pulled by a spring of k = 0.001 whose end moves with V = 0.005 from
the time 100 on. Friction falls from μs = 0.4 to μd = 0.25 at once when it slides (DC = 10000). While it slides, the force of
the spring is, with ω = √(k / m) and in closed form,

    F = μd N + (μs − μd) N cos ωt + V k/ω sin ωt      so F = μd N ± √(((μs − μd) N)² + (V k/ω)²), π / ω apart

The greatest force at the first slip, the next least one, and the time between them are measured.
""", stick_slip_deck, stick_slip_values, ("SOFT 0", "SOFT 1"), cause="""\
Later slips are not compared: a block that has stopped vibrates on its tangential springs, which nothing damps, and so large a DC
lets it slip before the static limit. SOFT 2 and mortar are left out: where all bodies are rigid, no element limits the step from
which their stiffness follows.
""")
