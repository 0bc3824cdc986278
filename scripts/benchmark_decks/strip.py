"""An elastic strip that buckles between two rigid plates."""
import math

from .contacts import VARIANTS, contact
from .mesh import Mesh, curve, even, fields, history, node_set, part, start
from .problem import Problem, Value

LENGTH, THICKNESS, GAP, PLATE = 1.0, 0.004, 0.01, 0.02  # E = density = 1, width of a shell
STIFFNESS = THICKNESS ** 3 / 12  # E I of a unit of width, no lateral strain
EULER = math.pi ** 2 * STIFFNESS / LENGTH ** 2
POINT, LINE = 2.5, 1 / 0.35 ** 2  # loads over Euler's; with the second one the line begins at 0.35, at a node of each mesh
STAGE = 700.0


def point_contact(load):
    """Shortening of the whole strip and force on the plate, of a load over Euler's between 1 and 4. With k² = P / E I and θ = k L / 2 half
    of the strip is w = a (sin k x − k x cos θ), w(L / 2) = h."""
    theta = math.pi / 2 * math.sqrt(load)
    k = 2 * theta / LENGTH
    a = GAP / (math.sin(theta) - theta * math.cos(theta))
    slopes = a * a * k * (theta / 2 + math.sin(2 * theta) / 4 - math.sin(2 * theta) + theta * math.cos(theta) ** 2)
    return load * EULER * LENGTH / THICKNESS + slopes, -2 * load * EULER * a * k * math.cos(theta)


def line_contact(load):
    """Shortening of the whole strip, force on the plate and length of the line, of a load over Euler's between 4 and 16. The
    ends are w = h (x / l + sin(π x / l) / π) with P l² = π² E I: neither slope nor moment where the line begins."""
    end = LENGTH / math.sqrt(load)
    return load * EULER * LENGTH / THICKNESS + 1.5 * GAP ** 2 / end, 2 * load * EULER * GAP / end, LENGTH - 2 * end


def motion(number):
    """Half of the first shortening, a rest, half of the second one, a rest; each a STAGE long."""
    first, last = point_contact(POINT)[0] / 2, line_contact(LINE)[0] / 2
    points = [(0.0, 0.0)]
    for begin, low, high in ((0, 0.0, first), (2, first, last)):
        points += [((begin + q) * STAGE, low + (high - low) * q ** 3 * (10 - 15 * q + 6 * q * q)) for q in even(40)[1:]]
        points.append(((begin + 2) * STAGE, high))
    return curve(number, points)


def edge(level):
    return LENGTH / 2 / (10 * 2 ** level)


def strip_deck(level, variant):
    """Half of the strip, from its hinge to its middle; the hinge moves. Shells of ELFORM 2 where the variant names no other."""
    count, width, mesh = 10 * 2 ** level, edge(level), Mesh()
    soft, _, shell = variant.partition(", ELFORM ")
    # No lateral strain: nodes turn about y only, those in the middle not at all.
    strip = mesh.sheet(1, even(count, 0.0, LENGTH / 2), [0.0, width], lambda x, y: (x, y, 0.0),
                       lambda i, j: "yz" if i == 0 else "xy" if i == count else "y",
                       lambda i, j: "xyz" if i == count else "xz")
    for side in (-1, 1):
        mesh.sheet(2, [-0.1, LENGTH / 2 + 0.1], [-width, 2 * width],
                   lambda x, y: (x, y, side * (GAP + THICKNESS / 2 + PLATE / 2)))
    # A force on the middle while the strip begins to buckle says to which side; it would bend the strip by h / 20.
    push = 48 * STIFFNESS * width * GAP / 20 / LENGTH ** 3 / 2 / 2
    return (start("strip between two plates (constrained Euler buckling)", "E = density = 1, no lateral strain", 4 * STAGE, 10.0, 0.6)
            + f"*DATABASE_BNDOUT\n{10.0:10g}\n" + history([strip[0][0], strip[0][-1]])
            + part(1, 1, 1, "strip") + part(2, 2, 2, "plates")
            + "*SECTION_SHELL\n" + fields(1, int(shell or 2), None, 2) + fields(THICKNESS) + "*SECTION_SHELL\n" + fields(2, 2) + fields(PLATE)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, 0.0) + "*MAT_RIGID\n" + fields(2, 1.0, 1.0, 0.3)
            + fields(1.0, 7, 7) + "\n" + node_set(1, (row[0] for row in strip)) + node_set(2, (row[-1] for row in strip))
            + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 1, 2, 1) + motion(1)
            + "*LOAD_NODE_SET\n" + fields(2, 3, 2)
            + curve(2, [(0.0, push), (0.5 * STAGE, push), (0.6 * STAGE, 0.0), (100 * STAGE, 0.0)])
            + "*DAMPING_GLOBAL\n" + fields(0, 0.02) + contact(soft, scale=20.0 if soft == "mortar" else 1.0, soft_scale=1.0) + mesh.text() + "*END\n")


def strip_values(run, level, variant):
    width, strip = edge(level), {n for corners in run.shells_of(1) for n in corners}
    ends = [n for n, p in run.points().items() if n in strip and p[0] == 0.0]

    def rest(rows, end):
        """The mean over the last fifth of a rest, for a unit of width."""
        inside = [f for t, f in rows if end - 0.2 * STAGE < t <= end]
        return sum(inside) / len(inside) / width
    load = run.bndout(ends, "x")
    push = [(t, abs(f[2])) for t, f in run.rcforc(1, "A")]
    # By the places of the nodes along the strip at the start, as the theory of small deflections has it.
    forces = [(run.points()[f.node][0], abs(f.force[2])) for f in run.node_forces() if f.node in strip]
    begin = sum(x * f for x, f in forces) / sum(f for _, f in forces)
    return [Value("load, point", rest(load, 2 * STAGE) / EULER, POINT),
            Value("force on the plate, point", 2 * rest(push, 2 * STAGE) / EULER, point_contact(POINT)[1] / EULER),
            Value("load, line", rest(load, 4 * STAGE) / EULER, LINE),
            Value("force on the plate, line", 2 * rest(push, 4 * STAGE) / EULER, line_contact(LINE)[1] / EULER),
            Value("length of the line", LENGTH - 2 * begin, line_contact(LINE)[2])]


STRIP = Problem(
    "strip", "Strip that buckles between two plates", f"""\
An elastic strip (E = ρ = 1, ν = 0, length L = 1, thickness 0.004; half of it by symmetry) with a hinge at each end lies midway between
two rigid, frictionless plates, which leave it the way h = L / 100 to either side. Its ends come nearer, slowly and damped, and rest twice.
It buckles at Euler's load, then touches one plate at a point, and from four times that load on along a line (V. I. Feodosyev, Strength of
Materials, 1968; G. Domokos, P. Holmes and B. Royce, J. Nonlinear Sci. 7, 1997; P. Holmes et al., Comput. Methods Appl. Mech. Engrg. 170,
1999). Small deflections w, E I w'''' + P w'' = 0, have a closed form, with P_E = π² E I / L²:

    point:  k² = P / E I, θ = k L / 2, w = a (sin k x − k x cos θ), a = h / (sin θ − θ cos θ), x from the hinge to L / 2
            shortening P L / E A + a² k (θ / 2 − ¾ sin 2 θ + θ cos² θ), force on the plate −2 P a k cos θ

    line:   l² = π² E I / P, w = h (x / l + sin(π x / l) / π), x from the hinge to l
            shortening P L / E A + 3 h² / 2 l, force on the plate 2 P h / l, half at each end of the line; length of the line L − 2 l

The line begins with P = 4 P_E; at 16 P_E it buckles itself. `check_benchmark_references.py` solves both cases once more by finite
differences. The shortenings are those of P = {POINT} P_E and of l = 0.35 L, P = {LINE:.3f} P_E. A small force on the middle, which
vanishes while the strip is still moving, says to which side it buckles. The table has P / P_E by bndout, the force on the plate over P_E by rcforc,
and L − 2 l with l = Σ F x / Σ F of ncforc. Shells of ELFORM 2 where nothing else is said; the meshes have 10, 20 and 40 along half of
the strip. SFSA = SFSB = 1 (mortar: 20), SOFSCL = 1.
""", strip_deck, strip_values, VARIANTS + ("SOFT 1, ELFORM 16",), cause="""\
Straight shells are too stiff in bending between their nodes, with order 2, and so is the polygon of nodes that touches the plate. On the coarse
meshes one node carries all of the force at the end of the line, so its length is a whole number of edges. With mortar contact the force acts on both
shells beside the node.
""")
