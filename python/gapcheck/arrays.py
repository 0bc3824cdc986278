"""Audits of meshes that never were a deck."""
from __future__ import annotations

import numpy

from . import _core
from .audits import audit_options
from .report import Report


def _array(name, given, kinds, wanted):
    if isinstance(given, numpy.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array has no values in some places; fill it")
    array = numpy.asarray(given)
    if array.size and array.dtype.kind not in kinds:
        raise TypeError(f"{name}: {wanted} are needed, not {array.dtype}")
    return array


def _ids(name, given):
    array = _array(name, given, "iu", "whole numbers")
    if array.dtype.kind == "u" and array.size and int(array.max()) > numpy.iinfo(numpy.int64).max:
        raise ValueError(f"{name}: numbers beyond 64 bits with a sign")
    return numpy.asarray(array, dtype=numpy.int64, order="C")


def _rows(name, array, widths):
    if array.ndim != 2 or array.shape[1] not in widths:
        wanted = " or ".join(f"n × {width}" for width in widths)
        given = " × ".join(map(str, array.shape)) or "one number"
        raise ValueError(f"{name}: an array of {wanted} is needed, not of {given}")
    return array


def _mesh(points, shells, thickness, part, contact, tracked, reference):
    numbers = _array("points", points, "fiu", "numbers")
    points = _rows("points", numpy.asarray(numbers, dtype=numpy.float64, order="C"), (3,))
    shells = _rows("shells", _ids("shells", shells), (3, 4))
    if shells.shape[1] == 3:
        shells = numpy.ascontiguousarray(shells[:, (0, 1, 2, 2)])
    parts = _ids("part", [] if part is None else part)
    if parts.ndim != 1 or part is not None and len(parts) != len(shells):
        raise ValueError(f"part: {len(shells)} ids are needed, one for each shell, not an array of {parts.shape}")
    by_part = isinstance(thickness, dict)
    return points, shells, parts, {"thickness": None if by_part else thickness,
                                   "part_thickness": thickness if by_part else None, "contact": contact,
                                   "tracked": tracked, "reference": reference}


def audit_arrays(points, shells, thickness, part=None, *, contact=None, tracked=(), reference=(), **options) -> Report:
    """Audits shells that never were a deck, in one contact: a Report. Ids of nodes and shells in it are rows plus 1.

    points: n × 3 coordinates. shells: m × 4 rows of points, from 0; a triangle repeats its last one. m × 3: triangles.
    thickness: a length above 0, or a dict of them by part id.
    part: m part ids, 1 or more; None: all shells belong to part 1.
    contact: keyword after *CONTACT_, of a type without cards of its own; None: AUTOMATIC_SINGLE_SURFACE.
    tracked, reference: part ids of either side of the contact; empty: all parts. A single surface has one, `tracked`.
    options: as those of audit().

    Any numeric arrays will do; what is not float64 or int64 without gaps is copied. Raises ValueError for other shapes,
    TypeError for other types, Error with array and row for rows of points that are not there and coordinates that are
    not numbers from -1e30 to 1e30. Files and lines of the report are those of shell_deck(). The material is steel in mm, t and s.
    """
    given = audit_options(**options)
    mesh = _mesh(points, shells, thickness, part, contact, tracked, reference)
    return Report(_core.audit_arrays(*mesh, given), given["picture"])


def shell_deck(points, shells, thickness, part=None, *, contact=None, tracked=(), reference=()) -> str:
    """The keyword deck that audit_arrays() audits, as str. Numbers keep all digits."""
    return _core.shell_deck(*_mesh(points, shells, thickness, part, contact, tracked, reference))
