"""A block with a round foot that is pressed into a slab and slides over it."""
import functools
import pathlib
import tempfile

from .contacts import VARIANTS, contact
from .mesh import Mesh, curve, even, fields, graded, history, node_set, part, segment_set, smooth, start
from .problem import Problem, Value
from .result import Result

FRICTION, POISSON, HARD = 0.3, 0.3, 10.0  # E of the slab, its height and density: 1
ROUND, DEPTH, HALF, REACH = 2.0, 0.05, 0.75, 4.0
PRESSED, SPEED, START, STEADY, END = 20.0, 0.02, -1.0, 50.0, 100.0
FINEST = 2


def ironing_deck(level, variant):
    """Bricks of the slab of 1/8, 1/16, ... along; those of the block are 1.17 times as long, so the meshes never match."""
    h, mesh = 1 / 8 / 2 ** level, Mesh()
    growth = 1.3 ** (1 / 2 ** level)
    down = graded(h, 3 * h, 1.0, growth)

    def place(x, y, z):
        return x, y, z

    slab = mesh.block(1, even(round(2 * REACH / h), -REACH, REACH), [0.0, h], [-q for q in reversed(down)], place,
                      lambda i, j, k: "xyz" if k == 0 else "y")

    def foot(x, y, z):
        # Round below, flat above.
        return x + START, y, z + (1 - z) * x * x / (2 * ROUND) + 1e-4

    across = even(round(2 * HALF / h / 1.17), -HALF, HALF)
    block = mesh.block(2, across, [0.0, h], graded(1.17 * h, 3 * h, 1.0, growth), foot, lambda i, j, k: "y")
    top = sorted(n for row in block[-1] for n in row)
    return (start("block that irons a slab", "E = density = height = 1, plane strain", END, 0.25, 0.3)
            + history([slab[-1][0][0], top[0]]) + part(1, 1, 1, "slab") + part(2, 1, 2, "block") + "*SECTION_SOLID\n"
            + fields(1, 1) + "*MAT_ELASTIC\n" + fields(1, 1.0, 1.0, POISSON) + "*MAT_ELASTIC\n"
            + fields(2, HARD, HARD, POISSON) + node_set(1, top)
            + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 3, 2, 1) + smooth(1, PRESSED, -DEPTH)
            + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + fields(1, 1, 0, 2, SPEED)
            + curve(2, [(0, 0), (PRESSED, 0), (PRESSED + 10, 1), (10 * END, 1)]) + "*DAMPING_GLOBAL\n" + fields(0, 1.0)
            + segment_set(1, slab[-1]) + segment_set(2, block[0][::-1])
            + contact(variant, (2, 1), (0, 0), scale=25.0, soft_scale=1.0, friction=(FRICTION, FRICTION, 0.0), segment_scale=20.0, depth=h / 10) + mesh.text() + "*END\n")


def forces(run, level):
    """[(normal, along)] of unit width while it slides steadily."""
    width = 1 / 8 / 2 ** level
    return [(abs(f[2]) / width, abs(f[0]) / width) for t, f in run.rcforc(1, "A") if t > STEADY]


@functools.lru_cache
def finest(program):
    """Mean normal force with SOFT 0 on the mesh twice as fine as the finest of the table; of a shorter way."""
    with tempfile.TemporaryDirectory() as folder:
        run = Result(program, ironing_deck(FINEST, "SOFT 0"), pathlib.Path(folder), ["--until", f"{STEADY + 10:g}"])
        rows = forces(run, FINEST)
    return sum(n for n, _ in rows) / len(rows)


def ironing_values(run, level, variant):
    rows = forces(run, level)
    normal, along = (sum(r[i] for r in rows) / len(rows) for i in (0, 1))
    return [Value("mean normal force", normal, finest(run.program)),
            Value("greatest over mean", max(n for n, _ in rows) / normal, 1.0),
            Value("least over mean", min(n for n, _ in rows) / normal, 1.0),
            Value("friction over normal force", along / normal, FRICTION)]


IRONING = Problem(
    "ironing", "Ironing", """\
A block (1.5 wide, 1 high, E = 10) with a round foot of the radius 2 is pressed into a slab (8 long, height H = E = ρ = 1, held below;
both ν = 0.3, plane strain, one brick thick) by 0.05, smoothly over the time 20, and slides along it at v = 0.02 from then on, μ = 0.3.
Steady from 50 to 100 it passes 8 and 16 edges of bricks of the slab; those of the block are 1.17 times as long, so meshes never match. The
force along over the normal force is μ; the normal force is constant, so its greatest and least values over the mean show the steps
of the contact from brick to brick. For the mean there is no closed form: its reference is this program's own with SOFT 0 on a mesh twice as
fine as the finest one here, so it says how the contacts converge, no more. All by rcforc. SOFT 0: SFSA = SFSB = 25, SOFT 1: SOFSCL = 1,
SOFT 2: SFSA = SFSB = 20, mortar: SFSA = SFSB = 25 and PENMAX a tenth of a brick; TSSFAC = 0.3. Damped, since
sliding with friction makes the bodies flutter. The contacts are of segments, the top of the slab and the foot of the block.
""", ironing_deck, ironing_values, VARIANTS, levels=(0, 1), cause="""\
The force along stays a percent below μ times the normal force, on finer meshes too, so the mesh is not the cause: in steady motion
without losses in the bodies the work F v is that of friction, and surfaces that are strained by a few percent do not slide on each
other at v.

The mean normal force falls short by the depth of the contact, which is a part of the way pressed and falls with the edges. It is softness
alone: with TSSFAC = 0.6, a fifth of SFSA in SOFT 2 (4) and mortar contact without PENMAX (SFSA = 20) the coarse mesh falls short by
21 % and 27 %.

The contacts name the segments of the faces that meet, so that the flush sides of both bodies take no part.
""")
