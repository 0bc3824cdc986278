"""Corrections of decks."""
import json
import subprocess

import pytest
from conftest import DATA

import gapcheck


def test_a_fix_is_that_of_the_program(program, tmp_path):
    fix = gapcheck.fix(DATA / "two_plates.k")
    assert fix.solved and len(fix.moved) == 32 and fix.largest_move == pytest.approx(0.207821, abs=1e-6)
    assert fix.contacts[0].before.penetrations == 18 and fix.contacts[0].after.penetrations == 0
    assert fix.moved[0].start.shape == (3,) and (fix.moved[0].end != fix.moved[0].start).any()
    assert "solved" in repr(fix) and "largest_move" in dir(fix) and not fix.cut_short
    assert any("SST" in each.text for each in fix.proposals[0].alternatives)
    subprocess.run([program, "fix", DATA / "two_plates.k", "-o", tmp_path / "program"], check=True, capture_output=True)
    (path,) = fix.write(tmp_path / "package" / "deeper")
    assert path == str(tmp_path / "package" / "deeper" / "two_plates.k")
    assert (tmp_path / "program" / "two_plates.k").read_bytes() == (tmp_path / "package/deeper/two_plates.k").read_bytes()
    assert len(gapcheck.audit(path).penetrations) == 0
    assert json.loads(fix.to_json()) and "32 nodes moved" in fix.to_text()
    with pytest.raises(AttributeError):
        fix.nonsense


def test_the_deck_is_never_written_over(tmp_path):
    deck = tmp_path / "deck.k"
    content = (DATA / "two_plates.k").read_bytes()
    deck.write_bytes(content)
    (tmp_path / "link").symlink_to(tmp_path)
    fix = gapcheck.fix(deck)
    for folder in (tmp_path, str(tmp_path), tmp_path / "link", tmp_path / "new" / ".."):
        with pytest.raises((gapcheck.Error, OSError)):
            fix.write(folder)
    assert deck.read_bytes() == content and len(list(tmp_path.iterdir())) <= 3
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError):
        fix.write(tmp_path / "file")


def test_locks_and_priorities():
    locked = gapcheck.fix(DATA / "two_plates.k", lock_parts=1)
    assert locked.moved and all(node.node > 2000 for node in locked.moved)
    nodes = gapcheck.fix(DATA / "two_plates.k", lock_nodes=[(1001, 1016)])
    assert [node.node for node in nodes.moved] == [node.node for node in locked.moved]
    heavy = gapcheck.fix(DATA / "two_plates.k", priorities={1: 100.0})
    move = {part: max(abs(node.end - node.start).max() for node in heavy.moved if node.node // 1000 == part)
            for part in (1, 2)}
    assert move[1] < 0.1 * move[2]
    for wrong, error in (({"lock_parts": ["1"]}, TypeError), ({"lock_parts": [2.5]}, TypeError),
                         ({"lock_parts": [(3, 1)]}, gapcheck.Error), ({"lock_nodes": [2**70]}, ValueError),
                         ({"lock_parts": None}, TypeError), ({"priorities": {1: "x"}}, TypeError),
                         ({"priorities": {1: 0.0}}, gapcheck.Error), ({"priorities": 5}, TypeError)):
        with pytest.raises(error):
            gapcheck.fix(DATA / "two_plates.k", **wrong)


def test_a_fix_without_need():
    fix = gapcheck.fix(DATA / "clean.k")
    assert fix.solved and fix.moved == () and fix.write("/no such folder") == []
