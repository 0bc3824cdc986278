"""All problems with meshes and a reference, in the order of the pages."""
from .ball import BALL, BALL_IMPACT
from .fits import PIN, PRESS_FIT
from .hertz import CYLINDERS
from .ironing import IRONING
from .plastic import BEAM
from .punch import PUNCH
from .ring import RING
from .rods import RODS
from .sliding import STICK_SLIP, WEDGE
from .strip import STRIP
from .taylor import TAYLOR
from .tube import TUBE
from .walls import WALL_ROD

PROBLEMS = [BALL, CYLINDERS, PUNCH, PRESS_FIT, PIN, RING, STRIP, WEDGE, STICK_SLIP, IRONING, RODS, WALL_ROD, BALL_IMPACT, BEAM, TAYLOR, TUBE]
