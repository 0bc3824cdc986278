"""Arrays of any type and layout as a mesh; what cannot be meant is refused and named."""
import numpy
import pytest

import gapcheck

QUADS = numpy.array([[0, 1, 4, 3], [1, 2, 5, 4], [6, 7, 10, 9], [7, 8, 11, 10]])
FLAT = [(x, y) for y in (0, 4) for x in (0, 4, 8)]
POINTS = numpy.array([[x + 0.5 * plate, y + 0.25 * plate, 0.7 * plate] for plate in (0, 1) for x, y in FLAT])
PART = numpy.array([1, 1, 2, 2])


def depths(points=POINTS, shells=QUADS, thickness=1.0, part=PART, **options):
    report = gapcheck.audit_arrays(points, shells, thickness, part, **options)
    assert report.complete, report.diagnostics
    return dict(zip((report.penetrations.node - 1).tolist(), report.penetrations.depth.tolist()))


EXPECTED = depths()


def test_depth_is_what_is_missing():
    """Contact distance minus the distance from the other plate, a rectangle."""
    for thickness, distance in ((1.0, 1.0), ({1: 1.0, 2: 0.6}, 0.8), (0.5, 0.5)):
        expected = {}
        for row, point in enumerate(POINTS):
            low = numpy.array([0.0, 0.0, 0.0]) if row >= 6 else numpy.array([0.5, 0.25, 0.7])
            gap = numpy.linalg.norm(point - numpy.clip(point, low, low + (8, 4, 0)))
            if gap < distance:
                expected[row] = distance - gap
        found = depths(thickness=thickness)
        assert found.keys() == expected.keys()
        assert all(abs(found[row] - expected[row]) < 1e-12 for row in expected)
    assert len(EXPECTED) == 12


@pytest.mark.parametrize("change", [
    lambda p, s, a: (p.tolist(), s.tolist(), a.tolist()),
    lambda p, s, a: (p.astype(">f8"), s.astype(">i4"), a.astype(">i2")),
    lambda p, s, a: (p, s.astype("i4"), a.astype("u1")),
    lambda p, s, a: (p, s.astype("u8"), a.astype("u8")),
    lambda p, s, a: (numpy.asfortranarray(p), numpy.asfortranarray(s), a),
    lambda p, s, a: (numpy.repeat(p, 2, axis=0)[::2], numpy.repeat(s, 3, axis=1)[:, ::3], numpy.repeat(a, 5)[::5]),
    lambda p, s, a: (p[::-1][::-1], s[::-1][::-1], a[::-1][::-1]),
    lambda p, s, a: tuple(numpy.frombuffer(each.tobytes(), each.dtype).reshape(each.shape) for each in (p, s, a)),
    lambda p, s, a: (tuple(map(tuple, p)), [list(row) for row in s], tuple(a)),
], ids=["lists", "big-endian", "int32", "uint64", "by columns", "with gaps", "backwards", "read-only", "tuples"])
def test_any_layout_gives_the_same(change):
    points, shells, part = change(POINTS, QUADS, PART)
    assert depths(points, shells, part=part) == EXPECTED


def test_single_precision_and_whole_numbers():
    assert depths(POINTS.astype("f4")) == depths(POINTS.astype("f4").astype("f8"))
    whole = (POINTS * 100).astype(int)
    assert depths(whole, thickness=100) == depths(whole.astype(float), thickness=100) != {}
    assert depths(POINTS.astype("f2")).keys() == EXPECTED.keys()


def test_triangles_of_three():
    triangles = numpy.concatenate([QUADS[:, :3], QUADS[:, [0, 2, 3]]])
    part = numpy.concatenate([PART, PART])
    report = gapcheck.audit_arrays(POINTS, triangles, 1.0, part, mesh=True)
    assert (report.mesh.corners.reshape(-1, 4)[:, 2] == report.mesh.corners.reshape(-1, 4)[:, 3]).all()
    assert dict(zip((report.penetrations.node - 1).tolist(), report.penetrations.depth.round(12).tolist())).keys() \
        == EXPECTED.keys()


def test_the_deck_gives_the_same():
    deck = gapcheck.shell_deck(POINTS, QUADS, 1.0, PART)
    report = gapcheck.audit_text(deck, "arrays")
    assert dict(zip((report.penetrations.node - 1).tolist(), report.penetrations.depth.tolist())) == EXPECTED
    line = int(report.penetrations.line[0])
    assert deck.splitlines()[line - 1].startswith(f"{report.penetrations.node[0]},")


def test_digits_are_kept():
    points = POINTS + numpy.array([1 / 3, 1e-7 / 3, 1e9 / 7])
    mesh = gapcheck.audit_arrays(points, QUADS, 1 / 3, PART, mesh=True).mesh
    order = numpy.argsort(mesh.node)
    assert mesh.points[order].tobytes() == points.tobytes()


def test_contacts_of_two_sides():
    one = gapcheck.audit_arrays(POINTS, QUADS, 1.0, PART, contact="AUTOMATIC_NODES_TO_SURFACE", tracked=2, reference=[1])
    assert set(one.penetrations.part) == {2} and len(one.penetrations)
    assert one.contacts[0].keyword == "CONTACT_AUTOMATIC_NODES_TO_SURFACE"


@pytest.mark.parametrize("arguments, error, words", [
    ({"points": POINTS[:, :2]}, ValueError, "points: an array of n × 3 is needed, not of 12 × 2"),
    ({"points": POINTS.ravel()}, ValueError, "points: an array of n × 3"),
    ({"points": 5}, ValueError, "one number"),
    ({"points": []}, ValueError, "points: an array"),
    ({"points": numpy.empty((0, 3))}, gapcheck.Error, "shells, row 0: 0 is not one of the 0 rows of points"),
    ({"points": None}, TypeError, "points: numbers are needed, not object"),
    ({"points": "points"}, TypeError, "points: numbers are needed"),
    ({"points": POINTS.astype(complex)}, TypeError, "complex128"),
    ({"points": POINTS > 0}, TypeError, "bool"),
    ({"points": numpy.ma.masked_less(POINTS, 0.5)}, TypeError, "masked"),
    ({"points": [[0, 0, 0], [1, 1]]}, (ValueError, TypeError), "."),
    ({"points": numpy.where(POINTS == 8, numpy.nan, POINTS)}, gapcheck.Error, "points, row 2: nan is not a number from"),
    ({"points": numpy.where(POINTS == 8, -numpy.inf, POINTS)}, gapcheck.Error, "points, row 2: -inf"),
    ({"shells": QUADS + 9}, gapcheck.Error, "shells, row 0: 13 is not one of the 12 rows of points, which count from 0"),
    ({"shells": QUADS - 1}, gapcheck.Error, "shells, row 0: -1 is not"),
    ({"shells": QUADS.astype(float)}, TypeError, "shells: whole numbers are needed, not float64"),
    ({"shells": QUADS.ravel()}, ValueError, "shells: an array of n × 3 or n × 4 is needed, not of 16"),
    ({"shells": QUADS[:, :2]}, ValueError, "4 × 2"),
    ({"shells": numpy.empty((0, 4), int), "part": None}, gapcheck.Error, "shells: there are none"),
    ({"shells": numpy.full((4, 4), 2**63, "u8")}, ValueError, "shells: numbers beyond 64 bits"),
    ({"shells": numpy.full((4, 4), 2**62)}, gapcheck.Error, "shells, row 0: 4611686018427387904 is not one"),
    ({"shells": QUADS.astype("m8[s]")}, TypeError, "whole numbers"),
    ({"part": [1, 2]}, ValueError, "part: 4 ids are needed"),
    ({"part": []}, ValueError, "part: 4 ids are needed"),
    ({"part": PART.reshape(2, 2)}, ValueError, "part: 4 ids"),
    ({"part": PART - 1}, gapcheck.Error, "parts, row 0: 0 is not an id of 1 or more"),
    ({"part": [1.0, 1, 2, 2]}, TypeError, "part: whole numbers"),
    ({"thickness": 0}, gapcheck.Error, "thickness: 0 is not a length above 0"),
    ({"thickness": -1.5}, gapcheck.Error, "thickness: -1.5"),
    ({"thickness": float("nan")}, gapcheck.Error, "thickness: nan"),
    ({"thickness": None}, gapcheck.Error, "thickness: 0 is not"),
    ({"thickness": "thick"}, TypeError, "thickness: a number is needed, not 'thick' .str."),
    ({"thickness": {1: 1.0}}, gapcheck.Error, "thickness: 0 is not a length above 0"),
    ({"thickness": {1: 1.0, 2: 1.0, 3: 1.0}}, gapcheck.Error, "part_thickness: part 3 has no shells"),
    ({"thickness": {"a": 1.0}}, TypeError, "part_thickness"),
    ({"contact": "NO_SUCH_TYPE"}, gapcheck.Error, "contact: 'NO_SUCH_TYPE'"),
    ({"contact": 5}, TypeError, "contact: a str is needed"),
    ({"contact": "ERODING_SINGLE_SURFACE"}, gapcheck.Error, "no cards of its own"),
    ({"tracked": [9]}, gapcheck.Error, "tracked: part 9 has no shells"),
    ({"no_such_option": 1}, TypeError, "no_such_option"),
])
def test_what_cannot_be_meant_is_named(arguments, error, words):
    given = {"points": POINTS, "shells": QUADS, "thickness": 1.0, "part": PART, **arguments}
    with pytest.raises(error, match=words.replace("(", ".")):
        gapcheck.audit_arrays(**given)


def test_degenerate_shells_are_findings():
    shells = QUADS.copy()
    shells[0] = 0
    report = gapcheck.audit_arrays(POINTS, shells, 1.0, PART)
    assert any(finding.rule == "degenerate-segment" for finding in report.findings) or report.diagnostics
    far = gapcheck.audit_arrays(POINTS * 1e29, QUADS, 1e29, PART)
    assert far.complete and len(far.penetrations) == 12
    with pytest.raises(gapcheck.Error, match="points, row 1: 4e.300 is not a number from -1e.30 to 1e.30"):
        gapcheck.audit_arrays(POINTS * 1e300, QUADS, 1.0, PART)
