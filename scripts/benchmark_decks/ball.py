"""Hertz: a ball on a rigid plate, at rest and in an impact. The model is a quarter of the ball, one brick wide around."""
import math

from .contacts import VARIANTS, contact
from .mesh import Mesh, fields, graded, history, node_set, part, segment_set, smooth, start
from .problem import Problem, Value

POISSON = 0.3
PLANE = 1 - POISSON ** 2  # E* = E / PLANE beside a rigid body; E = R = density = 1
PLATE, GAP = 0.02, 1e-5
SCALE, SOFT_SCALE, SEGMENT_SCALE, FACTOR = 50.0, 1.0, 20.0, 0.4
PUSHED, END, HOURGLASS = 3.0, 4.5, 0.002
WHOLE = math.pi  # of Mesh.quarter, a triangle in place of a quarter of a circle


def radius_of(point):
    """A point of the plane midway between the planes of symmetry."""
    return math.hypot(point[0], point[1]) / math.sqrt(2)



def on_ball(x, z):
    """Maps the square onto the disc: the rim moves all the way, the middle stays."""
    most, norm = max(x, abs(z)), math.hypot(x, z)
    share = 1 - most + most * most / norm if norm > 0 else 1
    return x * share, z * share


def plate_and_ball(mesh, ids, variant, h):
    """Parts 1 and 2, the plate as a sheet below, and their contact: of the segments of the lower half of the ball, since
    the faces in the planes of symmetry would give their nodes softer springs."""
    mesh.sheet(2, [-0.2, 1.6], [-0.2, 1.6], lambda x, y: (x, y, -1.0 - PLATE / 2 - GAP))
    return (part(1, 1, 1, "ball") + part(2, 2, 2, "plate") + "*SECTION_SOLID\n" + fields(1, 1)
            + "*SECTION_SHELL\n" + fields(2, 2) + fields(PLATE) + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON)
            + "*MAT_RIGID\n" + fields(2, 100.0, 1000.0, 0.3) + fields(1.0, 7, 7) + "\n"
            + segment_set(1, list(zip(ids[1][0], ids[0][0]))[::-1]) + contact(variant, kinds=(0, 3), scale=SCALE, soft_scale=SOFT_SCALE, segment_scale=SEGMENT_SCALE,
                      depth=h / 10))


# At rest ------------------------------------------------------------------------------------------------------------

RADIUS_OF_CONTACT = 0.04  # by the approach a²/R


def ball_deck(level, variant):
    """Half of the ball, its equator pushed towards the plate below."""
    h = RADIUS_OF_CONTACT / 2 / 2 ** level
    across = graded(h, 1.5 * RADIUS_OF_CONTACT, 1.0, 1.8 ** (1 / 2 ** level))
    mesh = Mesh()
    ids = mesh.quarter(1, across, [q - 1 for q in across[:-1]] + [0.0], on_ball)
    axis = [row[0] for row in ids[0]]
    equator = sorted({n for side in ids for n in side[-1]})
    depth = min(axis, key=lambda n: abs(mesh.nodes[n - 1][2] + 1 - 2 * RADIUS_OF_CONTACT))
    bodies = plate_and_ball(mesh, ids, variant, h)
    return (start("ball on a rigid plate (Hertz)", "E = R = density = 1", END, 0.5, FACTOR, hourglass=HOURGLASS)
            + history([axis[0], depth]) + bodies + node_set(1, equator) + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 3, 2, 1)
            + smooth(1, PUSHED, -RADIUS_OF_CONTACT ** 2 - GAP) + "*DAMPING_GLOBAL\n" + fields(0, 1.5)
            + mesh.text() + "*END\n")


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


def peak_pressure(found, a):
    """The peak pressure of Hertz' distribution with the force that the nodes within half of its radius carry."""
    inner = [(force[2], area * math.sqrt(1 - (radius_of(p) / a) ** 2)) for p, force, area in found if radius_of(p) < a / 2]
    return sum(f for f, _ in inner) / sum(w for _, w in inner)


def ball_values(run, level, variant):
    found = run.shares(1, lambda p: math.hypot(radius_of(p), p[2]) > 1 - 1e-6).values()
    total = sum(force[2] for _, force, _ in found)
    # Σ F r² / Σ F = 2/5 a² for Hertz' pressure.
    radius = math.sqrt(2.5 * sum(force[2] * radius_of(p) ** 2 for p, force, _ in found) / total)
    ideal = (0.75 * PLANE * WHOLE * total) ** (1 / 3)
    peak = 1.5 * WHOLE * total / (math.pi * ideal ** 2)
    pole, inside = sorted(run.nodes.values(), key=lambda rows: rows[0][11])
    short = (pole[-1][2] - inside[-1][2])
    depth = inside[0][11] - pole[0][11]
    return [Value("contact radius", radius, ideal), Value("peak pressure", peak_pressure(found, ideal), peak),
            Value("shortening", short, hertz_shortening(depth, ideal, peak))]


BALL = Problem(
    "hertz_ball", "Hertz: ball on a rigid plate", """\
A ball (E = R = ρ = 1, ν = 0.3) is pressed against a rigid plate by its equator: smoothly over the time 3, damped, and held
until 4.5. With the force F that the plate then carries (Hertz 1881; Johnson, Contact Mechanics, 1985):

    a³ = 3 F R / 4 E*      p₀ = 3 F / 2 π a²      E* = E / (1 − ν²)

A quarter of the ball is one brick wide around: the one point of each brick lies in the plane midway between
the planes of symmetry, where the section is that of the ball, so a two-dimensional mesh is enough. These bricks are long across the
section; hourglass stiffness would resist every radial motion that is not proportional to the radius, so its coefficient is 0.002
(with 0.1 a thick-walled cylinder is 4 % off at its rim on any mesh). The nominal contact radius is 0.04, so that neither the size of the
ball nor strains of p₀ / E = 0.028 matter. It is measured by the forces on the nodes, Σ F r² / Σ F = 2/5 a²; p₀ by the force
that the nodes within a / 2 carry, over ∫ √(1 − r²/a²) dA; both where the nodes are at the end, since the surface shrinks by
(1 − 2 ν)(1 + ν) p / E. The shortening is that of the axis down to a depth of about 2 a, against the strains of Hertz' stresses
(Johnson, equation 3.45). The meshes have 2, 4 and 8 bricks over the contact radius. The contact is that of the segments of
the ball's lower half. SOFT 0: SFSA = SFSB = 50, SOFT 1: SOFSCL = 1, SOFT 2: SFSA = SFSB = 20, mortar: SFSA = SFSB = 50 and PENMAX a tenth of
a brick; TSSFAC = 0.4.
""", ball_deck, ball_values, VARIANTS, cause="""\
The springs are an elastic layer between the bodies, which spreads the pressure; its thickness falls with the edges. Mortar contact
may use what the step leaves of the bound of stability, which for these bricks is little above TSSFAC = 0.5
([mortar](../solver-mortar.md#pressure)). The moment of the forces weighs the nodes at the rim most, where the pressure has its steepest
slope.
""")

# Impact -------------------------------------------------------------------------------------------------------------

IMPACT_RADIUS = 0.03
MASS = 4 / 3 * math.pi


def ball_speed():
    """The velocity with which the greatest approach is a²/R: m v²/2 = 8/15 E* √R δ^5/2."""
    return math.sqrt(16 / 15 / PLANE * IMPACT_RADIUS ** 5 / MASS)


def ball_impact_deck(level, variant):
    h = IMPACT_RADIUS / 2 ** level
    growth = 1.7 ** (1 / 2 ** level)
    fine = graded(h, 1.5 * IMPACT_RADIUS, 1.0, growth)
    coarse = graded(0.25 / 2 ** level, 0.0, 1.0, growth)
    mesh = Mesh()
    ids = mesh.quarter(1, fine, [q - 1 for q in fine[:-1]] + coarse, on_ball)
    bodies = plate_and_ball(mesh, ids, variant, h)
    end = 1.08 * contact_time()
    return (start("impact of a ball on a rigid plate (Hertz)", "E = R = density = 1", end, end / 800, FACTOR, hourglass=HOURGLASS)
            + history([ids[0][0][0], ids[0][-1][0]]) + bodies
            + f"*INITIAL_VELOCITY_GENERATION\n{1:10d}{2:10d}{0.0:10g}{0.0:10g}{0.0:10g}{-ball_speed():10.7f}\n\n"
            + mesh.text() + "*END\n")


def contact_time():
    """2.943 δ / v (Hertz 1881; Johnson 1985, equation 11.24): 2 ∫ dx / √(1 − x^5/2) from 0 to 1."""
    integral = 2 * math.sqrt(math.pi) * math.gamma(0.4) / (5 * math.gamma(0.9)) * 2
    return integral * IMPACT_RADIUS ** 2 / ball_speed()


def spread(force):
    """√(∫ F (t − m)² dt / ∫ F dt) of a force [(time, size)] with the mean m = ∫ F t dt / ∫ F dt."""
    moments = [sum(0.5 * (f * t ** k + g * u ** k) * (u - t) for (t, f), (u, g) in zip(force, force[1:])) for k in range(3)]
    mean = moments[1] / moments[0]
    return math.sqrt(moments[2] / moments[0] - mean * mean)


def hertz_spread():
    """Of Hertz' force: x'' = −5/4 x^(3/2) from x = 1 at rest, the approach over its greatest, in times of δ / v; over the time of
    contact."""
    step, x, v, t, rows = 1e-3, 1.0, 0.0, 0.0, []
    while x > 0:
        rows.append((t, x ** 1.5))
        v -= step / (2 if t == 0 else 1) * 1.25 * x ** 1.5
        t, x = t + step, x + step * v
    return spread([(-t, f) for t, f in rows[:0:-1]] + rows) * IMPACT_RADIUS ** 2 / ball_speed() / contact_time()


def ball_impact_values(run, level, variant):
    force = [(t, WHOLE * abs(f[2])) for t, f in run.rcforc(1, "A")]
    impulse = sum(0.5 * (f + g) * (u - t) for (t, f), (u, g) in zip(force, force[1:]))
    return [Value("greatest force", max(f for _, f in force), 4 / 3 / PLANE * IMPACT_RADIUS ** 3),
            Value("time of contact", spread(force) / hertz_spread(), contact_time()),
            Value("impulse", impulse, 2 * MASS * ball_speed())]


BALL_IMPACT = Problem(
    "ball_impact", "Impact of a ball on a rigid plate", """\
A ball (E = R = ρ = 1, ν = 0.3) hits a rigid plate so fast that its greatest approach is δ = a²,
a = 0.03, by Hertz' theory of impact (Hertz 1881; Johnson, Contact Mechanics, 1985, section 11.4):

    ½ m v² = 8/15 E* √R δ^(5/2)      F = 4/3 E* √R δ^(3/2)      T = 4 √π Γ(2/5) / (5 Γ(9/10)) δ / v      J = 2 m v

The mesh is made as that of the [ball at rest](hertz_ball.md), with 1, 2 and 4 bricks over the contact radius; contacts and
factors are the same. The time of contact is that of Hertz' force with the same second moment, √(∫ F (t − m)² / ∫ F) = 0.1941 T with the mean m:
the last sample with a force would depend on the vibrations of the surface when it leaves, and does not see that a coarse ball has a narrower
force.
""", ball_impact_deck, ball_impact_values, VARIANTS, cause="""\
Hertz takes the approach from half-spaces. The middle of a ball is not infinitely far away: its approach is smaller by
F / (π E* R) at most, a share 4 a / 3 π R = 1.3 % of δ. A contact that is stiffer by that has a force about ¾ as much larger and a time of contact
as much shorter; both remain with any mesh, and fall with a. Coarse bricks are too stiff where the ball touches: the force is too
large and narrow, nearly with order 2. The ball of bricks is a polyhedron inside the ball, so lighter: its
impulse is smaller by that, of order 2.
""")
