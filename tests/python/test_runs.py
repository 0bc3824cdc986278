"""Runs and their files, comparisons."""
import json
import subprocess

import numpy
import pytest
from conftest import DATA

import gapcheck


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Two directories of runs: of two plates, and of the same with IGNORE = 2."""
    folder = tmp_path_factory.mktemp("runs")
    for name, deck in (("plates", "two_plates.k"), ("ignore", "ignore_2.k")):
        summary = gapcheck.run(DATA / deck, folder / name)
        assert summary.end == "time" and summary.failure == "" and len(summary.files) >= 6
        assert {path.name for path in (folder / name).iterdir()} >= set(summary.files)
    return folder


def test_a_run_is_that_of_the_program(runs, program, tmp_path):
    subprocess.run([program, "run", DATA / "two_plates.k", "-o", tmp_path / "out", "--quiet"], check=True)
    for name in ("glstat", "d3plot"):
        assert (tmp_path / "out" / name).read_bytes() == (runs / "plates" / name).read_bytes(), name


def test_what_a_run_has_written(runs):
    report = gapcheck.read_run(runs / "plates")
    assert report.source == "messag" and report.run.termination == "normal" and report.run.cycles > 0
    assert len(report.penetrations) == 18 and report.run.timesteps.contact > 0
    assert report.penetrations.depth.max() == pytest.approx(0.3)
    same = gapcheck.read_log([runs / "plates" / "messag", str(runs / "plates" / "d3hsp")])
    assert len(same.penetrations) == 18 and same.run.version == report.run.version
    with pytest.raises(gapcheck.Error):
        gapcheck.read_run([])
    with pytest.raises(gapcheck.Error):
        gapcheck.read_run(runs)
    with pytest.raises(gapcheck.Error, match="is not a rule on runs"):
        gapcheck.read_run(runs / "plates", select="GC1")


def test_curves(runs):
    curves = gapcheck.read_curves(runs / "plates")
    assert curves.complete and len(curves) > 5 and repr(curves) == f"<Curves: {len(curves)}>"
    names = [name for name in curves if "kinetic" in name]
    assert names
    curve = curves[names[0]]
    assert curve.times.shape == curve.values.shape and len(curve.times) > 1 and (numpy.diff(curve.times) > 0).all()
    again = gapcheck.read_curves(runs / "plates")[names[0]]
    first, second = curve.values, curve.values
    assert first is not second and first.__array_interface__["data"][0] == second.__array_interface__["data"][0]
    assert not first.flags.owndata and not first.flags.writeable
    values, kept = curve.values, curve.values.tolist()
    del curves, curve
    assert values.tolist() == kept == again.values.tolist()
    with pytest.raises(KeyError):
        gapcheck.read_curves(runs / "plates")["no such curve"]
    with pytest.raises(gapcheck.Error, match="is not a directory"):
        gapcheck.read_curves(runs / "none")


def test_motion(runs):
    motion = gapcheck.read_motion(runs / "plates")
    count, nodes = len(motion.times), len(motion.node)
    assert motion.positions.shape == motion.velocities.shape == (count, nodes, 3) and motion.start.shape == (nodes, 3)
    report = gapcheck.audit(DATA / "two_plates.k", mesh=True)
    order = numpy.argsort(report.mesh.node)
    assert motion.node.tolist() == report.mesh.node[order].tolist()
    assert repr(motion).startswith(f"Motion(node=<32>, start=<32 × 3>, times=<{count}>, positions=<{count} × 32 × 3>")
    # Nodes begin where the audit says that the solver puts them.
    expected = dict(zip(report.mesh.node.tolist(), report.mesh.points.tolist()))
    expected.update(zip(report.penetrations.node.tolist(), report.penetrations.moved_to.tolist()))
    begin = numpy.array([expected[node] for node in motion.node.tolist()])
    assert numpy.allclose(motion.start, begin, atol=1e-5) and numpy.allclose(motion.positions[0], begin, atol=1e-5)
    assert abs(motion.start - report.mesh.points[order]).max() > 0.2
    last = gapcheck.read_motion(runs / "plates" / "d3plot", states=count - 1, velocities=False)
    assert last.positions.tolist() == motion.positions[-1:].tolist() and last.velocities.shape == (0, nodes, 3)
    positions, kept = motion.positions, motion.positions.tolist()
    assert not positions.flags.writeable and not positions.flags.owndata
    del motion
    assert positions.tolist() == kept
    for wrong, error in ((count, gapcheck.Error), (-1, TypeError), (0.5, TypeError), ("0", TypeError), (2**64, TypeError)):
        with pytest.raises(error, match="states"):
            gapcheck.read_motion(runs / "plates", states=wrong)
    with pytest.raises(gapcheck.Error):
        gapcheck.read_motion(runs / "plates" / "messag")


def test_comparisons(runs, program):
    same = gapcheck.compare(DATA / "two_plates.k", runs / "plates")
    assert same.equal and same.complete and same.contacts[0].agree == 18 and same.curves is None
    assert same.first.source == "deck" and same.second.source == "messag" and "equal" in repr(same)
    different = gapcheck.compare(DATA / "two_plates.k", DATA / "two_plates_tilted.k")
    assert not different.equal and len(different.differences) == 29
    assert different.contacts.to_frame()["only_second"].tolist() == [11]
    one = [each for each in different.differences if each.second is None][0]
    assert one.first > 0 and one.contact == 1
    done = subprocess.run([program, "compare", DATA / "two_plates.k", DATA / "two_plates_tilted.k"], capture_output=True,
                          text=True)
    assert different.to_text() == done.stdout
    assert json.loads(different.to_json())["equal"] is False
    curves = gapcheck.compare(runs / "plates", runs / "ignore")
    assert len(curves.curves.pairs) > 5 and curves.motion.times.ndim == 1
    assert curves.curves.pairs[0].verdict in ("agrees", "differs", "no common times")
    assert curves.motion.parts[0].largest.shape == curves.motion.times.shape
    only = gapcheck.compare(runs / "plates", runs / "ignore", curves=False)
    assert only.curves is None


def test_runs_that_cannot_begin(tmp_path):
    with pytest.raises(gapcheck.Error) as caught:
        gapcheck.run(DATA / "clean.k", DATA / "clean.k")
    assert caught.value.message
    with pytest.raises(gapcheck.Error, match="until"):
        gapcheck.run(DATA / "two_plates.k", tmp_path / "out", until=float("nan"))
    with pytest.raises(TypeError, match="cycles"):
        gapcheck.run(DATA / "two_plates.k", tmp_path / "out", cycles=1.5)
    with pytest.raises(TypeError):
        gapcheck.run(DATA / "two_plates.k", None)
