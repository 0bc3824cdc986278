"""What an audit or a run reports."""
from __future__ import annotations

from functools import cached_property

import numpy

from . import _core, files, html, pyvista_grid
from .columns import Penetrations, Ties
from .mesh import Mesh
from .tables import Records


class Report:
    """Everything that one source reports: a deck that was audited, or the files of a run that were read."""

    def __init__(self, core, picture=False):
        self._core, self._picture = core, bool(picture)

    def __repr__(self):
        totals = self.totals
        return (f"<Report of {self.input}: {totals.errors} errors, {totals.warnings} warnings, {totals.notes} notes; "
                f"{len(self.penetrations)} penetrations, {len(self.ties)} ties, {len(self.contacts)} contacts"
                f"{'' if self.complete else '; not complete, see diagnostics'}>")

    def _repr_html_(self):
        return html.summary(self, self.to_html() if self._picture else None)

    @property
    def source(self) -> str:
        """"deck" or "messag"."""
        return self._core.source

    @property
    def input(self) -> str:
        """The path as it was given."""
        return self._core.input

    @property
    def model(self) -> _core.ModelCounts:
        """Size of a deck: nodes, shells, solids, beams, parts, contacts, …; zeros: not known."""
        return self._core.model

    @cached_property
    def files(self) -> tuple[str, ...]:
        """Paths that were read; what `file` of penetrations and ties counts."""
        return self._core.files

    @cached_property
    def contacts(self) -> Records:
        """Contact definitions in deck order, with the numbers of what was found in them."""
        return Records(self._core.contacts)

    @cached_property
    def penetrations(self) -> Penetrations:
        """Penetrations as parallel arrays."""
        return Penetrations(_core.penetration_columns(self._core), self.contacts, self.files)

    @cached_property
    def ties(self) -> Ties:
        """Nodes that did not tie, or tied with a distance, as parallel arrays."""
        return Ties(_core.tie_columns(self._core), self.contacts, self.files)

    @cached_property
    def findings(self) -> Records:
        """All other findings, by rule."""
        return Records(self._core.findings)

    @property
    def totals(self) -> _core.Totals:
        """Numbers of errors, warnings and notes, penetrations and ties included."""
        return self._core.totals

    @property
    def ignored(self) -> int:
        """Findings that the deck's comments leave out on purpose."""
        return self._core.ignored

    @property
    def predicted(self) -> _core.Timesteps | None:
        """Time steps computed from a deck (contact, element, surfaces); None: no rule asked for them."""
        return self._core.predicted

    @property
    def run(self) -> _core.SolverRun | None:
        """What the solver's files say of the whole run; None: none were read."""
        return self._core.run

    @cached_property
    def parts(self) -> _core.PartHistory | None:
        """Energies and momenta of P parts at T times of a run, in the model's units: part (P ids), title, times (T),
        internal, kinetic, hourglass, eroded_internal, eroded_hourglass (T × P), momentum, velocity (T × P × 3), read-only;
        NaN where the file has no number. From matsum or its branch of a binout; None: there is neither."""
        return self._core.parts

    @property
    def complete(self) -> bool:
        """False: the input could not be read in full; then at least one diagnostic is an error."""
        return self._core.complete

    @cached_property
    def diagnostics(self) -> Records:
        """About the input: errors first, then by file and line; at most 1000."""
        return Records(self._core.diagnostics)

    @property
    def diagnostics_left_out(self) -> int:
        """How many there are beyond these."""
        return self._core.diagnostics_left_out

    @cached_property
    def mesh(self) -> Mesh | None:
        """The elements of the deck; None without audit(mesh=True)."""
        columns = _core.mesh_columns(self._core)
        return None if columns is None else Mesh(columns)

    def part_pairs(self):
        """Penetrations by pairs of parts as a pandas.DataFrame, the deepest first: part, other_part (ids, the smaller
        one first; 0: unknown), penetrations, deepest, node (id, of the deepest). Needs pandas."""
        import pandas
        found = self.penetrations
        pairs = numpy.sort(numpy.stack([found.part, found.element_part], axis=1), axis=1)
        frame = pandas.DataFrame({"part": pairs[:, 0], "other_part": pairs[:, 1], "depth": found.depth,
                                  "node": found.node})
        frame = frame.sort_values("depth", ascending=False, kind="stable")
        groups = frame.groupby(["part", "other_part"], sort=False)
        result = groups.agg(penetrations=("depth", "size"), deepest=("depth", "first"), node=("node", "first"))
        return result.reset_index()

    def _write(self, form, path, options=None):
        content = _core.write(self._core, form, options or {})
        if path is None:
            return content.decode("utf-8", "replace")
        files.write(path, content, self.files)
        return None

    def to_text(self, path=None, *, top=5, list=False, statistics=False) -> str | None:
        """For people, as `gapcheck audit` prints it: str, or written to a path. top: findings per contact or rule;
        list: all of them. Like all to_…() with a path, raises Error rather than writing over a file that was read."""
        return self._write("text", path, {"top": top, "list": list, "statistics": statistics})

    def to_json(self, path=None, *, statistics=False) -> str | None:
        """JSON of schema gapcheck/1: str, or written to a path."""
        return self._write("json", path, {"statistics": statistics})

    def to_sarif(self, path=None) -> str | None:
        """SARIF 2.1.0: str, or written to a path."""
        return self._write("sarif", path)

    def to_junit(self, path=None, *, top=5, list=False, fail_on="error") -> str | None:
        """JUnit XML: str, or written to a path. fail_on: least severity that fails a case; "never": none fails."""
        return self._write("junit", path, {"top": top, "list": list, "fail_on": fail_on})

    def to_csv(self, path=None) -> str | None:
        """A table with one line per finding: str, or written to a path."""
        return self._write("csv", path)

    def to_html(self, path=None) -> str | None:
        """One page for a browser, with a picture of the mesh after audit(picture=True): str, or written to a path."""
        return self._write("html", path)

    def to_vtu(self, path=None) -> str | None:
        """A grid for ParaView with depths and vectors, after audit(mesh=True) with the elements: str, or written."""
        return self._write("vtu", path)

    def to_pyvista(self):
        """The mesh as a pyvista.UnstructuredGrid: point data node and depth (the deepest penetration of the node, 0:
        none), cell data element, part, contact, thickness and kind. Needs pyvista and audit(mesh=True)."""
        return pyvista_grid.grid(self)
