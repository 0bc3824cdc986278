"""Impact of two rods."""
from .contacts import VARIANTS, contact
from .mesh import Mesh, even, fields, history, part, segment_set, start
from .problem import Problem, Value

LENGTH, SIDE, SPEED = 10.0, 0.5, 0.01  # E = density = 1, so c = 1


def duration(force):
    """How long there is a force [(time, size)], from the first sample with one to the first one behind the middle of the contact
    without; ends lie on the line through the two samples beside them."""
    def zero(near, far):
        (t, f), (u, g) = near, far
        return t - f * (u - t) / (g - f) if g > f else t
    first = next(i for i, (_, f) in enumerate(force) if f > 0)
    end = next(i for i, (t, f) in enumerate(force) if t > LENGTH and f <= 0)
    # No later than the sample without force, no earlier than the last one without.
    begin = max(zero(force[first], force[first + 1]), force[first - 1][0]) if first > 0 else force[0][0]
    return min(zero(force[end - 1], force[end - 2]), force[end][0]) - begin


def rods_deck(level, variant):
    count, ends = 20 * 2 ** level, []
    mesh = Mesh()
    for number, (first, last) in enumerate(((-LENGTH, 0.0), (0.0, LENGTH)), 1):
        ids = mesh.block(number, even(count, first, last), [0.0, SIDE], [0.0, SIDE], lambda x, y, z: (x, y, z),
                         lambda i, j, k: "yz")
        ends.append([[row[-1] for row in layer] for layer in ids] if number == 1 else [[row[0] for row in layer][::-1] for layer in ids])
    end = 2.6 * LENGTH
    text = start("impact of two rods", "E = density = 1, length 10", end, 0.05, 0.6)
    return (text + history([1]) + part(1, 1, 1, "first") + part(2, 1, 1, "second") + "*SECTION_SOLID\n" + fields(1, 1)
            + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, 0.0)
            + "*INITIAL_VELOCITY_GENERATION\n" + fields(1, 2, 0.0, SPEED) + "\n" + segment_set(1, ends[0]) + segment_set(2, ends[1])
            + contact(variant, kinds=(0, 0), scale=4.0, soft_scale=0.4, depth=LENGTH / count / 10) + mesh.text() + "*END\n")


def rods_values(run, level, variant):
    force = [(t, abs(f[0])) for t, f in run.rcforc(1, "A")]
    expected = (1 + SPEED / 8) * SPEED / 2 * SIDE ** 2
    middle = [f for t, f in force if 0.5 * LENGTH < t < 1.5 * LENGTH]
    impulse = sum(0.5 * (f + g) * (u - t) for (t, f), (u, g) in zip(force, force[1:]))
    return [Value("force", sum(middle) / len(middle), expected),
            Value("time of contact", duration(force), (1 - SPEED / 8) * 2 * LENGTH),
            Value("exit velocity", impulse / (SIDE ** 2 * LENGTH), SPEED)]


RODS = Problem(
    "rods", "Impact of two rods", """\
A rod (length L = 10, section A = 0.25, E = ρ = 1, ν = 0, so c = 1) hits its equal at rest, end to end, with v = 0.01. In one
dimension (Saint-Venant; Johnson, Contact Mechanics, 1985, section 11.1) the force ρ c v A / 2 acts for 2 L / c; then the first rod
rests and the second one moves on with v. Strains v / 2 c are not infinitely small: with the stress E ln λ of the solver the balance of
momentum of the shock makes force and wave speed 1 + v / 8 c times as large, to the first order. The force is the mean from L / 2 c to
3 L / 2 c; the time of contact ends when there is no force any more; the exit velocity is the impulse over the mass. The meshes have 20, 40, 80 and 160
bricks along. The contact is that of the segments of both ends. SFSA = SFSB = 4, SOFSCL = 0.4; mortar: PENMAX a tenth of a brick.
""", rods_deck, rods_values, VARIANTS, levels=(0, 1, 2, 3), cause="""\
Both fronts that come back from the free ends unload the contact, so its force is zero when half of each has arrived, at 2 L / c
however much they are smeared; but half of the force is left when only a quarter has, which is too early by an amount of order 1/2. What the fronts
bring later is lost, a part of the exit velocity: order 1/2 (see the [rod on a wall](wall_rod.md)). The contact springs need time to
unload, so contact lasts too long by about the time in which a wave passes a brick: order 1.
""")
