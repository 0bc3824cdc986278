"""The start of a run: arrays, and what the program gives."""
import json
import subprocess

import numpy
import pytest
from conftest import DATA, ROOT

import gapcheck

DECKS = ("ignore_0.k", "ignore_1.k", "contact_chain.k", "deep_node_released.k", "snlog_1.k", "workshop/rebound_thin.k")


@pytest.mark.parametrize("name", DECKS)
def test_a_start_is_that_of_the_program(name, program, monkeypatch):
    monkeypatch.chdir(ROOT)
    deck = f"data/{name}"
    start = gapcheck.start(deck)

    def printed(*options):
        return subprocess.run([program, "start", deck, *options], capture_output=True, text=True).stdout
    assert start.to_text() == printed() and start.to_json() == printed("--format", "json")
    expected = json.loads(start.to_json())
    moves = start.moves
    assert list(zip(moves.contact_id, moves.node, moves.part, moves.other_part, moves.words("cause"))) == \
        [(each["contact"], each["node"], each["part"], each["other_part"], each["cause"]) for each in expected["moves"]]
    assert moves.start.tolist() == [each["from"] for each in expected["moves"]]
    assert moves.end.tolist() == [each["to"] for each in expected["moves"]]
    assert start.clean == expected["summary"]["clean"] and start.energy == expected["summary"]["energy"]
    for contact, other in zip(start.contacts, expected["contacts"]):
        for field in ("id", "score", "moved", "kept", "forced", "released", "deepest_kept", "deepest_forced", "way_out"):
            assert getattr(contact, field) == other[field], field
        assert contact.histogram.tolist() == other["histogram"]


def test_nodes_say_what_becomes_of_them():
    """One plate in another, 0.3 deep: IGNORE = 0 moves its nodes, 1 forgives the depth, SNLOG = 1 lets a spring push."""
    moved, kept, forced = (gapcheck.start(DATA / name) for name in ("ignore_0.k", "ignore_1.k", "snlog_1.k"))
    assert len(moved.nodes) == 0 and len(moved.moves) == moved.moved == 18 == len(set(moved.moves.node))
    assert numpy.linalg.norm(moved.moves.move, axis=1) == pytest.approx(0.3006) and moved.largest_move == pytest.approx(0.3006)
    assert len(kept.moves) == 0 and set(kept.nodes.outcome) == {gapcheck.Outcome.KEPT} and len(kept.nodes) == 18
    assert kept.nodes.depth == pytest.approx(0.3) and (kept.nodes.energy == 0).all()
    assert kept.contacts[0].least_share == pytest.approx(0.7)
    assert set(forced.nodes.words("outcome")) == {"forced"} and forced.nodes.depth == pytest.approx(0.3)
    assert forced.nodes.energy.sum() == pytest.approx(50116.2, rel=1e-5) and forced.energy == pytest.approx(50116.2, rel=1e-5)
    released = gapcheck.start(DATA / "deep_node_released.k")
    assert set(released.nodes.words("outcome")) == {"released"} and len(released.nodes) == released.contacts[0].released
    assert released.nodes.depth.max() == released.contacts[0].way_out > 0
    assert (kept.nodes.to_release > 0).all() and kept.nodes.to_release.min() == kept.contacts[0].to_release
    assert "1 contacts start clean; 18 nodes moved by at most 0.3006, energy 0>" in repr(moved)


def test_structured_arrays_and_frames():
    start = gapcheck.start(DATA / "contact_chain.k")
    moves, records = start.moves, start.moves.to_numpy()
    assert records.dtype.names == moves.columns == ("contact", "node", "part", "other_part", "start", "end", "cause")
    assert records["end"].shape == (len(moves), 3) and (records["node"] == moves.node).all()
    frame = moves.to_frame()
    assert frame["contact_id"].tolist() == moves.contact_id.tolist() and set(frame["cause"]) <= {"shot", "tied", "first-cycle"}
    assert frame["end_z"].tolist() == moves.end[:, 2].tolist() and "rule" not in frame
    nodes = start.nodes.to_frame()
    assert nodes["depth"].tolist() == start.nodes.depth.tolist() and set(nodes["outcome"]) == {"forced"}
    assert (start.nodes.to_numpy()["to_release"] == start.nodes.to_release).all()
    with pytest.raises(KeyError, match='there are cause"$'):
        moves.words("rule")
    assert len(start.repeats) == 9 and start.repeats[0].back and start.repeats[0].contacts == [0, 1]
    assert {"deepest_kept", "score"} <= set(start.contacts.to_frame()) and "energy" in dir(start)
    with pytest.raises(AttributeError, match="no 'nonsense'"):
        start.nonsense


def test_positions_are_those_of_the_first_cycle(tmp_path):
    start = gapcheck.start(DATA / "contact_chain.k")
    assert start.points.shape == start.deck_points.shape == (len(start.node), 3)
    mesh = gapcheck.audit(DATA / "contact_chain.k", mesh=True).mesh
    where = dict(zip(start.node.tolist(), start.deck_points.tolist()))
    assert all(where[node] == point for node, point in zip(mesh.node.tolist(), mesh.points.tolist()))
    gapcheck.run(DATA / "contact_chain.k", tmp_path / "out", cycles=2)
    motion = gapcheck.read_motion(tmp_path / "out", states=0)
    order = numpy.argsort(start.node)
    assert motion.node.tolist() == start.node[order].tolist()
    assert motion.positions[0] == pytest.approx(start.points[order], abs=1e-6)
    assert abs(start.points - start.deck_points).max() > 0.05


def test_arrays_are_views_that_keep_the_start_alive():
    start = gapcheck.start(DATA / "ignore_0.k")
    arrays = [start.moves.end, start.moves.node, start.node, start.points, start.deck_points]
    kept = [array.tolist() for array in arrays]
    assert not any(array.flags.writeable or array.flags.owndata for array in arrays)
    core = start._core
    assert core.points.__array_interface__["data"][0] == start.points.__array_interface__["data"][0]
    del start, core
    for _ in range(10):
        gapcheck.start(DATA / "ignore_1.k")
    assert [array.tolist() for array in arrays] == kept


def test_pages_and_grids_are_those_of_the_program(program, tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    subprocess.run([program, "start", "data/ignore_0.k", "--quiet", "--html", tmp_path / "page.html", "--vtu",
                    tmp_path / "grid.vtu"], capture_output=True)
    start = gapcheck.start("data/ignore_0.k", picture=True, mesh=True)
    assert start.to_html() == (tmp_path / "page.html").read_text() and 'Name="move"' in start.to_vtu()
    assert start.to_vtu() == (tmp_path / "grid.vtu").read_text()
    assert start.to_html(tmp_path / "again.html") is None
    assert (tmp_path / "again.html").read_bytes() == (tmp_path / "page.html").read_bytes()
    plain = gapcheck.start("data/ignore_0.k")
    for write, option in ((plain.to_html, "picture"), (plain.to_vtu, "mesh")):
        with pytest.raises(ValueError, match=f"{option}=True"):
            write(tmp_path / "none")
    assert not (tmp_path / "none").exists()


def test_decks_that_cannot_be_followed(tmp_path):
    deck = tmp_path / "deck.k"
    content = (DATA / "ignore_0.k").read_text()
    deck.write_text(content.replace("*KEYWORD\n", "*KEYWORD\n*INCLUDE\nmissing.k\n", 1))
    with pytest.raises(gapcheck.Error) as caught:
        gapcheck.start(deck)
    assert caught.value.file == str(deck) and caught.value.line == 3 and "missing.k" in caught.value.message
    with pytest.raises(gapcheck.Error, match="cannot be opened"):
        gapcheck.start(tmp_path / "none.k")
    for option, value in (("jobs", -1), ("picture", "yes"), ("includes", 5)):
        with pytest.raises(TypeError):
            gapcheck.start(deck, **{option: value})
    deck.write_text(content.replace("*KEYWORD\n", "*KEYWORD\n*AIRBAG_PARTICLE\n1,1,0,0,0,0,0,0\n", 1))
    start = gapcheck.start(deck)
    assert start.refused and start.refused[0].line == 2 and start.refused[0].file == str(deck)
    with pytest.raises(gapcheck.Error, match="not written over"):
        start.to_json(deck)
