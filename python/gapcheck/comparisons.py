"""Comparisons of decks and runs."""
from __future__ import annotations

from . import _core
from .options import common
from .report import Report
from .tables import Records


class Comparison:
    """Two compared sources."""

    def __init__(self, core):
        self._core = core
        self.first, self.second = Report(core.first), Report(core.second)

    def __repr__(self):
        return f"<Comparison of {self.first.input} and {self.second.input}: {'equal' if self.equal else 'different'}>"

    @property
    def equal(self):
        """No difference in penetrations, ties, curves and motion."""
        return self._core.equal

    @property
    def complete(self):
        """False: one of the sources could not be read in full."""
        return self._core.complete

    @property
    def contacts(self):
        """How the records of each contact agree."""
        return Records(self._core.contacts)

    @property
    def differences(self):
        """Nodes whose penetration differs: contact and node (ids), first and second (depths, None: no penetration)."""
        return Records(self._core.differences)

    @property
    def tie_differences(self):
        """Nodes that are untied in one source only, or for another reason."""
        return Records(self._core.tie_differences)

    @property
    def curves(self):
        """Of two directories with result files: pairs, only_first, only_second, agree, differ; else None."""
        return self._core.curves

    @property
    def motion(self):
        """Of two directories with a d3plot: times, parts, largest_displacement; else None."""
        return self._core.motion

    def to_text(self, top=10):
        """As `gapcheck compare` prints it, with the `top` largest differences."""
        return self._core.text(top)

    def to_json(self):
        """The same as JSON, complete."""
        return self._core.json()


def compare(first, second, *, tolerance=0.0, contacts=(), message_tables=(), curves=True, curve_tolerance=1e-3,
            curve_names=(), includes=(), skip_missing=False, parameters=(), jobs=0) -> Comparison:
    """Compares two decks, two runs, or a deck and a run, node by node; of two directories also curves and motion.

    first, second: a deck, a file of the solver or the directory of a run. tolerance: of depths, in the deck's unit.
    contacts: only these ids. curves: compare curves and d3plots. curve_tolerance: share of the larger one by which
    curves may differ. curve_names: only curves with one of these texts in their name. message_tables: as read_run().
    includes, skip_missing, parameters, jobs: as those of audit(). Returns a Comparison.
    """
    return Comparison(_core.compare(first, second,
                                    {"tolerance": tolerance, "contacts": contacts, "message_tables": message_tables,
                                     "curves": curves, "curve_tolerance": curve_tolerance, "curve_names": curve_names,
                                     **common(includes, skip_missing, parameters, jobs)}))
