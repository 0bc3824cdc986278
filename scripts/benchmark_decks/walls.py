"""A rod that hits a rigid wall, or a rigid plate in contact."""
from .contacts import VARIANTS, contact
from .mesh import Mesh, even, fields, history, part, segment_set, start
from .problem import Problem, Value
from .rods import LENGTH, SIDE, SPEED, duration

THICKNESS = 0.1
WALL, SPRINGS = "wall", "wall, springs"


def stop(level, variant):
    """The cards of what stops the rod at x = 0. RWKSF: as stiff beside the bricks on each mesh."""
    factor = 40.0 * 2 ** (4 / 3 * (level - 3)) if variant == SPRINGS else None
    if variant in VARIANTS:
        return ("*SECTION_SHELL\n" + fields(2, 2) + fields(THICKNESS) + "*MAT_RIGID\n" + fields(2, 1.0, 1000.0, 0.3)
                + fields(1.0, 7, 7) + "\n" + part(2, 2, 2, "plate") + contact(variant, kinds=(0, 3), scale=4.0, soft_scale=0.4,
                                                                                   depth=LENGTH / (20 * 2 ** level) / 10))
    # RWPNAL < 0: springs stop all nodes. OFFSET, BIRTH and DEATH are blank; RWKSF is the stiffness beside RWPNAL.
    return (("*CONTROL_CONTACT\n" + fields(None, -1.0) if variant == SPRINGS else "")
            + "*RIGIDWALL_PLANAR\n" + fields(0, 0, 0, 0.0, 0.0, None, factor)
            + fields(0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0))


def wall_deck(level, variant):
    across, mesh = even(min(2 ** level, 2), 0.0, SIDE), Mesh()
    rod = mesh.block(1, even(20 * 2 ** level, -LENGTH, 0.0), across, across, lambda x, y, z: (x, y, z),
                     lambda i, j, k: "yz")
    if variant in VARIANTS:
        mesh.sheet(2, [-SIDE, 2 * SIDE], [-SIDE, 2 * SIDE], lambda y, z: (THICKNESS / 2, y, z))
    end = 3.5 * LENGTH
    return (start("rod on a rigid wall", "E = density = 1, length 10", end, 0.02, 0.6)
            + f"*DATABASE_RWFORC\n{0.02:10g}\n" + history(rod[0][0]) + part(1, 1, 1, "rod")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, 0.0)
            + "*INITIAL_VELOCITY_GENERATION\n" + fields(1, 2, 0.0, SPEED) + "\n" + stop(level, variant)
            + segment_set(1, [[row[-1] for row in layer] for layer in rod]) + mesh.text() + "*END\n")


def wall_values(run, level, variant):
    force = run.rwforc(1) if variant not in VARIANTS else [(t, abs(f[0])) for t, f in run.rcforc(1, "A")]
    expected = (1 + SPEED / 4) * SPEED * SIDE ** 2
    middle = [f for t, f in force if 0.5 * LENGTH < t < 1.5 * LENGTH]
    # Speeds of the nodes along, those at the ends with half of a brick's mass.
    last = [rows[-1][3] for _, rows in sorted(run.nodes.items())]
    speed = (sum(last) - (last[0] + last[-1]) / 2) / (len(last) - 1)
    return [Value("rebound", -speed, SPEED), Value("force", sum(middle) / len(middle), expected),
            Value("time of contact", duration(force), (1 - SPEED / 4) * 2 * LENGTH)]


WALL_ROD = Problem(
    "wall_rod", "Rod on a rigid wall", """\
A rod (length L = 10, section A = 0.25, E = ρ = 1, ν = 0, so c = 1) hits a rigid wall, end to end, with v = 0.01. In one dimension
(Saint-Venant; Johnson, Contact Mechanics, 1985, section 11.1) the force ρ c v A acts for 2 L / c; then the rod leaves with v. With
the stress E ln λ of the solver the balance of momentum of the shock makes force and wave speed 1 + v / 4 c times as large, to the first
order. A `*RIGIDWALL_PLANAR` stops it by impulses, or by springs (RWPNAL = −1); or a rigid plate does it by contact. The force is
the mean from L / 2 c to 3 L / 2 c, the time of contact ends when there is no force any more, both from rwforc or rcforc; the rebound is the
mean velocity of the rod at 3.5 L / c, by nodout. The meshes have 20, 40, ... and 320 bricks along, one or two across. RWKSF is 40 with 160
bricks along and goes with the edges to the power of −4/3, which makes the springs as stiff beside the bricks on every mesh. SFSA = SFSB = 4,
SOFSCL = 0.4, mortar: PENMAX a tenth of a brick; the contact is that of the segments at the end of the rod.
""", wall_deck, wall_values, (WALL, SPRINGS) + VARIANTS, levels=(0, 1, 2, 3, 4), column="stopped by", cause="""\
The wall cannot pull, so the rod leaves when half of the front that comes back has arrived; what a front that is smeared over a length w
brings later is lost: a share of w / 8 L of the impulse, twice that of the rebound. The linear bulk viscosity (Q2 = 0.06), which goes with the
edges, smears a front like diffusion, with the square root of the edges. That is the order of the rebound by impulses. Without it,
the rebound by impulses is 0.9 % too small with 160 bricks in place of 1.7 %, and the order is 2/3, that of the dispersion
of the mesh. The impulses stop nodes plastically; that is of order 1, so less. The time of contact is exact for a front that is smeared; springs need
time to unload, which makes it too long with order 1, and what they store comes back. The energy ratio leaves out the work of the bulk
viscosity, as LS-DYNA's does.
""")
