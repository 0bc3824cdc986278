"""A rigid punch with rounded edges on an elastic half-plane."""
import math

from .contacts import VARIANTS, contact
from .mesh import Mesh, fields, graded, history, part, segment_set, smooth, start
from .problem import Problem, Value

POISSON, PLANE = 0.3, 1 - 0.3 ** 2
FLAT, ROUND, SIZE, PLATE = 0.5, 40.0, 8.0, 0.1


def angle_of(load):
    """sin φ₀ = a / b of a load per length over E*: 2 P R / E* a² = (π − 2 φ₀) / 2 sin² φ₀ − cot φ₀."""
    low, high = 0.01, math.pi / 2 - 0.01
    for _ in range(60):
        middle = (low + high) / 2
        value = (math.pi - 2 * middle) / (2 * math.sin(middle) ** 2) - 1 / math.tan(middle)
        low, high = (middle, high) if value > 2 * load * ROUND / FLAT ** 2 else (low, middle)
    return low


def pressure(share, first):
    """b p / P at x = b · share (Ciavarella, Hills and Monno 1998)."""
    phi = math.asin(min(share, 1.0))
    if abs(phi - first) < 1e-9:
        phi += 1e-6
    term = (math.sin(phi) * math.log(abs(math.sin(phi + first) / math.sin(phi - first)))
            + math.sin(first) * math.log(abs(math.tan((phi + first) / 2) * math.tan((phi - first) / 2))))
    return (2 / math.pi) / (math.pi - 2 * first - math.sin(2 * first)) * ((math.pi - 2 * first) * math.cos(phi) + term)


def punch_deck(level, variant):
    h = 1 / 5 / 2 ** level
    growth = 1.45 ** (1 / 2 ** level)
    down = graded(h, 1.2, SIZE, growth)
    across, mesh = [-q for q in reversed(down[1:])] + down, Mesh()
    middle = len(down) - 1
    ids = mesh.block(1, across, [0.0, h], [-q for q in reversed(down)], lambda x, y, z: (x, y, z),
                     lambda i, j, k: ("x" if i == middle else "") + "y" + ("z" if k == 0 else ""))
    side = [0.05 * i for i in range(1, 11)] + [FLAT + 0.025 * i for i in range(1, 49)]
    facets = [-q for q in reversed(side)] + side
    sheet = mesh.sheet(2, facets, [-h, 2 * h],
                       lambda x, y: (x, y, PLATE / 2 + max(0.0, abs(x) - FLAT) ** 2 / (2 * ROUND)))
    return (start("punch with rounded edges on a half-plane", "E = density = 1, plane strain", 45.0, 2.0, 0.4)
            + history([sheet[0][0], ids[-1][0][middle]]) + part(1, 1, 1, "half-plane") + part(2, 2, 2, "punch")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*SECTION_SHELL\n" + fields(2, 2) + fields(PLATE)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON)
            + "*MAT_RIGID\n" + fields(2, 100.0, 100.0, 0.3) + fields(1.0, 4, 7) + "\n"
            + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n" + fields(2, 3, 2, 1) + smooth(1, 30.0, -0.016)
            + "*DAMPING_GLOBAL\n" + fields(0, 0.3) + segment_set(1, ids[-1])
            + contact(variant, kinds=(0, 3), scale=40.0, soft_scale=1.0, segment_scale=20.0, depth=h / 10) + mesh.text() + "*END\n")


def punch_values(run, level, variant):
    width = 1 / 5 / 2 ** level
    found = run.pressures(1, lambda p: abs(p[2]) < 1e-9).values()
    load = -sum(force[2] for _, force, _ in found) / width
    first = angle_of(load * PLANE)
    half = FLAT / math.sin(first)
    spread = math.sqrt(sum(force[2] * x * x for (x, _, _), force, _ in found) / sum(force[2] for _, force, _ in found))
    steps = [(i + 0.5) / 4000 for i in range(4000)]
    shape = [pressure(q, first) for q in steps]
    ideal = half * math.sqrt(sum(p * q * q for p, q in zip(shape, steps)) / sum(shape))
    middle = sum(p for (x, _, _), _, p in found if abs(x) < 1e-9) / 2
    return [Value("spread of the pressure", spread, ideal),
            Value("pressure in the middle", middle, load / half * pressure(0, first)),
            Value("greatest pressure", max(p for _, _, p in found), load / half * max(shape))]


PUNCH = Problem(
    "punch", "Punch with rounded edges", """\
A rigid punch, flat over 2 a = 1 and rounded beyond by parabolas of the radius R = 40, on an elastic half-plane (E = 1, ν = 0.3; a
block of 16 x 8 in plane strain, held below). It moves down by 0.016, smoothly over the time 30, damped, and stays until
45. With the load P per length (Ciavarella, Hills and Monno, J. Mech. Eng. Sci. 212, 1998), sin φ₀ = a / b, x = b sin φ:

    2 P R / E* a² = (π − 2 φ₀) / 2 sin² φ₀ − cot φ₀      E* = E / (1 − ν²)

    b p / P = 2/π / (π − 2 φ₀ − sin 2 φ₀) · ((π − 2 φ₀) cos φ + sin φ ln |sin(φ + φ₀) / sin(φ − φ₀)| + sin φ₀ ln |tan((φ + φ₀)/2) tan((φ − φ₀)/2)|)

The spread is √(∫ p x² / ∫ p). The meshes have squares of 1/5, 1/10 and 1/20 under the punch. The contact is that of the segments of the
surface. SOFT 0: SFSA = SFSB = 40, SOFT 1: SOFSCL = 1, SOFT 2: SFSA = SFSB = 20, mortar: SFSA = SFSB = 40 and PENMAX a tenth of a brick.
""", punch_deck, punch_values, VARIANTS, cause="""\
The greatest pressure is a narrow peak beside the end of the flat, which a node averages over an edge. The springs are an elastic layer
between the bodies, which evens the pressure out, with order 1. Both are held whole, so no node has half a share of the surface and a
whole spring.
""")
