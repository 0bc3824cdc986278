"""Contact cards of the variants that the benchmarks compare."""
from .mesh import fields

PENALTY = ("SOFT 0", "SOFT 1", "SOFT 2")
VARIANTS = PENALTY + ("mortar",)


def contact(variant, sides=(1, 2), kinds=(3, 3), scale=10.0, soft_scale=0.4, friction=None, damping=0.0, ignore=1,
            segment_scale=4.0, depth=None):
    """Automatic surface to surface. `scale`: SFSA and SFSB of SOFT 0 and mortar; `soft_scale`: SOFSCL; `friction`: FS, FD, DC;
    `damping`: VDC; `segment_scale`: SFSA and SFSB of SOFT 2, whose springs follow the step, so that they are stable at any mesh but not
    at any scale. Mortar has the IGNORE of its default."""
    mortar = variant == "mortar"
    if variant == "SOFT 1":
        scale = 1.0  # SOFSCL says how stiff it is
    elif variant == "SOFT 2":
        scale = min(scale, segment_scale)
    friction = friction or (0.0, 0.0, 0.0)
    text = f"*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE{'_MORTAR' if mortar else ''}\n" + fields(*sides, *kinds)
    text += fields(*map(float, friction), 0.0, float(damping)) + fields(float(scale), float(scale))
    if mortar:
        return text + (fields(0) + fields(float(depth)) if depth else "")
    soft = int(variant[-1])
    # Card A: SOFT, SOFSCL, SBOPT, DEPTH; card B: nothing; card C: IGAP, IGNORE.
    return (text + fields(soft, soft_scale, 0, None, 3.0 if soft == 2 else None, 5 if soft == 2 else None)
            + fields(0.0) + fields(1, ignore))
