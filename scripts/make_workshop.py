#!/usr/bin/env python3
"""Writes the decks of data/workshop/: rebounds, plates pushed into one another, initial penetrations. Units: mm, ms,
kg, so kN and GPa. Deterministic. docs/workshop/ says what they show, tests/solver/workshop_test.cpp asserts it."""

import sys
import textwrap

sys.dont_write_bytecode = True  # keeps the source tree clean

import generated
from data_decks.deck import Deck, card

DENSITY, STEEL, POISSON = 7.85e-06, 210.0, 0.3
HELD, MOVED = 1, 2  # node sets


class Scene(Deck):
    """A deck that is calculated: materials, conditions and output beside the mesh and one single-surface contact."""

    def __init__(self, name, text, end):
        super().__init__(name, text)
        self.end, self.young, self.masses, self.watched = end, {}, [], []

    def body(self, pid, title, kind="shell", young=STEEL):
        self.part(pid, title, kind)
        self.young[pid] = young

    def hold(self, nodes):
        self.node_set(HELD, nodes)
        self.controls += ["*BOUNDARY_SPC_SET", card(HELD, 0, 1, 1, 1, 1, 1, 1)]

    def drive(self, nodes, way):
        """Moves nodes down at a constant speed by `way` until the end."""
        self.node_set(MOVED, nodes)
        self.controls += ["*BOUNDARY_SPC_SET", card(MOVED, 0, 1, 1, 0, 1, 1, 1),
                          "*BOUNDARY_PRESCRIBED_MOTION_SET", card(MOVED, 3, 2, 1, -1.0),
                          "*DEFINE_CURVE", card(1), f"{0.0:>20}{0.0:>20}", f"{10 * self.end:>20g}{10 * way:>20g}"]

    def throw(self, nodes, speed, mass):
        """Nodes that fly down and carry `mass` each."""
        self.node_set(MOVED, nodes)
        self.controls += ["*INITIAL_VELOCITY", card(MOVED), card(0.0, 0.0, -speed)]
        self.masses = [(n, mass) for n in nodes]
        self.watched = nodes

    def node_set(self, sid, nodes):
        self.controls += ["*SET_NODE_LIST", card(sid)]
        self.controls += [card(*nodes[i:i + 8]) for i in range(0, len(nodes), 8)]

    def touch(self, sst=0.0, soft=0, snlog=0, ignore=0, sldthk=0.0):
        """One contact of all parts."""
        self.contacts.append("\n".join([
            "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID", f"{1:>10}all parts", card(0, 0, 5, 0, 0, 0, 1, 1), card(0.0),
            card(1.0, 1.0, sst, sst), card(soft), card(0.0, 0, 0, snlog, 0, 0, sldthk), card(1, ignore)]))

    def write(self, folder):
        (folder / f"{self.name}.k").write_text(self.deck_text(), encoding="ascii")

    def deck_text(self):
        text = textwrap.fill(" ".join(self.text.split()), width=78).splitlines()
        lines = ["*KEYWORD", *(f"$ {line}".rstrip() for line in (self.name, "", *text)), "*TITLE",
                 f"gapcheck workshop {self.name}", "*CONTROL_TERMINATION", card(self.end)]
        for keyword in ("GLSTAT", "SLEOUT", "NCFORC") + (("NODOUT",) if self.watched else ()):
            lines += [f"*DATABASE_{keyword}", card(round(self.end / 400, 9))]
        if self.watched:
            lines += ["*DATABASE_HISTORY_NODE", card(*self.watched)]
        for pid, title, kind, thickness, optt, diameter in self.parts:
            part = self.part_lines(pid, title, kind, thickness, optt, diameter)
            part[2] = card(pid, pid, pid)
            lines += part + ["*MAT_ELASTIC", card(pid, DENSITY, self.young[pid], POISSON)]
        lines += self.mesh_lines()
        if self.masses:
            lines.append("*ELEMENT_MASS")
            lines += [f"{i + 1:>8}{node:>8}{mass:>16}" for i, (node, mass) in enumerate(self.masses)]
        return "\n".join(lines + self.controls + self.contacts + ["*END"]) + "\n"


# Rebound: a shell is thrown at a plate ------------------------------------------------------------------------------

MASS = 0.003


def over_plate(name, text, gap, speed, end, young=STEEL, second=None, **contact):
    """One 5 x 5 shell `gap` above the middle segment of a held plate of 3 x 3 segments of 10; `second`: height of one
    more such plate. No node of a plate is in the thrown shell's band."""
    deck = Scene(name, text, end)
    deck.body(1, "held plate", young=young)
    deck.body(2, "thrown shell")
    held = list(deck.plate(1, (3, 3), 10.0, (0.0, 0.0, 0.0)).values())
    thrown = list(deck.plate(2, (1, 1), 5.0, (12.5, 12.5, gap)).values())
    if second is not None:
        deck.body(3, "second held plate")
        held += deck.plate(3, (3, 3), 10.0, (0.0, 0.0, second)).values()
    deck.hold(held)
    deck.throw(thrown, speed, MASS)
    deck.touch(**contact)
    return deck


def rebound(name, text, **more):
    return over_plate(name, text, 3.0, 20.0, 0.25, **more)


def rebounds():
    yield rebound("rebound_reference", """A shell thrown at a held plate of steel, both 1 thick. Contact distance 1,
        SOFT = 0.""")
    yield rebound("rebound_double", "rebound_reference with SST = 2: contact distance 2.", sst=2.0)
    yield rebound("rebound_half", "rebound_reference with SST = 0.5: contact distance 0.5.", sst=0.5)
    yield rebound("rebound_thin", """rebound_reference with SST = 0.15: nodes are released before the contact has
        stopped them.""", sst=0.15)
    yield rebound("rebound_soft_plate", """rebound_reference with a plate of a hundredth of the stiffness, SOFT = 0:
        the weaker side decides, the shell passes through.""", young=STEEL / 100)
    yield rebound("rebound_soft_plate_soft_1", "rebound_soft_plate with SOFT = 1: the shell rebounds.",
                  young=STEEL / 100, soft=1)


# Push: bodies are pushed into one another by a prescribed motion -----------------------------------------------------

def lay(deck, pid, kind, cells, size, origin, faces_up):
    """A plate of shells, or of bricks 1 thick whose facet that the other body meets is where the shells would be."""
    if kind == "shell":
        return list(deck.plate(pid, (cells, cells), size, origin).values())
    x, y, z = origin
    return list(deck.block(pid, (cells, cells, 1), (size, size, 1.0), (x, y, z - 1.0 if faces_up else z)).values())


def push(name, text, upper, lower, size=5.0, **contact):
    """A 10 x 10 plate 1.2 above a held one of 20 x 20, pushed down by 2.15. Both keep their shape. No node of the lower
    one lies less than 1 beside the upper one."""
    deck = Scene(name, text, 0.215)
    deck.body(1, "held lower", lower)
    deck.body(2, "pushed upper", upper)
    held = lay(deck, 1, lower, round(20 / size), size, (0.0, 0.0, 0.0), True)
    moved = lay(deck, 2, upper, round(10 / size), size, (6.3, 6.3, 1.2), False)
    deck.hold(held)
    deck.drive(moved, 2.15)
    deck.touch(snlog=1, **contact)
    return deck


def pushes():
    yield push("push_shell_shell", "Curve A: shells 1 thick are pushed into shells.", "shell", "shell")
    yield push("push_shell_solid", "Curve B: shells 1 thick are pushed into bricks 1 thick.", "shell", "solid")
    yield push("push_solid_solid", "Curve C: bricks 1 thick are pushed into bricks.", "solid", "solid")
    yield push("push_shell_solid_sldthk", "Curve D: push_shell_solid with SLDTHK = 1.", "shell", "solid", sldthk=1.0)
    yield push("push_solid_solid_sldthk", "push_solid_solid with SLDTHK = 1.", "solid", "solid", sldthk=1.0)
    yield push("push_shell_shell_fine", "push_shell_shell with half the element size.", "shell", "shell", size=2.5)


# Penetration: a shell that starts inside the contact thickness ------------------------------------------------------

def penetration(name, text, gap=0.8, end=0.1, **more):
    return over_plate(name, text, gap, 5.0, end, **more)


def penetrations():
    yield penetration("penetration_snlog_0", """A shell starts 0.2 deep in the contact thickness of a plate and moves
        towards it. IGNORE = 0, SNLOG = 0: it is moved out without force.""")
    yield penetration("penetration_snlog_1", """penetration_snlog_0 with SNLOG = 1: full force at once; the shell is
        thrown off.""", snlog=1)
    for ignore in (1, 2):
        yield penetration(f"penetration_ignore_{ignore}", f"""penetration_snlog_0 with IGNORE = {ignore}: force only
            beyond the depth of the start.""", ignore=ignore)
    yield penetration("penetration_mid_face", """A shell starts 0.85 deep, more than 0.4 x (1 + 1): released. It passes
        the plate, meets a second one, and comes back into contact with the first from below.""",
                      gap=0.15, end=1.3, second=-4.0)


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for deck in [*rebounds(), *pushes(), *penetrations()]:
        deck.write(folder)


if __name__ == "__main__":
    sys.exit(generated.main(__doc__, "make_workshop.py", "data/workshop", write_all))
