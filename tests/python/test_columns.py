"""Arrays are those of the library: no copy, read-only, alive as long as one of them is."""
import csv
import ctypes
import gc
import io

import numpy
import pytest
from conftest import DATA

import gapcheck


def address(array):
    return array.__array_interface__["data"][0]


def fresh_columns(report):
    """The columns once more, as views that the library makes anew."""
    core = report._core
    return {**{f"p_{name}": array for name, array in gapcheck._core.penetration_columns(core).items()},
            **{f"t_{name}": array for name, array in gapcheck._core.tie_columns(core).items()},
            **{f"m_{name}": array for name, array in gapcheck._core.mesh_columns(core).items() if name != "left_out"}}


@pytest.fixture
def full():
    """A report with penetrations, ties and a mesh."""
    report = gapcheck.audit(DATA / "tied_then_contact.k", mesh=True)
    assert len(report.penetrations) and len(report.ties) and len(report.mesh)
    return report


def test_arrays_are_views_of_one_memory(full):
    first, second = fresh_columns(full), fresh_columns(full)
    assert len(first) == 20 + 11 + 9
    for name, array in first.items():
        assert address(array) == address(second[name]), name
        assert array is not second[name]
        assert not array.flags.owndata and array.base is full._core, name
        assert numpy.array_equal(array, second[name], equal_nan=array.dtype.kind == "f")
    for name, array in full.penetrations._arrays.items():
        assert getattr(full.penetrations, name) is array and address(array) == address(first[f"p_{name}"])
    # Different columns lie in different places, and a column of words is as long as its rows say.
    places = sorted((address(array), array.nbytes) for array in first.values())
    assert all(a + size <= b for (a, size), (b, _) in zip(places, places[1:]))


def test_arrays_survive_their_report(plates):
    depth, node = plates.penetrations.depth, plates.penetrations.node
    kept_depth, kept_node, place = depth.tolist(), node.tolist(), address(depth)
    slice_of_it = plates.penetrations.position[3:5, 1]
    kept_slice = slice_of_it.tolist()
    del plates
    for _ in range(20):
        gapcheck.audit(DATA / "two_plates.k")  # uses memory that might have been freed
    gc.collect()
    assert address(depth) == place
    assert depth.tolist() == kept_depth and node.tolist() == kept_node and slice_of_it.tolist() == kept_slice
    # What the library's own memory holds there, looked at without NumPy.
    assert list((ctypes.c_double * 18).from_address(place)) == kept_depth


def test_arrays_cannot_be_written(full):
    for name, array in fresh_columns(full).items():
        assert not array.flags.writeable, name
        with pytest.raises(ValueError):
            array[...] = 0
        with pytest.raises(ValueError):
            array.flags.writeable = True
        with pytest.raises(TypeError, match="not writable"):
            ctypes.c_char.from_buffer(array)


def test_shapes_and_types(full):
    p, t = full.penetrations, full.ties
    n, m = len(p), len(t)
    wanted = {"kind": ("u1", (n,)), "contact": ("u4", (n,)), "node": ("i8", (n,)), "segment": ("i8", (n, 4)),
              "depth": ("f8", (n,)), "local": ("f8", (n, 2)), "position": ("f8", (n, 3)), "line": ("u4", (n,))}
    for name, (kind, shape) in wanted.items():
        assert getattr(p, name).dtype == kind and getattr(p, name).shape == shape, name
    assert t.position.shape == (m, 3) and t.by_node_set.dtype == "u1" and t.reason.dtype == "u1"


def test_nothing_found_is_empty_arrays():
    report = gapcheck.audit(DATA / "clean.k")
    assert len(report.penetrations) == 0 == len(report.ties)
    assert report.penetrations.segment.shape == (0, 4) and report.penetrations.depth.shape == (0,)
    assert report.penetrations.to_numpy().shape == (0,)
    assert report.penetrations.contact_id.tolist() == []
    assert report.penetrations.words("outcome").tolist() == []
    assert list(report.penetrations.to_frame().columns) == list(gapcheck.audit(
        DATA / "two_plates.k").penetrations.to_frame().columns)
    assert len(report.part_pairs()) == 0 and "0 penetrations" in repr(report)
    assert not report.penetrations.depth.flags.owndata


def test_many_records_are_in_their_order(large):
    """Columns of many records are filled by several threads; the table is written from the records themselves."""
    report = gapcheck.audit_text(large)
    found = report.penetrations
    table = csv.DictReader(io.StringIO(report.to_csv()))
    rows = [row for row in table if row["id"] in gapcheck._core.names["kind_rule"]]
    assert len(rows) == len(found) > 50000
    assert [int(row["node"]) for row in rows] == found.node.tolist()
    assert [float(row["penetration"]) for row in rows] == found.depth.tolist()
    assert [int(row["line"]) for row in rows] == found.line.tolist()
    assert found.to_numpy().tobytes() == gapcheck.audit_text(large, jobs=1).penetrations.to_numpy().tobytes()


def test_codes_have_words(full):
    p, t = full.penetrations, full.ties
    assert set(p.words("rule")) <= {"GC101", "GC102", "GC106", "GC107", "GC108", "GC109"}
    assert set(p.words("outcome")) <= {"moved", "kept", "forced", "released", "reported"}
    assert gapcheck.Outcome.MOVED == 0 and gapcheck.Outcome.RELEASED == 3 and gapcheck.TieReason.OFFSET == 1
    assert (p.words("kind") == "initial").sum() == (p.kind == gapcheck.PenetrationKind.INITIAL).sum()
    assert set(t.words("rule")) <= {"GC201", "GC202", "GC204"}
    with pytest.raises(KeyError, match="no column of codes"):
        p.words("depth")
    ids = [contact.id for contact in full.contacts]
    assert set(p.contact_id) <= set(ids) and [ids[i] for i in p.contact] == p.contact_id.tolist()


def test_structured_array(plates):
    records = plates.penetrations.to_numpy()
    assert records.dtype.names == plates.penetrations.columns and records.shape == (18,)
    for name in records.dtype.names:
        assert numpy.array_equal(records[name], getattr(plates.penetrations, name)), name
    records["depth"] = 0  # a copy
    assert plates.penetrations.depth.min() > 0.2


def test_frame(plates):
    pandas = pytest.importorskip("pandas")
    frame = plates.penetrations.to_frame()
    assert len(frame) == 18 and frame["contact_id"].tolist() == [1] * 18
    assert frame["outcome"].dtype == "category" and frame["outcome"].tolist() == ["moved"] * 18
    assert list(frame["outcome"].cat.categories) == ["moved", "kept", "forced", "released", "reported"]
    assert frame["rule"].tolist() == ["GC101"] * 18
    assert frame["path"].tolist() == [str(DATA / "two_plates.k")] * 18
    assert frame[["position_x", "position_y", "position_z"]].to_numpy().tolist() == plates.penetrations.position.tolist()
    assert frame["segment_4"].tolist() == plates.penetrations.segment[:, 3].tolist()
    assert isinstance(frame, pandas.DataFrame) and not frame.isna().any().any()
    ties = gapcheck.audit(DATA / "tied_then_contact.k").ties.to_frame()
    assert ties["by_node_set"].dtype == bool and ties["reason"].dtype == "category" and len(ties)


def test_pandas_is_imported_when_it_is_asked_for():
    import subprocess
    import sys
    script = ("import sys, gapcheck; report = gapcheck.audit(sys.argv[1]); report.to_json(); report.penetrations.to_numpy();"
              "assert 'pandas' not in sys.modules; report.part_pairs(); assert 'pandas' in sys.modules")
    subprocess.run([sys.executable, "-c", script, DATA / "two_plates.k"], check=True)
