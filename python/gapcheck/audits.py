"""Audits of decks."""
from __future__ import annotations

import os

from . import _core
from .options import common, days
from .report import Report
from .tables import Records


def audit_options(*, select=(), ignore=(), contacts=(), parts=(), ptol=None, rtol=None, ratio=None, severities=None,
                  millimetre=None, today=None, includes=(), skip_missing=False, parameters=(), exact=False,
                  picture=False, mesh=False, jobs=0, progress=None):
    """The options of all audits as the library takes them."""
    return {"select": select, "ignore": ignore, "contacts": contacts, "parts": parts, "ptol": ptol, "rtol": rtol,
            "ratio": ratio, "severities": severities, "millimetre": millimetre, "today": days(today), "exact": exact,
            "picture": picture, "mesh": mesh, "progress": progress, **common(includes, skip_missing, parameters, jobs)}


def audit(deck, *, select=(), ignore=(), contacts=(), parts=(), ptol=None, rtol=None, ratio=None, severities=None,
          millimetre=None, today=None, includes=(), skip_missing=False, parameters=(), exact=False, picture=False,
          mesh=False, jobs=0, progress=None) -> Report | list[Report]:
    """Audits the contacts of a keyword deck and its includes: a Report; of a list of paths: a list of Reports.

    deck: path (str, bytes, os.PathLike), or a list of paths, audited one after the other.
    select, ignore: ids, names or beginnings of either of rules to look for, or not to ("GC1", "untied-node").
    contacts: only these contact ids. parts: only findings that involve one of these part ids.
    ptol: only penetrations deeper than this. rtol: only those with a smaller remaining distance. ratio: only those
        deeper than this share of the contact distance. Lengths in the deck's unit.
    severities: "note", "warning" or "error" by rule, instead of the rules' own.
    millimetre: length of a millimetre in the deck's unit; None: inferred.
    today: datetime.date for ignores with a last day; None: the local day.
    includes: folders to look for include files in. skip_missing: a missing one is a warning. parameters: a dict, or a
        list of "NAME=VALUE", in place of the deck's.
    exact: no floating-point filter: slow, same results. jobs: threads at most; 0: all processors.
    picture: keep what to_html() needs to draw the mesh. mesh: fill Report.mesh.
    progress: called as progress(step, done, all) before each step: "read", "model", the ids of rules, "records".
        Returning False stops the audit (Error); what it raises is raised.

    Raises Error if the deck cannot be opened or an option names what is not there, TypeError for values of other types.
    With faults in the deck's text there is a report with complete == False and the faults in `diagnostics`. Ctrl-C ends
    an audit at its next step.
    """
    options = audit_options(select=select, ignore=ignore, contacts=contacts, parts=parts, ptol=ptol, rtol=rtol,
                            ratio=ratio, severities=severities, millimetre=millimetre, today=today, includes=includes,
                            skip_missing=skip_missing, parameters=parameters, exact=exact, picture=picture, mesh=mesh,
                            jobs=jobs, progress=progress)
    if isinstance(deck, (list, tuple)):
        return [Report(_core.audit_deck(path, options), picture) for path in deck]
    return Report(_core.audit_deck(deck, options), picture)


def audit_text(text, name="deck.k", **options) -> Report:
    """Audits a deck in memory: a Report.

    text: str, or the bytes of the deck. name: replaces its path; includes are looked up in the working directory.
    options: as those of audit().
    """
    given = audit_options(**options)
    if isinstance(text, str):
        text = text.encode("utf-8", "surrogateescape")
    if not isinstance(text, (bytes, bytearray, memoryview)):
        raise TypeError(f"text: a str or bytes is needed, not {type(text).__name__}")
    return Report(_core.audit_text(bytes(text), os.fspath(name), given), given["picture"])


def rules() -> Records:
    """All rules by id: Records with id, name, severity, summary, page (markdown) and of_runs."""
    return Records(_core.rules())
