"""The mesh of a report for pyvista, which is imported only here."""
import numpy


def grid(report):
    """A pyvista.UnstructuredGrid of the report's mesh with its penetrations."""
    try:
        import pyvista
    except ImportError as error:
        raise ImportError("to_pyvista() needs pyvista, which is not installed: pip install pyvista; "
                          "to_vtu() writes the grid without it") from error
    mesh = report.mesh
    if mesh is None:
        raise ValueError("the report has no mesh; audit with mesh=True")
    cells, types = mesh.vtk_cells()
    made = pyvista.UnstructuredGrid(cells, types, mesh.points.copy())
    made.point_data["node"] = mesh.node.copy()
    made.point_data["depth"] = depth_of_points(mesh, report.penetrations)
    for name in ("element", "part", "contact", "thickness", "kind"):
        made.cell_data[name] = getattr(mesh, name).copy()
    return made


def depth_of_points(mesh, penetrations):
    """n depths: the deepest penetration of each node of the mesh, 0: none."""
    depth = numpy.zeros(len(mesh.node))
    order = numpy.argsort(mesh.node, kind="stable")
    place = numpy.searchsorted(mesh.node, penetrations.node, sorter=order)
    inside = place < len(order)
    row = order[place[inside]]
    known = mesh.node[row] == penetrations.node[inside]
    numpy.maximum.at(depth, row[known], penetrations.depth[inside][known])
    return depth
