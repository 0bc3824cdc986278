"""Impacts: of two rods, of a ball on a rigid plate."""
import math

from .contacts import VARIANTS, contact
from .hertz import GAP, PLANE, PLATE, POISSON
from .mesh import Mesh, even, fields, graded, history, part, start
from .problem import Problem, Value

# Rods ---------------------------------------------------------------------------------------------------------------

LENGTH, SIDE, SPEED = 10.0, 0.5, 0.01  # E = density = 1, so c = 1


def rods_deck(level, variant):
    count = 20 * 2 ** level
    mesh = Mesh()
    for number, (first, last) in enumerate(((-LENGTH, 0.0), (0.0, LENGTH)), 1):
        mesh.block(number, even(count, first, last), [0.0, SIDE], [0.0, SIDE], lambda x, y, z: (x, y, z),
                   lambda i, j, k: "yz")
    end = 2.6 * LENGTH
    text = start("impact of two rods", "E = density = 1, length 10", end, 0.05, 0.6)
    return (text + history([1]) + part(1, 1, 1, "first") + part(2, 1, 1, "second") + "*SECTION_SOLID\n" + fields(1, 1)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, 0.0)
            + "*INITIAL_VELOCITY_GENERATION\n" + fields(1, 2, 0.0, SPEED) + "\n"
            + contact(variant, scale=4.0, soft_scale=0.1) + mesh.text() + "*END\n")


def rods_values(run, level, variant):
    force = [(t, abs(f[0])) for t, f in run.rcforc(1, "A")]
    expected = (1 + SPEED / 8) * SPEED / 2 * SIDE ** 2
    middle = [f for t, f in force if 0.5 * LENGTH < t < 1.5 * LENGTH]
    # A contact ends where its force falls to half.
    inside = [t for t, f in force if f > expected / 2]
    impulse = sum(0.5 * (f + g) * (u - t) for (t, f), (u, g) in zip(force, force[1:]))
    return [Value("force", sum(middle) / len(middle), expected), Value("time of contact", max(inside) - min(inside), (1 - SPEED / 8) * 2 * LENGTH),
            Value("exit velocity", impulse / (SIDE ** 2 * LENGTH), SPEED)]


RODS = Problem(
    "rods", "Impact of two rods", """\
A rod (length L = 10, section A = 0.25, E = ρ = 1, ν = 0, so c = 1) hits its equal at rest, end to end, with v = 0.01. In one
dimension (Saint-Venant; Johnson, Contact Mechanics, 1985, section 11.1) the force ρ c v A / 2 acts for 2 L / c; then the first rod
rests and the second one moves on with v. Strains v / 2 c are not infinitely small: with the stress E ln λ of the solver the balance of
momentum of the shock makes force and wave speed 1 + v / 8 c times as large, to the first order. The force is the mean from L / 2 c to 3 L / 2 c, the time of contact that of more than half
of it, the exit velocity the impulse over the mass. The meshes have 20, 40 and 80 bricks along. SFSA = SFSB = 4, SOFSCL = 0.1.
""", rods_deck, rods_values, VARIANTS, cause="""\
The contact spring lets the rods come nearer, so the force begins late and ends late: both by about the time in which a wave
passes a brick, so of order 1. The bulk viscosity smears the fronts over a few bricks.
""")

# Ball ---------------------------------------------------------------------------------------------------------------

RADIUS_OF_CONTACT = 0.15
MASS = 4 / 3 * math.pi


def ball_speed():
    """That makes the greatest approach a²/R: m v²/2 = 8/15 E* √R δ^5/2."""
    return math.sqrt(16 / 15 / PLANE * RADIUS_OF_CONTACT ** 5 / MASS)


def ball_impact_deck(level, variant):
    h = RADIUS_OF_CONTACT / 2 / 2 ** level
    growth = 1.6 ** (1 / 2 ** level)
    fine = graded(h, 0.2, 1.0, growth)
    coarse = graded(4 * h, 0.0, 1.0, growth)
    mesh = Mesh()

    def place(x, y, z):
        most, norm = max(x, y, abs(z)), math.sqrt(x * x + y * y + z * z)
        share = 1 - most + most * most / norm if norm > 0 else 1
        return x * share, y * share, z * share

    heights = [q - 1 for q in fine] + coarse[1:]
    ids = mesh.block(1, fine, fine, heights, place, lambda i, j, k: ("x" if i == 0 else "") + ("y" if j == 0 else ""))
    mesh.sheet(2, [-0.3, 1.3], [-0.3, 1.3], lambda x, y: (x, y, -1.0 - PLATE / 2 - GAP))
    end = 1.6 * contact_time()
    return (start("impact of a ball on a rigid plate (Hertz)", "E = R = density = 1", end, end / 800, 0.6)
            + history([ids[0][0][0], ids[-1][0][0]]) + part(1, 1, 1, "ball") + part(2, 2, 2, "plate")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*SECTION_SHELL\n" + fields(2, 2) + fields(PLATE)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON)
            + "*MAT_RIGID\n" + fields(2, 1.0, 1000.0, 0.3) + fields(1.0, 7, 7) + "\n"
            + f"*INITIAL_VELOCITY_GENERATION\n{1:10d}{2:10d}{0.0:10g}{0.0:10g}{0.0:10g}{-ball_speed():10.6f}\n\n"
            + contact(variant, scale=15.0, soft_scale=0.2) + mesh.text() + "*END\n")


def contact_time():
    """2.943 δ / v (Hertz 1881; Johnson 1985, equation 11.24): 2 ∫ dx / √(1 − x^5/2) from 0 to 1."""
    integral = 2 * math.sqrt(math.pi) * math.gamma(0.4) / (5 * math.gamma(0.9)) * 2
    return integral * RADIUS_OF_CONTACT ** 2 / ball_speed()


def ball_impact_values(run, level, variant):
    force = [(t, 4 * abs(f[2])) for t, f in run.rcforc(1, "A")]
    greatest = max(f for _, f in force)
    inside = [t for t, f in force if f > 0.001 * greatest]
    impulse = sum(0.5 * (f + g) * (u - t) for (t, f), (u, g) in zip(force, force[1:]))
    speed = ball_speed()
    return [Value("greatest force", greatest, 4 / 3 / PLANE * RADIUS_OF_CONTACT ** 3),
            Value("time of contact", max(inside) - min(inside), contact_time()),
            Value("impulse", impulse, 2 * MASS * speed)]


BALL_IMPACT = Problem(
    "ball_impact", "Impact of a ball on a rigid plate", """\
A ball of bricks (a quarter by symmetry; E = R = ρ = 1, ν = 0.3) hits a rigid plate so fast that its greatest approach is δ = a²,
a = 0.15, by Hertz' theory of impact (Hertz 1881; Johnson, Contact Mechanics, 1985, section 11.4):

    ½ m v² = 8/15 E* √R δ^(5/2)      F = 4/3 E* √R δ^(3/2)      T = 4 √π Γ(2/5) / (5 Γ(9/10)) δ / v      J = 2 m v

The meshes have 2 and 4 bricks over the contact radius. SFSA = SFSB = 15, SOFSCL = 0.2.
""", ball_impact_deck, ball_impact_values, VARIANTS, levels=(0, 1), cause="""\
The theory is quasi-static and leaves out the vibrations of the ball. The ball of bricks is a polyhedron inside the ball, so lighter:
its impulse is smaller by that, on the coarse mesh most. Hertz takes the approach from half-spaces; a ball of finite size is stiffer
by a share of order a / R = 0.15, so the stiffest contacts on the finer mesh end above his force and below his time. Soft springs
act the other way.
""")
