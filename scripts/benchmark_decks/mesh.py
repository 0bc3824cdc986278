"""Blocks of bricks and sheets of shells, written as keywords."""
import math

# TC and RC of *NODE by the axes that are held.
HELD = {"": 0, "x": 1, "y": 2, "z": 3, "xy": 4, "yz": 5, "xz": 6, "xyz": 7}


def graded(step, until, length, growth):
    """Places from 0 to `length`: even steps up to about `until`, then each `growth` times as long as the one before."""
    count = max(1, round(until / step))
    places, size = [i * step for i in range(count + 1)], step
    steps = []
    while sum(steps) + count * step < length * (1 - 1e-9):
        size *= growth
        steps.append(size)
    if steps:
        factor = (length - count * step) / sum(steps)
        for s in steps:
            places.append(places[-1] + factor * s)
    places[-1] = length
    return places


def even(count, start=0.0, end=1.0):
    return [start + (end - start) * i / count for i in range(count + 1)]


class Mesh:
    """Nodes with the axes in which they are held, bricks, shells, and the cards that name them."""

    def __init__(self):
        self.nodes, self.held, self.turns, self.elements = [], [], [], {"SOLID": [], "SHELL": []}

    def add_node(self, point, held="", turns=""):
        self.nodes.append(tuple(point))
        self.held.append(held)
        self.turns.append(turns)
        return len(self.nodes)

    def block(self, part, r, s, t, place, held=lambda i, j, k: ""):
        """Bricks between the places r x s x t; `place(r, s, t)` is the point, right-handed; `held(i, j, k)` its axes.
        Returns ids[k][j][i]."""
        ids = [[[self.add_node(place(ri, sj, tk), held(i, j, k)) for i, ri in enumerate(r)] for j, sj in enumerate(s)]
               for k, tk in enumerate(t)]
        for k in range(len(t) - 1):
            for j in range(len(s) - 1):
                for i in range(len(r) - 1):
                    self.elements["SOLID"].append((part, [ids[k + c][j + b][i + a] for c in (0, 1)
                                                          for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]))
        return ids

    def quarter(self, part, r, t, place):
        """A quarter of a body of revolution about z, one element around: bricks, and degenerate ones at the axis r = 0,
        between the places r x t; `place(r, t)`: radius and height in the plane midway between x = 0 and y = 0, where the one
        point of each brick lies. The sides are straight, so nodes lie √2 farther out and the section is 4/π of that of the
        quarter. Nodes are held in the planes of symmetry x = 0 and y = 0, one for each. Returns ids[j][k][i], j = 0 at y = 0."""
        ids = [[[0] * len(r) for _ in t] for _ in (0, 1)]
        for k, tk in enumerate(t):
            for i, ri in enumerate(r):
                radius, z = place(ri, tk)
                radius *= math.sqrt(2)
                ids[0][k][i] = self.add_node((radius, 0.0, z), "xy" if i == 0 else "y")
                ids[1][k][i] = self.add_node((0.0, radius, z), "x") if i > 0 else ids[0][k][i]
        for k in range(len(t) - 1):
            for i in range(len(r) - 1):
                layers = [[ids[0][n][i + 1], ids[1][n][i + 1], ids[1][n][i], ids[0][n][i]] for n in (k, k + 1)]
                self.elements["SOLID"].append((part, layers[0] + layers[1]))
        return ids

    def sheet(self, part, r, s, place, held=lambda i, j: "", turns=lambda i, j: ""):
        """Quads between the places r x s, normals along ∂/∂r × ∂/∂s. Returns ids[j][i]."""
        ids = [[self.add_node(place(ri, sj), held(i, j), turns(i, j)) for i, ri in enumerate(r)]
               for j, sj in enumerate(s)]
        for j in range(len(s) - 1):
            for i in range(len(r) - 1):
                self.elements["SHELL"].append((part, [ids[j + b][i + a] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]))
        return ids

    def text(self):
        lines = ["*NODE"]
        for i, (point, held, turns) in enumerate(zip(self.nodes, self.held, self.turns), 1):
            codes = f"{HELD[held]:8d}{HELD[turns]:8d}" if held or turns else ""
            lines.append(f"{i:8d}" + "".join(f"{c + 0.0:16.9g}" for c in point) + codes)
        number = 0
        for kind, elements in self.elements.items():
            if elements:
                lines.append(f"*ELEMENT_{kind}")
            for part, corners in elements:
                number += 1
                lines.append(f"{number:8d}{part:8d}" + "".join(f"{n:8d}" for n in corners))
        return "\n".join(lines) + "\n"


def fields(*values):
    """A card of fields of ten columns; None: blank."""
    cells = ("" if v is None else f"{v:.4g}" if isinstance(v, float) else str(v) for v in values)
    return "".join(f"{cell:>10}" for cell in cells) + "\n"


def node_set(number, ids):
    ids = list(ids)
    return f"*SET_NODE_LIST\n{number:10d}\n" + "".join(
        "".join(f"{n:10d}" for n in ids[i:i + 8]) + "\n" for i in range(0, len(ids), 8))


def segment_set(number, rows):
    """Of the quads between the rows of nodes ids[j][i] of a face, normals along ∂/∂i × ∂/∂j."""
    quads = [[rows[j + b][i + a] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
             for j in range(len(rows) - 1) for i in range(len(rows[0]) - 1)]
    return f"*SET_SEGMENT\n{number:10d}\n" + "".join("".join(f"{n:10d}" for n in quad) + "\n" for quad in quads)


def curve(number, points):
    return f"*DEFINE_CURVE\n{number:10d}\n" + "".join(f"{x:20.10g}{y:20.10g}\n" for x, y in points)


def smooth(number, end, most, hold=100.0, steps=40):
    """A curve that rises to `most` at `end` without jumps of velocity or acceleration, and stays there."""
    shares = [i / steps for i in range(steps + 1)]
    return curve(number, [(end * q, most * q ** 3 * (10 - 15 * q + 6 * q * q)) for q in shares] + [(hold * end, most)])


def part(number, section, material, name="part"):
    return f"*PART\n{name}\n" + fields(number, section, material)


def history(ids):
    ids = list(ids)
    return "*DATABASE_HISTORY_NODE\n" + "".join(
        "".join(f"{n:10d}" for n in ids[i:i + 8]) + "\n" for i in range(0, len(ids), 8))


def start(title, units, end, interval, scale=0.9, plots=1, hourglass=0.1):
    """Control and output cards. `scale`: TSSFAC; `plots`: states of d3plot behind the first; `hourglass`: QM of the
    stiffness form; 0: as the program does it unasked."""
    return (f"*KEYWORD\n*TITLE\n{title}\n$ {units}\n*CONTROL_TERMINATION\n{end:10g}\n*CONTROL_TIMESTEP\n"
            f"       0.0{scale:10g}\n*CONTROL_ENERGY\n         2         2         2         2\n"
            + (f"*CONTROL_HOURGLASS\n         5{hourglass:10g}\n" if hourglass else "")
            + "".join(f"*DATABASE_{name}\n{interval:10g}\n" for name in ("GLSTAT", "RCFORC", "SLEOUT", "NODOUT"))
            + f"*DATABASE_NCFORC\n{end:10g}\n*DATABASE_BINARY_D3PLOT\n{end / plots:10g}\n")
