#!/usr/bin/env python3
"""Holds the grids of gapcheck audit --vtu and gapcheck run --vtu against a reader of its own and, with --vtk, against
VTK's: the mesh, and the findings that the decks of data/ are known to have (NAME.expected.json).

usage: check_vtu.py [--vtk] GAPCHECK ROOT    exit code 0: good, 1: not, 77: --vtk and VTK for Python is not installed
"""

import base64
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zlib

LETTERS = {"Float32": "f", "Int32": "i", "Int64": "q", "UInt8": "B"}
CORNERS = {1: 1, 3: 2, 5: 3, 9: 4, 10: 4, 12: 8}  # of VTK's cell types
OUTCOMES = ["none", "moved", "kept", "forced", "released", "reported"]
FLOAT = 2e-7  # what single precision leaves of a number, relatively


def encoded(count):
    """Length of so many bytes in base64."""
    return (count + 2) // 3 * 4


class Grid:
    """The file as the format's description has it; anything else raises."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        assert root.get("type") == "UnstructuredGrid" and root.get("header_type") == "UInt64"
        assert root.get("compressor") == "vtkZLibDataCompressor"
        appended = root.find("AppendedData")
        assert appended.get("encoding") == "base64"
        self.data = appended.text.strip()
        assert self.data.startswith("_")
        self.data = self.data[1:]
        self.order = {"LittleEndian": "<", "BigEndian": ">"}[root.get("byte_order")]
        grid = root.find("UnstructuredGrid")
        piece = grid.find("Piece")
        points, cells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
        self.points = self.tuples(piece.find("Points/DataArray"), points)
        parts = {array.get("Name"): array for array in piece.find("Cells")}
        ends = self.values(parts["offsets"])
        self.types = self.values(parts["types"])
        corners = self.values(parts["connectivity"])
        assert len(ends) == len(self.types) == cells and (ends[-1] if ends else 0) == len(corners)
        self.cells = [corners[a:b] for a, b in zip([0] + ends, ends)]
        assert all(len(cell) == CORNERS[kind] for cell, kind in zip(self.cells, self.types))
        assert all(0 <= corner < points for corner in corners)
        self.point_data = {array.get("Name"): self.tuples(array, points) for array in piece.find("PointData")}
        self.cell_data = {array.get("Name"): self.tuples(array, cells) for array in piece.find("CellData")}
        self.words = {array.get("Name"): self.strings(array) for array in grid.findall("FieldData/DataArray")}

    def values(self, array):
        assert array.get("format") == "appended"
        start = int(array.get("offset"))
        blocks, whole, last = self.words(start, 3)
        sizes = self.words(start, 3 + blocks)[3:]
        start += encoded(8 * (3 + blocks))
        data = base64.b64decode(self.data[start:start + encoded(sum(sizes))], validate=True)
        assert len(data) == sum(sizes)
        bytes_ = b""
        for i, size in enumerate(sizes):
            bytes_ += zlib.decompress(data[:size])
            data = data[size:]
            assert len(bytes_) == (i * whole + last if i + 1 == blocks and last else (i + 1) * whole)
        letter = LETTERS[array.get("type")]
        count = len(bytes_) // struct.calcsize(letter)
        assert len(bytes_) == count * struct.calcsize(letter)
        return list(struct.unpack(f"{self.order}{count}{letter}", bytes_))

    def words(self, start, count):
        bytes_ = base64.b64decode(self.data[start:start + encoded(8 * count)], validate=True)
        return struct.unpack_from(f"{self.order}{count}Q", bytes_)

    def tuples(self, array, count):
        values, width = self.values(array), int(array.get("NumberOfComponents"))
        assert len(values) == count * width, array.get("Name")
        return [tuple(values[i:i + width]) for i in range(0, len(values), width)]

    @staticmethod
    def strings(array):
        numbers = bytes(int(number) for number in array.text.split())
        assert numbers.endswith(b"\0") or not numbers
        return [text.decode() for text in numbers.split(b"\0")[:-1]]

    def points_by_id(self):
        ids = [node for node, in self.point_data["node"]]
        assert len(set(ids)) == len(ids), "a node has two points"
        return {node: place for place, node in enumerate(ids)}


def same(a, b):
    return (math.isnan(a) and math.isnan(b)) or abs(a - b) <= FLOAT * max(1, abs(a), abs(b))


def check_with_vtk(path, grid):
    """VTK reads the same file without a complaint and finds the same in it."""
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    complaints = []
    reader = vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: complaints.append("error"))
    reader.AddObserver("WarningEvent", lambda *_: complaints.append("warning"))
    assert reader.CanReadFile(str(path)) == 1
    reader.SetFileName(str(path))
    reader.Update()
    read = reader.GetOutput()
    assert not complaints, complaints
    assert read.GetNumberOfPoints() == len(grid.points) and read.GetNumberOfCells() == len(grid.cells)
    for i, point in enumerate(grid.points):
        assert read.GetPoint(i) == point
    for i, (kind, corners) in enumerate(zip(grid.types, grid.cells)):
        cell = read.GetCell(i)
        assert cell.GetCellType() == kind
        assert [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())] == corners
    for expected, data in ((grid.point_data, read.GetPointData()), (grid.cell_data, read.GetCellData())):
        assert [data.GetArrayName(k) for k in range(data.GetNumberOfArrays())] == list(expected)
        for name, tuples in expected.items():
            array = data.GetArray(name)
            assert array.GetNumberOfTuples() == len(tuples), name
            for i, values in enumerate(tuples):
                assert all(same(a, b) for a, b in zip(array.GetTuple(i), values)), (name, i)
    field = read.GetFieldData()
    for name, words in grid.words.items():
        array = field.GetAbstractArray(name)
        assert [array.GetValue(i) for i in range(array.GetNumberOfValues())] == words, name


def notices_faults(path, folder):
    """Both readers see that half a file is none."""
    half = folder / "half.vtu"
    half.write_bytes(path.read_bytes()[:path.stat().st_size // 2])
    try:
        Grid(half)
    except Exception:  # of whatever kind
        return
    raise AssertionError("half a file is taken for a grid")


class Checker:
    def __init__(self, gapcheck, root, vtk, folder):
        self.gapcheck, self.root, self.vtk, self.folder = gapcheck, root, vtk, folder
        self.grids = 0

    def run(self, *arguments):
        run = subprocess.run([self.gapcheck, *map(str, arguments)], capture_output=True, cwd=self.root)
        assert run.returncode in (0, 1), f"{arguments}: exit {run.returncode}: {run.stderr.decode()}"
        return run.stdout.decode()

    def open(self, path):
        grid = Grid(path)
        if self.vtk:
            check_with_vtk(path, grid)
        self.grids += 1
        return grid

    def audit(self, deck, *options):
        path = self.folder / "audit.vtu"
        self.run("audit", deck, "--quiet", "--vtu", path, *options)
        return self.open(path)

    def check_deck(self, deck):
        """What is known of the deck is in its grid."""
        known = json.loads(deck.with_suffix("").with_suffix(".expected.json").read_text())["findings"]
        grid = self.audit(deck.relative_to(self.root), "--select", "GC101,GC102,GC106")
        place = grid.points_by_id()
        deepest = {}
        for finding in known:
            if "penetration" in finding:
                before = deepest.get(finding["node"])
                if before is None or finding["penetration"] > before["penetration"]:
                    deepest[finding["node"]] = finding
        data = grid.point_data
        for node, i in place.items():
            depth, remaining = data["depth"][i][0], data["remaining"][i][0]
            if node not in deepest:
                assert depth == 0 and math.isnan(remaining), (deck.name, node)
                continue
            finding = deepest[node]
            assert abs(depth - finding["penetration"]) < 1e-6, (deck.name, node, depth, finding)
            assert abs(remaining - finding["contact_distance"] + finding["penetration"]) < 1e-6, (deck.name, node)
            assert data["contact"][i][0] == finding["contact"], (deck.name, node)
            assert abs(math.hypot(*data["way_out"][i]) - depth) < 1e-5, (deck.name, node, data["way_out"][i])
            word = OUTCOMES[data["outcome"][i][0]]
            assert word == finding.get("outcome", word), (deck.name, node, word)
            if finding.get("moved_to"):
                way = [a - b for a, b in zip(finding["moved_to"], grid.points[i])]
                cosine = sum(a * b for a, b in zip(way, data["way_out"][i])) / math.hypot(*way) / depth
                assert cosine > 0.99, (deck.name, node, cosine)
        assert set(deepest) <= set(place), deck.name
        return len(deepest)

    def check_empty(self):
        """Decks with nothing to draw, or with what cannot be drawn."""
        path = self.folder / "deck.k"
        path.write_text("*KEYWORD\n*END\n")
        grid = self.audit(path)
        assert grid.points == [] and grid.cells == []
        two = (self.root / "data/two_plates.k").read_text().splitlines()
        at = two.index("*NODE") + 1
        while two[at].startswith("$"):
            at += 1
        two[at] = two[at][:8] + f"{'nan':>16}" + two[at][24:]
        path.write_text("\n".join(two) + "\n")
        drawn = self.folder / "nan.vtu"
        run = subprocess.run([self.gapcheck, "audit", path, "--quiet", "--vtu", drawn], capture_output=True)
        assert run.returncode == 2, "a coordinate that is not a number is an error"
        assert len(self.open(drawn).cells) == 18

    def check_log(self):
        """The findings of a log, with the deck's mesh and without any."""
        for options, cells in (((), False), (("--deck", self.root / "data/two_plates.k"), True)):
            path = self.folder / "log.vtu"
            self.run("messag", "tests/apps/fixtures/smp/messag", "--quiet", "--vtu", path, *options)
            grid = self.open(path)
            assert any(kind == 9 for kind in grid.types) == cells

    def check_run(self):
        """The states of a calculation and the collection that names them."""
        out = self.folder / "out"
        self.run("run", "data/workshop/rebound_reference.k", "-o", out, "--cycles", "30", "--vtu")
        shells = self.shells(self.root / "data/workshop/rebound_reference.k")
        collection = ElementTree.parse(out / "run.pvd").getroot()
        assert collection.get("type") == "Collection"
        entries = [(float(entry.get("timestep")), entry.get("file")) for entry in collection.iter("DataSet")]
        assert len(entries) >= 2 and [time for time, _ in entries] == sorted(time for time, _ in entries)
        for _, name in entries:
            grid = self.open(out / name)
            assert set(grid.types) == {9} and {"displacement", "velocity", "contact_force"} <= set(grid.point_data)
            assert sorted(element for element, in grid.cell_data["element"]) == shells
        assert any(any(values) for values in grid.point_data["displacement"]), "nothing moves"

    @staticmethod
    def shells(deck):
        """Ids of the shells in fixed columns of the deck."""
        ids, inside = [], False
        for line in deck.read_text().splitlines():
            if line.startswith("*"):
                inside = line == "*ELEMENT_SHELL"
            elif inside and not line.startswith("$"):
                ids.append(int(line[:8]))
        return sorted(ids)


def main():
    vtk = sys.argv[1] == "--vtk"
    gapcheck, root = (pathlib.Path(argument).resolve() for argument in sys.argv[-2:])
    if vtk:
        try:
            import vtkmodules.vtkIOXML  # noqa: F401
        except ImportError:
            print("VTK for Python is not installed (python3-vtk9)")
            return 77
    with tempfile.TemporaryDirectory() as name:
        checker = Checker(gapcheck, root, vtk, pathlib.Path(name))
        decks = sorted(path for path in root.glob("data/*.k") if path.with_suffix(".expected.json").exists())
        nodes = sum(checker.check_deck(deck) for deck in decks)
        assert len(decks) > 30 and nodes > 100, (len(decks), nodes)
        checker.check_empty()
        checker.check_log()
        checker.check_run()
        checker.audit("data/two_plates.k")
        notices_faults(checker.folder / "audit.vtu", checker.folder)
    print(f"{checker.grids} grids, {nodes} penetrating nodes, read by {'VTK' if vtk else 'the test itself'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
