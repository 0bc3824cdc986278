"""The start of a run: what contacts do before the first cycle."""
from __future__ import annotations

from functools import cached_property

import numpy

from . import _core, files
from .columns import AXES, Columns, _enumeration
from .options import common
from .tables import Records

StartCause = _enumeration("StartCause", _core.names["cause"], "What moved a node before the first cycle.")

RECORDS = ("contacts", "pairs", "repeats", "elements", "crossings", "refused", "diagnostics")
PLAIN = ("input", "clean", "files", "moved", "largest_move", "energy", "touched", "changed", "collapsed", "kinetic",
         "first_step", "step_before", "step_after", "first_cycle", "notes", "expected")


class StartMoves(Columns):
    """n moves of nodes in the order in which they happen; a node may be moved more than once. Coordinates of the deck."""

    _words = {"cause": "cause"}
    _parts = {"start": AXES, "end": AXES}

    contact: numpy.ndarray  # n positions in Start.contacts
    node: numpy.ndarray  # n ids
    part: numpy.ndarray  # n ids, of the node; 0: not known
    other_part: numpy.ndarray  # n ids, of the segment; 0: not known
    start: numpy.ndarray  # n × 3, where the node was
    end: numpy.ndarray  # n × 3, where it is then
    cause: numpy.ndarray  # n codes of StartCause

    @property
    def move(self):
        """n × 3: end minus start."""
        return self.end - self.start


class StartNodes(Columns):
    """n nodes that penetrate as the first cycle begins, beyond the rounding of their coordinates; by contact, deepest
    first, then by node. Lengths and energies in the deck's units."""

    _words = {"outcome": "outcome"}

    contact: numpy.ndarray  # n positions in Start.contacts
    node: numpy.ndarray  # n ids
    part: numpy.ndarray  # n ids, of the node; 0: not known
    other_part: numpy.ndarray  # n ids, of the segment; 0: not known
    outcome: numpy.ndarray  # n codes of Outcome: KEPT (forgiven by IGNORE), FORCED or RELEASED
    depth: numpy.ndarray  # n lengths: forgiven; that the spring pushes against; of the way back out
    contact_distance: numpy.ndarray  # n lengths; 0: without contact thickness
    energy: numpy.ndarray  # n, of the spring; 0: none, or not known
    to_release: numpy.ndarray  # n lengths: further penetration with which the node is released; infinity: none, not known


class Start:
    """The geometry and the energy with which a run of a deck starts. Lengths and energies in the deck's units.

    clean: every contact starts clean and the moves spoil nothing. contacts: StartContact by deck order (score, moved,
    kept, forced, released, deepest_kept, energy, …); pairs: the same for two parts in a contact.
    repeats: nodes that are moved more than once. elements: changed or collapsed ones. crossings: elements that cross at
    the start and not in the deck. expected: what will meet along straight lines (ExpectedContacts); None: nothing moves.
    moved: nodes that are not where the deck has them; largest_move: of them. energy: of all contact springs.
    touched, changed, collapsed: numbers of elements. kinetic, first_step: of the first cycle; None: not calculated.
    step_before, step_after: smallest step of an element in the deck and at the start; infinity: none.
    first_cycle: contacts are followed through it, else through their initialisation. refused: why a run refuses the
    deck. notes: input that is not supported. input, files, diagnostics: as those of a Report.
    """

    def __init__(self, core):
        self._core = core

    def __getattr__(self, name):
        if name in RECORDS:
            return Records(getattr(self._core, name))
        if name in PLAIN:
            return getattr(self._core, name)
        raise AttributeError(f"a Start has no {name!r}")

    def __dir__(self):
        return [*super().__dir__(), *RECORDS, *PLAIN]

    def __repr__(self):
        clean = sum(contact.score == "starts clean" for contact in self.contacts)
        return (f"<Start of {self.input}: {clean} of {len(self.contacts)} contacts start clean; {self.moved} nodes moved "
                f"by at most {self.largest_move:g}, energy {self.energy:g}>")

    @cached_property
    def moves(self) -> StartMoves:
        """Moves of nodes as parallel arrays; moves.to_numpy() is a structured array."""
        return StartMoves(self._core.moves, self.contacts, self.files)

    @cached_property
    def nodes(self) -> StartNodes:
        """Nodes that penetrate as the first cycle begins, as parallel arrays."""
        return StartNodes(self._core.nodes, self.contacts, self.files)

    @cached_property
    def node(self) -> numpy.ndarray:
        """n ids of all nodes of the deck."""
        return self._core.node

    @cached_property
    def deck_points(self) -> numpy.ndarray:
        """n × 3: where the deck has them."""
        return self._core.deck_points

    @cached_property
    def points(self) -> numpy.ndarray:
        """n × 3: where they are in the first cycle."""
        return self._core.points

    def _write(self, text, path, option):
        if text is None:
            raise ValueError(f"nothing is kept to write it from; give start() {option}=True")
        if path is None:
            return text
        files.write(path, text.encode("utf-8", "replace"), self.files)
        return None

    def to_text(self, path=None, *, top=10) -> str | None:
        """As `gapcheck start` prints it: str, or written to a path. top: pairs of parts, elements and nodes to list."""
        return self._write(self._core.text(top), path, "")

    def to_json(self, path=None) -> str | None:
        """JSON of schema gapcheck-start/1: str, or written to a path."""
        return self._write(self._core.json(), path, "")

    def to_html(self, path=None) -> str | None:
        """One page for a browser, after start(picture=True): the mesh in the deck and at the start, and the findings of
        the deck; str, or written to a path."""
        return self._write(self._core.html(), path, "picture")

    def to_vtu(self, path=None) -> str | None:
        """A grid for ParaView with the moves, after start(mesh=True): str, or written to a path."""
        return self._write(self._core.vtu(), path, "mesh")


def start(deck, *, picture=False, mesh=False, includes=(), skip_missing=False, parameters=(), jobs=0) -> Start:
    """Follows the contacts of a deck through the first cycle of its run: a Start. Writes nothing.

    picture, mesh: audit the deck as well and keep what to_html(), to_vtu() need.
    includes, skip_missing, parameters, jobs: as those of audit(). Raises Error, with file and line, if the deck cannot be
    read in full. A deck that run() refuses is followed as far as possible; `refused` says why.
    """
    return Start(_core.start_deck(deck, {"picture": picture, "mesh": mesh,
                                         **common(includes, skip_missing, parameters, jobs)}))
