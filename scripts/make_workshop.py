#!/usr/bin/env python3
"""Writes the decks of data/workshop/: rebounds, plates pushed into one another, initial penetrations, ties. Units: mm,
ms, kg, so kN and GPa. Deterministic. docs/workshop/ says what they show, tests/solver/workshop_test.cpp asserts it."""

import sys
import textwrap

sys.dont_write_bytecode = True  # keeps the source tree clean

import generated
from data_decks.deck import Deck, card

DENSITY, STEEL, POISSON = 7.85e-06, 210.0, 0.3
HELD, MOVED, JOINED = 1, 2, 3  # node sets


class Scene(Deck):
    """A deck that is calculated: materials, conditions and output beside the mesh and one single-surface contact."""

    def __init__(self, name, text, end):
        super().__init__(name, text)
        self.end, self.young, self.masses, self.watched = end, {}, [], []
        self.poisson = POISSON

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

    def load(self, edge, axis, force, rate):
        """Loads the nodes of an edge evenly with `force` in all, from the start; damps everything by `rate`."""
        share = force / (len(edge) - 1)
        for node in edge:
            self.controls += ["*LOAD_NODE_POINT",
                              card(node, axis, 2, share / 2 if node in (edge[0], edge[-1]) else share)]
        self.controls += ["*DAMPING_GLOBAL", card(0, rate), "*DEFINE_CURVE", card(2), f"{0.0:>20}{1.0:>20}",
                          f"{10 * self.end:>20g}{1.0:>20}"]

    def node_set(self, sid, nodes):
        self.controls += ["*SET_NODE_LIST", card(sid)]
        self.controls += [card(*nodes[i:i + 8]) for i in range(0, len(nodes), 8)]

    def touch(self, sst=0.0, soft=0, snlog=0, ignore=0, sldthk=0.0, keyword="AUTOMATIC_SINGLE_SURFACE"):
        """One contact of all parts."""
        self.contacts.append("\n".join([
            f"*CONTACT_{keyword}_ID", f"{1:>10}all parts", card(0, 0, 5, 0, 0, 0, 1, 1), card(0.0),
            card(1.0, 1.0, sst, sst), card(soft), card(0.0, 0, 0, snlog, 0, 0, sldthk), card(1, ignore)]))

    def tie(self, keyword, a, a_type, sst=0.0, mst=0.0):
        """Ties side A to part 1."""
        self.contacts.append("\n".join([
            f"*CONTACT_TIED_{keyword}_ID", f"{1:>10}tie", card(a, 1, a_type, 3, 0, 0, 1, 1), card(0.0),
            card(1.0, 1.0, sst, mst)]))

    def measure(self, cid, title, a, b=0):
        """A force transducer on part a, or between parts a and b."""
        self.contacts.append("\n".join(["*CONTACT_FORCE_TRANSDUCER_PENALTY_ID", f"{cid:>10}{title}",
                                        card(a, b, 3, 3 if b else 0)]))

    def write(self, folder):
        (folder / f"{self.name}.k").write_text(self.deck_text(), encoding="ascii")

    def deck_text(self):
        text = textwrap.fill(" ".join(self.text.split()), width=78).splitlines()
        lines = ["*KEYWORD", *(f"$ {line}".rstrip() for line in (self.name, "", *text)), "*TITLE",
                 f"gapcheck workshop {self.name}", "*CONTROL_TERMINATION", card(self.end)]
        for keyword in ("GLSTAT", "SLEOUT", "NCFORC") + (("RCFORC",) if len(self.contacts) > 1 else ()) + (("NODOUT",) if self.watched else ()):
            lines += [f"*DATABASE_{keyword}", card(round(self.end / 400, 9))]
        if self.watched:
            lines += ["*DATABASE_HISTORY_NODE", card(*self.watched)]
        for pid, title, kind, thickness, optt, diameter in self.parts:
            part = self.part_lines(pid, title, kind, thickness, optt, diameter)
            part[2] = card(pid, pid, pid)
            lines += part + ["*MAT_ELASTIC", card(pid, DENSITY, self.young[pid], self.poisson)]
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
    yield over_plate("penetration_sandwich", """A shell at rest between two plates, 0.3 deep in the lower one and 0.29 in
        the upper one. It is moved out of the lower plate, into the upper one: its energy comes from nothing.""",
                     0.7, 0.0, 0.1, second=1.41)


# Depth: how deep a contact holds on --------------------------------------------------------------------------------

def depths():
    yield push("push_general", "push_shell_shell with type 26: nodes are released at 200 (1 + 1) only.", "shell", "shell",
               keyword="AUTOMATIC_GENERAL")


# Ties --------------------------------------------------------------------------------------------------------------

LENGTH, WIDTH = 40.0, 20.0


def joint(name, text, kind, axis, force, gap=0.0, end=40.0):
    """Two plates of 40 x 20, 1 thick, one behind the other and `gap` higher: the first held at its back edge, the front
    edge of the second loaded, the edge between them tied to the first. No lateral strain, so that beams are exact."""
    deck = Scene(name, text, end)
    deck.poisson = 0.0
    deck.body(1, "held half")
    deck.body(2, "loaded half")
    size = 5.0
    cells = (round(LENGTH / size), round(WIDTH / size))
    first = deck.plate(1, cells, size, (0.0, 0.0, 0.0))
    second = deck.plate(2, cells, size, (LENGTH, 0.0, gap))
    deck.hold([first[0, j] for j in range(cells[1] + 1)])
    tip = [second[cells[0], j] for j in range(cells[1] + 1)]
    deck.load(tip, axis, force, 1.6)
    deck.watched = [tip[0], first[cells[0], 0]]
    deck.node_set(JOINED, [second[0, j] for j in range(cells[1] + 1)])
    deck.tie(kind, JOINED, 4)
    return deck


def joints():
    yield joint("joint_rotations", """A cantilever of two halves, tied with rotations (type 7), loaded across.""",
                "SHELL_EDGE_TO_SURFACE", 3, 1e-4)
    yield joint("joint_translations", "joint_rotations tied by type 6, which leaves rotations free: a hinge.",
                "NODES_TO_SURFACE", 3, 1e-4, end=8.0)
    yield joint("joint_offset", """Two halves one above the other, tied with an offset of 1 and loaded along: type o7
        leaves the moment of the offset out.""", "SHELL_EDGE_TO_SURFACE_OFFSET", 1, 0.001, gap=1.0)
    yield joint("joint_beam_offset", "joint_offset with type b7, which carries the moment.",
                "SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", 1, 0.001, gap=1.0)


FLANGE = 2.2  # height of what is not meant to tie


def reach(name, text, a, a_type, **thickness):
    """A fine plate over a coarse one that it overhangs: near at z = 1, then a flange at z = 2.2."""
    deck = Scene(name, text, 0.01)
    deck.body(1, "coarse plate")
    deck.body(2, "fine plate")
    coarse = deck.plate(1, (2, 1), 40.0, (0.0, 0.0, 0.0))
    fine = deck.plate(2, (8, 2), 8.0, (31.0, 12.0, 0.0), lambda x, y: 1.0 if x < 52 else FLANGE)
    deck.hold([coarse[0, 0], coarse[0, 1]])
    deck.node_set(JOINED, [fine[i, j] for j in range(3) for i in range(3)])
    deck.tie("SHELL_EDGE_TO_SURFACE", a, a_type, **thickness)
    return deck


def reaches():
    yield reach("tie_by_part", """A fine plate tied by its part: large segments reach far, and nodes beside them are
        named.""", 2, 3)
    yield reach("tie_by_set", "tie_by_part with the set of those nodes that are meant.", JOINED, 4)
    yield reach("tie_negative", "tie_by_part with SST = MST = -1: only the thicknesses decide how far a tie reaches.", 2, 3,
                sst=-1.0, mst=-1.0)


def bracket(name, text, **thickness):
    """A shell that stands 2 above a block of bricks, tied with its moments (type b7)."""
    deck = Scene(name, text, 2.0)
    deck.body(1, "block", "solid")
    deck.body(2, "shell")
    block = deck.block(1, (4, 4, 2), 5.0, (0.0, 0.0, -10.0))
    flap = deck.plate(2, (4, 2), 5.0, (10.0, 5.0, 2.0))
    deck.hold([block[i, j, 0] for j in range(5) for i in range(5)])
    tip = [flap[4, j] for j in range(3)]
    deck.load(tip, 3, 1e-4, 0.0)
    deck.watched = [tip[1]]
    deck.node_set(JOINED, [flap[0, j] for j in range(3)])
    deck.tie("SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", JOINED, 4, **thickness)
    return deck


def brackets():
    yield bracket("tie_reach_sst", "A shell tied to bricks over a gap of 2; SST = -4 makes the tie reach.", sst=-4.0,
                  mst=-0.001)
    yield bracket("tie_reach_mst", "tie_reach_sst with the reach given as MST = -4.", sst=-0.001, mst=-4.0)


# Transducers -------------------------------------------------------------------------------------------------------

def transducers():
    deck = Scene("transducer_sum", """A plate is pushed onto two held ones; force transducers on the plate and between it
        and each of them.""", 0.19)
    for pid, title in ((1, "held left"), (2, "pushed upper"), (3, "held right")):
        deck.body(pid, title)
    held = list(deck.plate(1, (2, 4), 5.0, (0.0, 0.0, 0.0)).values())
    held += deck.plate(3, (2, 4), 5.0, (12.0, 0.0, 0.2)).values()
    moved = list(deck.plate(2, (3, 2), 5.0, (3.7, 6.3, 1.5)).values())
    deck.hold(held)
    deck.drive(moved, 1.0)
    deck.touch(snlog=1)
    deck.measure(2, "all on the upper", 2)
    deck.measure(3, "upper and left", 2, 1)
    deck.measure(4, "upper and right", 2, 3)
    yield deck


def write_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    families = (rebounds, pushes, depths, penetrations, joints, reaches, brackets, transducers)
    for deck in [deck for family in families for deck in family()]:
        deck.write(folder)


if __name__ == "__main__":
    sys.exit(generated.main(__doc__, "make_workshop.py", "data/workshop", write_all,
                            foreign=lambda path: path.parts[0] == "curves"))  # make_reference_curves.py writes them
