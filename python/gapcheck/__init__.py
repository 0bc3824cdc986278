"""Finds the contact problems of LS-DYNA models: initial penetrations, crossings, ties that do not tie.

    import gapcheck
    report = gapcheck.audit("model.k")
    report.penetrations.depth.max()

Arrays are those of the library, without a copy: they cannot be written, and keep the report alive. Lengths are in the
deck's unit, positions in its coordinates; ids are those of the deck.
"""
from ._core import version as __version__
from .arrays import audit_arrays, shell_deck
from .audits import audit, audit_text, rules
from .columns import Columns, Feature, Outcome, PenetrationKind, Penetrations, ThicknessRule, TieReason, Ties
from .comparisons import Comparison, compare
from .errors import Error
from .fixes import Fix, fix
from .mesh import ElementKind, Mesh
from .report import Report
from .runs import Curves, read_curves, read_log, read_motion, read_run, run
from .starts import Start, StartCause, StartMoves, StartNodes, start
from .tables import Records

__all__ = ["Columns", "Comparison", "Curves", "ElementKind", "Error", "Feature", "Fix", "Mesh", "Outcome",
           "PenetrationKind", "Penetrations", "Records", "Report", "Start", "StartCause", "StartMoves", "StartNodes", "ThicknessRule",
           "TieReason", "Ties", "__version__", "audit", "audit_arrays", "audit_text", "compare", "fix", "read_curves",
           "read_log", "read_motion", "read_run", "rules", "run", "shell_deck", "start"]
