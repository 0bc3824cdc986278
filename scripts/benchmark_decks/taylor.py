"""A copper bar that hits a rigid wall."""
import math

from .mesh import Mesh, fields, history, part, start
from .problem import Problem, Value

RADIUS, LENGTH, SPEED = 3.2, 32.4, 227.0  # mm, ms, kg, kN
# Camacho and Ortiz 1997, the middle of what they give.
PUBLISHED_LENGTH, PUBLISHED_RADIUS = 21.43, 7.22


def quarter_disc(count):
    """A quarter of a disc: a square of count² quads from the axis on, and two blocks around it. The points, and of each quad
    its four points."""
    points, known, quads = [], {}, []

    def block(place):
        def corner(i, j):
            point = place(i / count, j / count)
            key = tuple(round(c, 9) for c in point)
            if key not in known:
                known[key] = len(points)
                points.append(point)
            return known[key]
        for j in range(count):
            for i in range(count):
                quads.append([corner(i + a, j + b) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])

    def outwards(r, s):
        """From the side of the square at x = R / 2 (r = 0) to the circle, up to 45°."""
        angle = math.pi / 4 * s
        inner, outer = (RADIUS / 2, RADIUS / 2 * s), (RADIUS * math.cos(angle), RADIUS * math.sin(angle))
        return tuple((1 - r) * a + r * b for a, b in zip(inner, outer))

    block(lambda r, s: (RADIUS / 2 * r, RADIUS / 2 * s))
    block(outwards)
    block(lambda r, s: outwards(s, r)[::-1])
    return points, quads


def taylor_deck(level, variant):
    """A quarter of the bar; the wall is z = 0."""
    points, quads = quarter_disc(2 ** level)
    layers, mesh = 20 * 2 ** level, Mesh()
    for k in range(layers + 1):
        for x, y in points:
            mesh.add_node((x, y, LENGTH * k / layers), ("x" if x < 1e-9 else "") + ("y" if y < 1e-9 else ""))
    each = len(points)
    mesh.elements["SOLID"] = [(1, [1 + n + each * (k + c) for c in (0, 1) for n in quad])
                              for k in range(layers) for quad in quads]
    axis, rim = points.index((0.0, 0.0)) + 1, max(range(each), key=lambda n: points[n][0]) + 1
    return (start("Taylor bar, copper, 227 m/s", "mm, ms, kg, kN", 0.08, 0.001, hourglass=0)
            + history([axis, axis + each * layers, rim]) + part(1, 1, 1, "bar")
            + "*SECTION_SOLID\n" + fields(1, int(variant.split()[1]))
            + "*MAT_PLASTIC_KINEMATIC\n" + fields(1, "8.93E-6", 117.0, 0.35, 0.4, 0.1, 1.0) + "\n"
            + "*RIGIDWALL_PLANAR\n" + fields(0) + fields(0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)
            + "*INITIAL_VELOCITY_GENERATION\n" + fields(1, 2, 0.0, 0.0, 0.0, -SPEED) + "\n" + mesh.text() + "*END\n")


def taylor_values(run, level, variant):
    rim, *axis = sorted(run.nodes.values(), key=lambda rows: -rows[0][9])
    foot, top = sorted(axis, key=lambda rows: rows[0][11])
    return [Value("length", top[-1][11] - foot[-1][11], PUBLISHED_LENGTH),
            Value("radius of the foot", rim[-1][9], PUBLISHED_RADIUS)]


TAYLOR = Problem(
    "taylor_bar", "Taylor bar", """\
A copper bar, 32.4 mm long, with a radius of 3.2 mm, a quarter by symmetry, hits a frictionless rigid wall at 227 m/s (E = 117 GPa,
ν = 0.35, yield stress 400 MPa, hardening 100 MPa, 8930 kg/m³). After 80 µs it rests. There is no closed form; published
calculations, as commonly quoted, in mm:

| | length | radius of the foot |
|---|---:|---:|
| Kamoulakos 1990 | 21.47 to 21.66 | 7.02 to 7.12 |
| Zhu and Cescotto 1995 | 21.26 to 21.49 | 6.97 to 7.18 |
| Camacho and Ortiz 1997 | 21.42 to 21.44 | 7.21 to 7.24 |

The reference is the middle of the last row, whose meshes were refined during the run. The meshes have 2, 4 and 8 bricks over the
radius and 20, 40 and 80 along. The energy ratio leaves out the work of the bulk viscosity, as LS-DYNA's does.
""", taylor_deck, taylor_values, ("ELFORM 1", "ELFORM 2", "ELFORM -1"), column="solids", finest={"ELFORM 2": 1, "ELFORM -1": 1}, cause="""\
All come near the published length from above: coarse meshes are too stiff for the foot to spread. ELFORM 1 has the smallest radius on the
coarse mesh, where its hourglass forces hold the rim back. The finest mesh is left to ELFORM 1: eight points take three times as
long. Between the published calculations themselves are 2 % in length and 4 % in radius.
""")
