"""Runs of the verification solver, and what is read of runs."""
from __future__ import annotations

from collections.abc import Mapping

from . import _core
from .options import common
from .report import Report
from .tables import Records


def run(deck, directory, *, until=0.0, cycles=0, ignore_unsupported=False, printed_stiffness=False, binout=False,
        replace_foreign=False, includes=(), skip_missing=False, parameters=(), jobs=0, watch=None) -> _core.RunSummary:
    """Runs a deck with the verification solver and writes messag, d3hsp, glstat, rcforc, d3plot, … into a directory.

    until: end time in the deck's unit; 0: that of the deck. cycles: ends after so many; 0: as the deck says.
    ignore_unsupported: run without the keywords that are not calculated; else they are an Error.
    printed_stiffness: contact springs as stiff as the surface time step that LS-DYNA prints has them.
    binout: all files of curves also in a binout. replace_foreign: replace results that gapcheck did not write.
    includes, skip_missing, parameters, jobs: as those of audit().
    watch: called with a RunState in every cycle (time, step, kinetic, contacts, …). Returning False ends the run one
        cycle later, in order; what it raises ends it too, and is raised.

    Returns a RunSummary: end ("time", "cycles", "energy", "step", "stopped", "failed"), state (the last one), energies,
    files, diagnostics. Raises Error if the run cannot begin. Ctrl-C ends a run in order, then raises KeyboardInterrupt.
    """
    return _core.run_deck(deck, directory,
                          {"until": until, "cycles": cycles, "ignore_unsupported": ignore_unsupported,
                           "printed_stiffness": printed_stiffness, "binout": binout, "replace_foreign": replace_foreign,
                           "watch": watch, **common(includes, skip_missing, parameters, jobs)})


def read_run(paths, *, d3hsp=None, d3plot=None, message_tables=(), contacts=(), ptol=None, rtol=None, select=(),
             ignore=(), jobs=0) -> Report:
    """Reads what the solver's files say about the contacts of one run: a Report with `run` set.

    paths: the directory of a run, or one or more of its messag, mesNNNN, d3hsp, status.out.
    d3hsp, d3plot: None: those beside the first file. message_tables: files with additions to the known messages.
    contacts, ptol, rtol, jobs: as those of audit(). select, ignore: rules (GC6xx) to judge the run by, or not.

    Report.parts has the energies and momenta of matsum, or of its branch of a binout, as arrays. Ctrl-C ends the reading.
    """
    return Report(_core.read_run(paths, {"d3hsp": d3hsp, "d3plot": d3plot, "message_tables": message_tables,
                                         "contacts": contacts, "ptol": ptol, "rtol": rtol, "select": select,
                                         "ignore": ignore, "jobs": jobs}))


read_log = read_run


class Curves(Mapping):
    """The curves of a run by their names: curves["glstat kinetic energy"].values, curves["matsum part 2 x-momentum"], … A
    curve has name, file, quantity,
    contact (id; 0: of none), times and values (n, ascending times, read-only), not_numbers (NaN values left out)."""

    def __init__(self, core):
        self._core = core
        self._curves = {curve.name: curve for curve in core.curves}

    def __getitem__(self, name):
        return self._curves[name]

    def __iter__(self):
        return iter(self._curves)

    def __len__(self):
        return len(self._curves)

    def __repr__(self):
        return f"<Curves: {len(self)}>"

    @property
    def complete(self):
        """False: a file could not be read in full."""
        return self._core.complete

    @property
    def diagnostics(self):
        """About the files: errors first."""
        return Records(self._core.diagnostics)


def read_motion(path, *, states=(), velocities=True) -> _core.Motion:
    """Reads where the nodes are in the states of a d3plot.

    path: the first file of the d3plot, or the directory of a run. states: positions of states, from 0; empty: all.
    velocities: read them too.

    Returns a Motion of read-only arrays in the model's units: node (n ids), start (n × 3, the mesh before the states), times
    (T), positions and velocities (T × n × 3; 0 × n × 3 without velocities). Memory: 24 bytes per node and state, with
    velocities 48. Raises Error for files that are damaged, compressed or no d3plot.
    """
    return _core.read_motion(path, {"states": states, "velocities": velocities})


def read_curves(directory) -> Curves:
    """Reads energies, contact forces and energies, motion of nodes, energies and momenta of parts, … from the text files in
    a run's directory, or else from its binout: Curves, in the model's units."""
    return Curves(_core.read_curves(directory))
