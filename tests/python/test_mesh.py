"""The mesh of a deck, and grids of it for other programs."""
import sys
import types

import numpy
import pytest
from conftest import DATA

import gapcheck

ALL_KINDS = """*KEYWORD
*PART
shell
1,1,1
*PART
solid
2,2,1
*SECTION_SHELL
1
2.,2.,2.,2.
*SECTION_SOLID
2
*MAT_ELASTIC
1,1.,1.,0.3
*NODE
1,0.,0.,0.
2,1.,0.,0.
3,1.,1.,0.
4,0.,1.,0.
5,0.,0.,1.
6,1.,0.,1.
7,1.,1.,1.
8,0.,1.,1.
11,6.,6.,6.
*ELEMENT_SHELL
10,1,1,2,3,4
11,1,5,6,7,7
*ELEMENT_SOLID
20,2,1,2,3,4,5,6,7,8
21,2,1,2,3,5,5,5,5,5
*ELEMENT_BEAM
30,1,7,11
*ELEMENT_SPH
8,2,1.
*END
"""


class Grid:
    """Records what pyvista.UnstructuredGrid is made of."""

    def __init__(self, cells, types, points):
        self.cells, self.types, self.points = cells, types, points
        self.point_data, self.cell_data = {}, {}


@pytest.fixture
def pyvista(monkeypatch):
    module = types.ModuleType("pyvista")
    module.UnstructuredGrid = Grid
    monkeypatch.setitem(sys.modules, "pyvista", module)


def test_cells_by_kind():
    mesh = gapcheck.audit_text(ALL_KINDS, mesh=True).mesh
    assert mesh.element.tolist() == [10, 11, 20, 21, 30, 8] and mesh.left_out == 0
    assert [gapcheck.ElementKind(kind).name for kind in mesh.kind] == ["SHELL"] * 2 + ["SOLID"] * 2 + ["BEAM", "PARTICLE"]
    assert mesh.node[mesh.cells("shell")].tolist() == [[1, 2, 3, 4], [5, 6, 7, 7]]
    assert mesh.node[mesh.cells(gapcheck.ElementKind.SOLID)][0].tolist() == [1, 2, 3, 4, 5, 6, 7, 8]
    assert mesh.node[mesh.cells("beam")].tolist() == [[7, 11]] and mesh.node[mesh.cells("particle")].tolist() == [[8]]
    assert mesh.cells("thick-shell").shape == (0, 8)
    assert mesh.part[mesh.elements("solid")].tolist() == [2, 2]
    assert numpy.shares_memory(mesh.cells("solid"), mesh.corners)
    row = mesh.node.tolist().index(11)
    assert mesh.points[row].tolist() == [6, 6, 6]
    with pytest.raises(ValueError, match="'tetrahedron' is no kind of element; there are shell, solid"):
        mesh.cells("tetrahedron")
    for wrong, error in ((7, ValueError), (-1, ValueError), (None, TypeError), (1.0, TypeError), ("SHELL", ValueError)):
        with pytest.raises(error):
            mesh.elements(wrong)


def test_no_mesh_without_asking(plates):
    assert plates.mesh is None


def test_cells_of_vtk():
    mesh = gapcheck.audit_text(ALL_KINDS, mesh=True).mesh
    cells, kinds = mesh.vtk_cells()
    assert kinds.tolist() == [9, 5, 12, 10, 3, 1]
    read, at = [], 0
    while at < len(cells):
        read.append(mesh.node[cells[at + 1:at + 1 + cells[at]]].tolist())
        at += 1 + cells[at]
    assert read == [[1, 2, 3, 4], [5, 6, 7], [1, 2, 3, 4, 5, 6, 7, 8], [1, 2, 3, 5], [7, 11], [8]]


def test_cells_of_vtk_equal_those_of_plates():
    mesh = gapcheck.audit(DATA / "two_plates.k", mesh=True).mesh
    cells, kinds = mesh.vtk_cells()
    assert (kinds == 9).all() and cells.reshape(-1, 5)[:, 1:].tolist() == mesh.cells("shell").tolist()


def test_grid_of_pyvista(pyvista):
    report = gapcheck.audit(DATA / "two_plates.k", mesh=True)
    grid = report.to_pyvista()
    assert isinstance(grid, Grid) and len(grid.types) == 18 and grid.points.tolist() == report.mesh.points.tolist()
    expected = dict(zip(report.penetrations.node.tolist(), report.penetrations.depth.tolist()))
    assert {node: depth for node, depth in zip(grid.point_data["node"].tolist(), grid.point_data["depth"].tolist())
            if depth > 0} == expected
    assert grid.cell_data["part"].tolist() == [1] * 9 + [2] * 9 and set(grid.cell_data["thickness"]) == {1.0}
    grid.points[0] = 9  # its own


def test_pyvista_is_needed_or_the_mesh(monkeypatch, pyvista, plates):
    with pytest.raises(ValueError, match="mesh=True"):
        plates.to_pyvista()
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ImportError, match="pip install pyvista"):
        plates.to_pyvista()
