#!/usr/bin/env python3
"""Writes the scenes of docs/fix.md into data/fix: small decks in closed form, each with one thing to correct. Deterministic.

Shells have thickness 1 and edges of about 5 unless the scene says otherwise; units are mm, t, s.
"""
import math
import sys

sys.dont_write_bytecode = True  # keeps the source tree clean

import generated


class Deck:
    """Nodes, shells, bricks and beams in parts of steel, one contact, and other lines."""

    def __init__(self, title):
        self.title, self.nodes, self.parts, self.tail = title, [], [], []
        self.contact("AUTOMATIC_SINGLE_SURFACE")

    def contact(self, kind, sides=(0, 0, 5), cards=()):
        """`sides`: SURFA, SURFB, SURFATYP, SURFBTYP; `cards`: behind card 3."""
        self.contact_lines = [f"*CONTACT_{kind}_ID", f"{1:10}", "".join(f"{s:10}" for s in sides), "", "", *cards]

    def node(self, x, y, z):
        self.nodes.append((x, y, z))
        return len(self.nodes)

    def sheet(self, place, nx, ny, thickness=1.0, wrap=False):
        """A mesh of nx by ny quads; `place` gives the point of the grid position (i, j). `wrap`: the last column is the first."""
        columns = nx if wrap else nx + 1
        grid = [[self.node(*place(i, j)) for i in range(columns)] for j in range(ny + 1)]
        self.parts.append(("shell", thickness, [
            (grid[j][i], grid[j][(i + 1) % columns], grid[j + 1][(i + 1) % columns], grid[j + 1][i])
            for j in range(ny) for i in range(nx)]))
        return grid

    def block(self, place, nx, ny, nz, wrap=False):
        """A mesh of nx by ny by nz bricks; `wrap` as in sheet()."""
        columns = nx if wrap else nx + 1
        grid = [[[self.node(*place(i, j, k)) for i in range(columns)] for j in range(ny + 1)] for k in range(nz + 1)]
        corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
        self.parts.append(("solid", 0, [
            tuple(grid[k + c][j + b][(i + a) % columns] for a, b, c in corners)
            for k in range(nz) for j in range(ny) for i in range(nx)]))
        return grid

    def cable(self, place, count, diameter):
        """A chain of beams; `place` gives the point at each end."""
        nodes = [self.node(*place(i)) for i in range(count + 1)]
        self.parts.append(("beam", diameter, list(zip(nodes, nodes[1:]))))

    def text(self):
        lines = ["*KEYWORD", "*TITLE", self.title, "*MAT_ELASTIC", "         1   7.85e-9  210000.       0.3"]
        for number, (kind, thickness, _) in enumerate(self.parts, 1):
            lines += ["*PART", f"part {number}", f"{number:10}{number:10}{1:10}"]
            lines += {"solid": ["*SECTION_SOLID", f"{number:10}{1:10}"],
                      "shell": ["*SECTION_SHELL", f"{number:10}{2:10}", f"{thickness:10}" * 4],
                      "beam": ["*SECTION_BEAM", f"{number:10}{1:10}{1.0:10}{2:10}{1:10}",
                               f"{thickness:10}" * 2 + f"{0.0:10}" * 2]}[kind]
        lines += self.contact_lines + self.tail
        lines += ["*NODE"] + [f"{n:8}{x:16.8f}{y:16.8f}{z:16.8f}" for n, (x, y, z) in enumerate(self.nodes, 1)]
        element = 0
        for number, (kind, _, elements) in enumerate(self.parts, 1):
            lines.append("*ELEMENT_" + kind.upper())
            for nodes in elements:
                element += 1
                lines.append("".join(f"{n:8}" for n in (element, number) + nodes))
        return "\n".join(lines + ["*END", ""])


def flat(x=0.0, y=0.0, z=0.0, size=5.0):
    return lambda i, j: (x + size * i, y + size * j, z)


def tilted(degrees, x, y, z, pivot, size=5.0):
    """A plane that rises with i; position `pivot` (in columns) is at height z."""
    a = math.radians(degrees)
    return lambda i, j: (x + size * (i - pivot) * math.cos(a), y + size * j, z + size * (i - pivot) * math.sin(a))


def upright(x, y, z, size=5.0):
    return lambda i, j: (x, y + size * i, z + size * j)


def ring(radius, width, count, z0=0.0, start=0.0):
    return lambda i, j: (radius * math.cos(start + 2 * math.pi * i / count),
                         radius * math.sin(start + 2 * math.pi * i / count), z0 + width * j)


def plates():
    d = Deck("two plates, 0.3 too near")
    d.sheet(flat(), 6, 6)
    d.sheet(flat(1.7, 1.3, 0.7), 5, 5)
    return d


def t_joint():
    d = Deck("a plate stands on another, 0.4 too near")
    d.sheet(flat(), 8, 6)
    d.sheet(upright(21.0, 2.0, 0.6), 5, 4)
    return d


def sandwich():
    d = Deck("four plates in a stack, each 0.2 too near to the next")
    for k in range(4):
        d.sheet(flat(0.9 * k, 0.7 * k, 0.8 * k), 6, 6)
    return d


def press_fit():
    d = Deck("a tube in a tube, 0.15 too wide")
    d.sheet(ring(20.0, 5.0, 24), 24, 6, wrap=True)
    d.sheet(ring(19.15, 5.0, 24, 2.0, 0.1), 24, 5, wrap=True)
    return d


def welded_stack():
    d = Deck("three sheets with spot welds, 0.2 too near")
    grids = [d.sheet(flat(0, 0, 0.8 * k), 8, 6) for k in range(3)]
    for i, j in ((1, 1), (1, 5), (4, 3), (7, 1), (7, 5)):
        for low, high in ((0, 1), (1, 2)):
            d.tail += ["*CONSTRAINED_SPOTWELD", f"{grids[low][j][i]:10}{grids[high][j][i]:10}"]
    return d


def bolt():
    d = Deck("a shank of bricks, 0.1 too thick for the hole of a plate of bricks")
    d.block(lambda i, j, k: ((5.0 + 5.0 * j) * math.cos(math.pi * i / 12), (5.0 + 5.0 * j) * math.sin(-math.pi * i / 12),
                             4.0 * k), 24, 3, 2, wrap=True)
    d.block(lambda i, j, k: ((1.0 + 2.05 * j) * math.cos(math.pi * (i + 0.5) / 12),
                             (1.0 + 2.05 * j) * math.sin(-math.pi * (i + 0.5) / 12), 4.0 * k - 4.0), 24, 2, 4, wrap=True)
    return d


def crossed(degrees, shift=0.0, reach=1.0):
    """A narrower plate tilted through a wide one: its end is `reach` below."""
    d = Deck(f"two plates that cross at {degrees} degrees")
    d.sheet(flat(), 12, 8)
    length = reach / math.sin(math.radians(degrees)) / 5.0
    d.sheet(tilted(degrees, 27.3, 7.1 + shift, 0.0, length), 7, 4 if shift == 0 else 8)
    return d


def corner():
    d = Deck("a plate with a corner through another")
    d.sheet(flat(), 8, 8)
    a, b = math.radians(35), math.radians(40)

    def place(i, j):
        u, v = 5.0 * i, 5.0 * j
        return (14.2 + (u - v) * math.cos(a), 16.3 + 0.3 * (u + v), -0.9 + (u + v) * math.sin(b) * 0.7)
    d.sheet(place, 4, 4)
    return d


def dome():
    d = Deck("a dome with its top through a plate")
    d.sheet(flat(), 12, 12)

    def place(i, j):
        x, y = 2.1 + 4.6 * i, 1.7 + 4.6 * j
        return (x, y, -8.2 + 9.5 * math.cos(math.pi * (i - 6) / 14) * math.cos(math.pi * (j - 6) / 14))
    d.sheet(place, 12, 12)
    return d


def airbag():
    """Not in data/fix: its megabyte is written where it is needed."""
    d = Deck("a folded bag of 10,000 shells, its layers 0.08 too near")
    layers, nx, ny, pitch = 10, 49, 20, 0.42

    def place(i, j):
        layer, position = divmod(i, nx + 1)
        return (2.0 * (position if layer % 2 == 0 else nx - position), 2.0 * j, pitch * layer)
    d.sheet(place, layers * (nx + 1), ny, thickness=0.5)
    return d


def gears():
    d = Deck("two toothed bars of bricks, the teeth 0.2 into each other")

    def bar(y, up, x):
        def place(i, j, k):
            tooth = (0.0, 4.0, 4.0, 0.0)[i % 4] if j == 2 else 0.0
            return (x + 3.0 * i, y + up * (4.0 * j + tooth), 4.0 * k)
        return place
    d.block(bar(0.0, 1, 0.0), 16, 2, 2)
    grid = bar(0.0, -1, 6.0)

    def upper(i, j, k):
        x, y, z = grid(i, 2 - j, k)
        return (x, 19.8 + y, z + 0.3)
    d.block(upper, 12, 2, 2)
    return d


def foam():
    d = Deck("a block of foam, 0.4 too large for its box of sheets")
    d.block(lambda i, j, k: (4.0 * i, 4.0 * j, 4.0 * k), 5, 5, 4)
    d.sheet(flat(-2.0, -2.0, -0.1, 4.0), 6, 6)
    d.sheet(flat(-2.0, -2.0, 16.1, 4.0), 6, 6)
    return d


def crumpled():
    d = Deck("a crumpled sheet that passes through itself at its folds")
    line, x, z = [], 0.0, 0.0
    for i in range(29):
        line.append((x, z))
        turn = 2.15 * math.sin(2 * math.pi * (i + 0.5) / 14)
        x, z = x + 4.0 * math.cos(turn), z + 4.0 * math.sin(turn)
    d.sheet(lambda i, j: (line[i][0], 4.0 * j, line[i][1]), 28, 6)
    return d


def block_in_sheet():
    d = Deck("a block of bricks with its bottom through a sheet")
    d.sheet(flat(), 8, 8)
    d.block(lambda i, j, k: (11.2 + 4.0 * i, 12.1 + 4.0 * j, -0.9 + 4.0 * k), 3, 3, 3)
    return d


def block_in_block():
    d = Deck("a block of bricks, 0.7 deep in another")
    d.block(lambda i, j, k: (5.0 * i, 5.0 * j, 5.0 * k), 5, 5, 3)
    d.block(lambda i, j, k: (7.1 + 4.0 * i, 6.3 + 4.0 * j, 14.3 + 4.0 * k), 3, 3, 3)
    return d


def three_sheets():
    d = Deck("a sheet with its end through two others")
    d.sheet(flat(), 10, 8)
    d.sheet(flat(0.7, 0.9, 2.5), 10, 8)
    d.sheet(tilted(30, 24.1, 9.2, 2.5, 0.7), 6, 4)
    return d


def one_way():
    d = Deck("crossed sheets in a one-way contact, the tracked one on top")
    d.sheet(flat(), 12, 8)
    d.sheet(tilted(20, 27.3, 7.1, 0.0, 0.7), 7, 4)
    d.contact("AUTOMATIC_NODES_TO_SURFACE", (2, 1, 3, 3))
    return d


def soft_2():
    d = Deck("a tube in a tube, 0.15 too wide, in a contact of segments (SOFT = 2)")
    d.sheet(ring(20.0, 5.0, 24), 24, 6, wrap=True)
    d.sheet(ring(19.15, 5.0, 24, 2.0, 0.1), 24, 5, wrap=True)
    d.contact("AUTOMATIC_SURFACE_TO_SURFACE", (1, 2, 3, 3), [f"{2:10}"])
    return d


def mortar():
    d = Deck("a shallow dome above a plate, 0.35 too near, in a mortar contact")
    d.sheet(flat(), 12, 12)

    def place(i, j):
        u, v = (i - 5.5) / 5.5, (j - 5.5) / 5.5
        return (3.1 + 4.9 * i, 2.7 + 4.9 * j, 0.6 + 3.0 * (u * u + v * v))
    d.sheet(place, 11, 11)
    d.contact("AUTOMATIC_SINGLE_SURFACE_MORTAR")
    return d


def cables():
    d = Deck("a net of cables that are laid over each other, 0.3 too near")
    for k in range(3):
        d.cable(lambda i: (5.0 * i, 7.3 + 7.0 * k, 0.0), 6, 1.5)
        d.cable(lambda i: (7.3 + 7.0 * k, 5.0 * i, 1.2), 6, 1.5)
    d.contact("AUTOMATIC_GENERAL")
    return d


def ground():
    d = Deck("a block of bricks, 0.2 deep in a rigid wall, and a sheet on it, 0.1 too near")
    d.block(lambda i, j, k: (4.0 * i, 4.0 * j, 4.0 * k - 0.2), 5, 5, 3)
    d.sheet(flat(-2.0, -2.0, 12.2, 4.0), 6, 6)
    d.tail += ["*RIGIDWALL_PLANAR", "", "".join(f"{x:10}" for x in (0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0))]
    return d


def hooked():
    d = Deck("two sheets with slits in each other: neither can give way")
    d.sheet(flat(), 10, 8)
    d.sheet(upright(22.3, 20.0 + 1.1, -15.0), 10, 6)
    return d


def through():
    d = Deck("a tube right through a sheet")
    d.sheet(flat(), 10, 10)
    d.sheet(lambda i, j: (25.3 + 8.0 * math.cos(math.pi * i / 8), 24.1 + 8.0 * math.sin(math.pi * i / 8), -40.0 + 5.0 * j),
            16, 16, wrap=True)
    return d


def fixed_sheets():
    d = crossed(10)
    d.title = "two crossed sheets that are fixed"
    d.tail += ["*BOUNDARY_SPC_SET", f"{1:10}{0:10}" + f"{1:10}" * 6, "*SET_NODE_GENERAL", f"{1:10}",
               f"{'PART':>10}{1:10}{2:10}"]
    return d


SCENES = {
    "plates": plates, "t_joint": t_joint, "sandwich": sandwich, "press_fit": press_fit, "welded_stack": welded_stack,
    "bolt": bolt, "crossed_05": lambda: crossed(5, reach=0.9), "crossed_15": lambda: crossed(15),
    "crossed_30": lambda: crossed(30), "crossed_45": lambda: crossed(45, reach=1.5),
    "crossed_60": lambda: crossed(60, reach=1.5), "crossed_90": lambda: crossed(90, reach=1.5),
    "crossed_aside": lambda: crossed(8, shift=9.0), "corner": corner, "dome": dome, "gears": gears,
    "foam": foam, "crumpled": crumpled, "block_in_sheet": block_in_sheet, "block_in_block": block_in_block,
    "three_sheets": three_sheets, "one_way": one_way, "hooked": hooked, "through": through, "fixed_sheets": fixed_sheets,
    "soft_2": soft_2, "mortar": mortar, "cables": cables, "ground": ground,
}


LARGE = {"airbag": airbag}


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in SCENES.items():
        (folder / f"{name}.k").write_text(make().text())


if __name__ == "__main__":
    sys.exit(generated.main(__doc__, "make_fix_scenes.py", "data/fix", write_all))
