"""All problems with meshes and a reference, in the order of the pages."""
from .fits import PIN, PRESS_FIT
from .hertz import BALL, CYLINDERS
from .plastic import BEAM
from .punch import PUNCH
from .rods import BALL_IMPACT, RODS
from .sliding import STICK_SLIP, WEDGE

PROBLEMS = [BALL, CYLINDERS, PUNCH, PRESS_FIT, PIN, WEDGE, STICK_SLIP, RODS, BALL_IMPACT, BEAM]
