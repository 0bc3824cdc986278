"""Corrections of decks."""
from __future__ import annotations

import os

from . import _core, files
from .errors import Error
from .options import common
from .tables import Records

RESULTS = ("contacts", "walls", "moved", "unfixed", "proposals", "changed", "diagnostics")


class Fix:
    """A correction of a deck; nothing is written but by write(). Lengths and coordinates in the deck's units.

    solved: nothing penetrates any more. contacts, walls: before and after. moved: nodes with start and end (3
    coordinates). unfixed: nodes that penetrate afterwards, and why. proposals: what else would remove penetrations.
    changed: files with their new `content` (bytes). largest_move, total_move, elements_touched, elements_worsened,
    cut_short (the search took too long), notes, diagnostics, files.
    """

    def __init__(self, core):
        self._core = core

    def __getattr__(self, name):
        if name in RESULTS:
            return Records(getattr(self._core, name))
        if name in _core.Fix._fields:
            return getattr(self._core, name)
        raise AttributeError(f"a Fix has no {name!r}")

    def __dir__(self):
        return [*super().__dir__(), *_core.Fix._fields]

    def __repr__(self):
        return (f"<Fix: {'solved' if self.solved else 'not solved'}, {len(self.moved)} nodes moved by at most "
                f"{self.largest_move:g}>")

    def to_text(self, top=10):
        """As `gapcheck fix` prints it; `top`: nodes and pairs of parts to list."""
        return self._core.text(top)

    def to_json(self):
        """The same as JSON, complete."""
        return self._core.json()

    def write(self, folder) -> list[str]:
        """Writes the changed files into a folder, which is made if it is not there, laid out as beside the main file;
        files from elsewhere keep only their name. Returns their paths.

        Raises Error, before anything is written, if one of them would replace a file of the deck or another one of them.
        """
        folder = os.fsdecode(folder)
        places = [(os.path.join(folder, changed.place), changed.content) for changed in self.changed]
        if len({path for path, _ in places}) < len(places):
            raise Error("two changed files of the deck have this place and name; write their `content` yourself", folder)
        for path, _ in places:
            files.refuse_inputs(path, self.files)
        for path, content in places:
            os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
            files.write(path, content, self.files)
        return [path for path, _ in places]


def _ranges(name, given):
    """Ids and pairs (first, last) as pairs."""
    pairs = []
    for each in [given] if isinstance(given, int) else given:
        first, last = each if isinstance(each, (tuple, list)) and len(each) == 2 else (each, each)
        try:
            pairs.append((int(first.__index__()), int(last.__index__())))
        except AttributeError:
            raise TypeError(f"{name}: ids or pairs (first, last) of ids are needed, not {each!r}") from None
        if max(map(abs, pairs[-1])) >= 2**63:
            raise ValueError(f"{name}: {each!r} is beyond 64 bits")
    return pairs


def fix(deck, *, lock_parts=(), lock_nodes=(), priorities=None, recommended=False, free_welds=False, includes=(),
        skip_missing=False, parameters=(), jobs=0) -> Fix:
    """Moves nodes as little as possible until nothing penetrates initially any more: a Fix. Writes nothing.

    lock_parts, lock_nodes: ids that must not move, or pairs (first, last) of ids. priorities: a dict of factors by part
    id; nodes of a part with a larger one move less. recommended: nodes of contacts with IGNORE = 2 go where the solver
    recommends. free_welds: nodes of spot welds and rivets may move against each other.
    includes, skip_missing, parameters, jobs: as those of audit(). Raises Error if the deck cannot be read in full.
    """
    return Fix(_core.fix_deck(deck, {"lock_parts": _ranges("lock_parts", lock_parts),
                                     "lock_nodes": _ranges("lock_nodes", lock_nodes), "priorities": priorities,
                                     "recommended": recommended, "free_welds": free_welds,
                                     **common(includes, skip_missing, parameters, jobs)}))
