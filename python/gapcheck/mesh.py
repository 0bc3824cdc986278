"""The elements of an audited deck."""
import operator

import numpy

from . import _core
from .columns import _enumeration

ElementKind = _enumeration("ElementKind", _core.names["element"], "What an element of a mesh is.")
CORNERS = {ElementKind.SHELL: 4, ElementKind.SOLID: 8, ElementKind.THICK_SHELL: 8, ElementKind.BEAM: 2,
           ElementKind.PARTICLE: 1}

# Numbers of VTK.
VERTEX, LINE, TRIANGLE, QUAD, TETRAHEDRON, HEXAHEDRON = 1, 3, 5, 9, 10, 12


def _kind(given):
    """The ElementKind of a word or a code."""
    words = _core.names["element"]
    if isinstance(given, str):
        if given not in words:
            raise ValueError(f"{given!r} is no kind of element; there are {', '.join(words)}")
        return ElementKind(words.index(given))
    return ElementKind(operator.index(given))


class Mesh:
    """m elements and the n nodes that they have. Shells come first, then solids, thick shells, beams and particles; an
    element with fewer nodes than its kind repeats the last one. Arrays are read-only and keep the report alive."""

    node: numpy.ndarray  # n ids
    points: numpy.ndarray  # n × 3, coordinates of the deck, all finite
    corners: numpy.ndarray  # positions in `node`, element after element
    ends: numpy.ndarray  # m: where each element ends in `corners`
    kind: numpy.ndarray  # m codes of ElementKind
    element: numpy.ndarray  # m ids
    part: numpy.ndarray  # m ids; 0: none
    contact: numpy.ndarray  # m ids: the first contact with a segment of the element; 0: none
    thickness: numpy.ndarray  # m lengths: the largest contact thickness of all contacts; 0: none
    left_out: int  # elements with a node that has no finite coordinates

    def __init__(self, arrays):
        self.__dict__.update(arrays)

    def __len__(self):
        return len(self.element)

    def __repr__(self):
        return f"<Mesh: {len(self.node)} nodes, {len(self)} elements>"

    def elements(self, kind):
        """The elements of one kind as a slice of all arrays with m entries: kind is "shell", ElementKind.SHELL, …"""
        wanted = _kind(kind)
        first, end = numpy.searchsorted(self.kind, (wanted, wanted + 1))
        return slice(int(first), int(end))

    def cells(self, kind):
        """Corners of the elements of one kind: k × 4 for shells, k × 8 for solids and thick shells, k × 2 for beams,
        k × 1 for particles; positions in `node` and `points`. A view, not a copy."""
        chosen = self.elements(kind)
        first = int(self.ends[chosen.start - 1]) if chosen.start else 0
        end = int(self.ends[chosen.stop - 1]) if chosen.stop else 0
        return self.corners[first:end].reshape(-1, CORNERS[_kind(kind)])

    def vtk_cells(self):
        """(cells, types) as VTK's unstructured grids have them: `cells` is the number of points and their positions,
        cell after cell; `types` m numbers of VTK. Repeated last corners make a triangle or a tetrahedron."""
        counts = numpy.zeros(len(self), dtype=numpy.int64)
        types = numpy.zeros(len(self), dtype=numpy.uint8)
        for kind, plain, reduced, corners in ((ElementKind.SHELL, QUAD, TRIANGLE, 3),
                                              (ElementKind.SOLID, HEXAHEDRON, TETRAHEDRON, 4),
                                              (ElementKind.THICK_SHELL, HEXAHEDRON, TETRAHEDRON, 4),
                                              (ElementKind.BEAM, LINE, LINE, 2),
                                              (ElementKind.PARTICLE, VERTEX, VERTEX, 1)):
            cells, chosen = self.cells(kind), self.elements(kind)
            repeats = (cells[:, corners - 1:] == cells[:, -1:]).all(axis=1) if plain != reduced else None
            counts[chosen] = CORNERS[kind] if repeats is None else numpy.where(repeats, corners, CORNERS[kind])
            types[chosen] = plain if repeats is None else numpy.where(repeats, reduced, plain)
        begins = self.ends.astype(numpy.int64) - numpy.diff(self.ends.astype(numpy.int64), prepend=0)
        places = numpy.cumsum(counts + 1) - counts - 1
        cells = numpy.empty(int((counts + 1).sum()), dtype=numpy.int64)
        cells[places] = counts
        inside = numpy.arange(int(counts.sum())) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
        cells[numpy.repeat(places + 1, counts) + inside] = self.corners[numpy.repeat(begins, counts) + inside]
        return cells, types
