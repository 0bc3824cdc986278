#!/usr/bin/env python3
"""Writes the deck of docs/tutorial.md, data/tutorial/: a bumper beam in front of a crash box. Units: mm, ms, kg, so kN and
GPa. The beam's sheet was meant to be 1.0 thick and is 2.5, but its mesh stayed where it was. Deterministic."""

import sys

sys.dont_write_bytecode = True  # keeps the source tree clean

import generated
from data_decks.deck import Deck, card

SIZE = 10.0  # of the elements
BOX, PLATE, BEAM = 1, 2, 3
SHEETS = {BOX: ("crash box", 2.0), PLATE: ("front plate", 2.0), BEAM: ("bumper beam", 2.5)}
GAP = 1.5  # between the mid-surfaces of plate and beam: enough for sheets of 2.0 and 1.0
SPEED, END = 5.0, 1.0


class Mesh(Deck):
    """Shells over points of a grid that are joined where they coincide."""

    def __init__(self, name):
        super().__init__(name, "")
        self.at = {}

    def corner(self, pid, point):
        if point not in self.at:
            self.at[point] = self.node(1000 * pid + len(self.at) + 1, *point)
        return self.at[point]

    def sheet(self, pid, place, columns, rows):
        """Quads between place(i, j) and its neighbours."""
        for j in range(rows):
            for i in range(columns):
                self.shell(pid, [self.corner(pid, place(i + a, j + b)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])

    def mesh_text(self):
        return "\n".join(self.mesh_lines()) + "\n"


def crash_box():
    """A tube of 60 x 60 along x, held at its end and closed by a plate of 80 x 80."""
    mesh, length, half = Mesh("box"), 100.0, 30.0
    ring = [(SIZE * i - half, -half) for i in range(6)] + [(half, SIZE * i - half) for i in range(6)]
    ring += [(half - SIZE * i, half) for i in range(6)] + [(-half, half - SIZE * i) for i in range(6)]
    mesh.sheet(BOX, lambda i, j: (SIZE * j, *ring[i % len(ring)]), len(ring), 10)
    mesh.sheet(PLATE, lambda i, j: (length, SIZE * i - 40.0, SIZE * j - 40.0), 8, 8)
    held = [node for point, node in mesh.at.items() if point[0] == 0.0]
    return mesh, held, length


def bumper_beam(length):
    """A channel, open to the front, 300 wide and 100 high."""
    mesh, x0 = Mesh("beam"), length + GAP
    profile = [(x0 + 40.0 - SIZE * i, -50.0) for i in range(5)] + [(x0, -40.0 + SIZE * i) for i in range(9)]
    profile += [(x0 + SIZE * i, 50.0) for i in range(5)]
    mesh.sheet(BEAM, lambda i, j: (profile[j][0], SIZE * i - 150.0, profile[j][1]), 30, len(profile) - 1)
    return mesh


def node_set(sid, nodes):
    return ["*SET_NODE_LIST", card(sid), *(card(*nodes[i:i + 8]) for i in range(0, len(nodes), 8))]


def parts():
    lines = []
    for pid, (title, thickness) in SHEETS.items():
        lines += ["*PART", title, card(pid, pid, 1), "*SECTION_SHELL", card(pid, 16, 0.833, 3),
                  card(thickness, thickness, thickness, thickness)]
    return lines + ["*MAT_PIECEWISE_LINEAR_PLASTICITY", card(1, 7.85e-06, 210.0, 0.3, 0.35, 1.0), "", "", ""]


def main_lines(held, moving):
    lines = ["*KEYWORD", "*TITLE", "bumper beam against crash box", "*CONTROL_TERMINATION", card(END), "*CONTROL_ENERGY",
             card(2, 2, 2)]
    for keyword in ("GLSTAT", "SLEOUT", "MATSUM", "RCFORC"):
        lines += [f"*DATABASE_{keyword}", card(0.01)]
    lines += ["*DATABASE_BINARY_D3PLOT", card(0.1), *parts(), *node_set(1, held), "*BOUNDARY_SPC_SET",
              card(1, 0, 1, 1, 1, 1, 1, 1), *node_set(2, moving), "*INITIAL_VELOCITY", card(2), card(-SPEED, 0.0, 0.0),
              "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID", f"{1:>10}all parts", card(0, 0, 5), card(0.1), card(1.0, 1.0),
              card(0), card(0.0, 0, 0, 1)]
    return lines + ["*INCLUDE", "box.inc", "*INCLUDE", "beam.inc", "*END"]


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    box, held, length = crash_box()
    beam = bumper_beam(length)
    texts = {"bumper.k": "\n".join(main_lines(held, sorted(beam.nodes))) + "\n", "box.inc": box.mesh_text(), "beam.inc": beam.mesh_text()}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="ascii")


if __name__ == "__main__":
    sys.exit(generated.main(__doc__, "make_tutorial.py", "data/tutorial", write_all))
