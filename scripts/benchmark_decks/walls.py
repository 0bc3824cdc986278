"""A rod that hits a rigid wall, or a rigid plate in contact."""
from .contacts import VARIANTS, contact
from .mesh import Mesh, even, fields, history, part, start
from .problem import Problem, Value
from .rods import LENGTH, SIDE, SPEED

THICKNESS = 0.1
WALL, SPRINGS = "wall", "wall, springs"


def stop(variant):
    """The cards of what stops the rod at x = 0."""
    if variant in VARIANTS:
        return ("*SECTION_SHELL\n" + fields(2, 2) + fields(THICKNESS) + "*MAT_RIGID\n" + fields(2, 1.0, 1000.0, 0.3)
                + fields(1.0, 7, 7) + "\n" + part(2, 2, 2, "plate") + contact(variant, scale=4.0, soft_scale=0.4))
    # RWPNAL < 0: springs stop all nodes. OFFSET, BIRTH and DEATH are blank; RWKSF is the stiffness beside RWPNAL.
    return (("*CONTROL_CONTACT\n" + fields(None, -1.0) if variant == SPRINGS else "")
            + "*RIGIDWALL_PLANAR\n" + fields(0, 0, 0, 0.0, 0.0, None, 40.0 if variant == SPRINGS else None)
            + fields(0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0))


def wall_deck(level, variant):
    across, mesh = even(2 ** level, 0.0, SIDE), Mesh()
    rod = mesh.block(1, even(20 * 2 ** level, -LENGTH, 0.0), across, across, lambda x, y, z: (x, y, z),
                     lambda i, j, k: "yz")
    if variant in VARIANTS:
        mesh.sheet(2, [-SIDE, 2 * SIDE], [-SIDE, 2 * SIDE], lambda y, z: (THICKNESS / 2, y, z))
    end = 3.5 * LENGTH
    return (start("rod on a rigid wall", "E = density = 1, length 10", end, 0.05, 0.6)
            + f"*DATABASE_RWFORC\n{0.05:10g}\n" + history(rod[0][0]) + part(1, 1, 1, "rod")
            + "*SECTION_SOLID\n" + fields(1, 1) + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, 0.0)
            + "*INITIAL_VELOCITY_GENERATION\n" + fields(1, 2, 0.0, SPEED) + "\n" + stop(variant) + mesh.text() + "*END\n")


def wall_values(run, level, variant):
    force = run.rwforc(1) if variant not in VARIANTS else [(t, abs(f[0])) for t, f in run.rcforc(1, "A")]
    expected = (1 + SPEED / 4) * SPEED * SIDE ** 2
    middle = [f for t, f in force if 0.5 * LENGTH < t < 1.5 * LENGTH]
    inside = [t for t, f in force if f > expected / 2]
    # Speeds of the nodes along, those at the ends with half of a brick's mass.
    last = [rows[-1][3] for _, rows in sorted(run.nodes.items())]
    speed = (sum(last) - (last[0] + last[-1]) / 2) / (len(last) - 1)
    return [Value("rebound", -speed, SPEED), Value("force", sum(middle) / len(middle), expected),
            Value("time of contact", max(inside) - min(inside), (1 - SPEED / 4) * 2 * LENGTH)]


WALL_ROD = Problem(
    "wall_rod", "Rod on a rigid wall", """\
A rod (length L = 10, section A = 0.25, E = ρ = 1, ν = 0, so c = 1) hits a rigid wall, end to end, with v = 0.01. In one dimension
(Saint-Venant; Johnson, Contact Mechanics, 1985, section 11.1) the force ρ c v A acts for 2 L / c; then the rod leaves with v. With
the stress E ln λ of the solver the balance of momentum of the shock makes force and wave speed 1 + v / 4 c times as large, to the first
order. A `*RIGIDWALL_PLANAR` stops it by impulses, or by springs (RWPNAL = −1, RWKSF = 40); or a rigid plate does it by contact. The force is
the mean from L / 2 c to 3 L / 2 c, the time of contact that of more than half of it, both from rwforc or rcforc; the rebound is the
mean velocity of the rod at 3.5 L / c, by nodout. The meshes have cubes, 20, 40 and 80 along. SFSA = SFSB = 4, SOFSCL = 0.4.
""", wall_deck, wall_values, (WALL, SPRINGS) + VARIANTS, column="stopped by", cause="""\
The impulses stop a node plastically, so the energy of the nodes at the end is lost: of order 1 in the energy, which goes with the mass of the
end nodes, and so in the rebound. The bulk viscosity smears the fronts over a few bricks and takes the rest; so the rebound converges
slower than with order 1, in all rows. SOFT 1 and 2, at the step's limit, have the softest springs on the coarse mesh: the force has not risen
before L / 2 c. The times are those of cycles, which are 0.28, 0.14 and 0.07 long: errors below 1.4, 0.7 and 0.35 % have no order.
""")
