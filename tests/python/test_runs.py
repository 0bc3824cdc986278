"""Runs and their files, comparisons."""
import json
import shutil
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


@pytest.fixture(scope="module")
def bumper(tmp_path_factory):
    """The directory of a short run of three parts, with matsum as text and in a binout."""
    folder = tmp_path_factory.mktemp("bumper") / "out"
    gapcheck.run(DATA / "tutorial/bumper.k", folder, cycles=60, binout=True)
    return folder


ENERGIES = ("internal", "kinetic", "hourglass", "eroded_internal", "eroded_hourglass")
VECTORS = ("momentum", "velocity")


def test_parts_are_those_of_matsum(bumper):
    parts = gapcheck.read_run(bumper).parts
    count = (bumper / "matsum").read_text().count(" time =")
    assert parts.part.tolist() == [1, 2, 3] and parts.title == ("crash box", "front plate", "bumper beam")
    assert parts.times.shape == (count,) and count > 4 and (numpy.diff(parts.times) > 0).all()
    assert all(getattr(parts, name).shape == (count, 3) for name in ENERGIES)
    assert all(getattr(parts, name).shape == (count, 3, 3) for name in VECTORS)
    # Numbers as they stand in the text: a state's energies and momenta, part after part.
    state = (bumper / "matsum").read_text().split(" time =")[-1]
    for label, array in (("inten=", parts.internal), ("kinen=", parts.kinetic), ("hgeng=", parts.hourglass),
                         ("x-mom=", parts.momentum[..., 0]), ("z-mom=", parts.momentum[..., 2])):
        assert [float(piece.split()[0]) for piece in state.split(label)[1:]] == array[-1].tolist(), label
    assert abs(parts.momentum).max() > 0 and parts.internal.max() > 0


def test_parts_of_text_and_binout_are_equal(bumper, tmp_path):
    shutil.copytree(bumper, tmp_path / "out")
    (tmp_path / "out/matsum").unlink()
    text, binout = gapcheck.read_run(bumper).parts, gapcheck.read_run(tmp_path / "out").parts
    assert text.part.tolist() == binout.part.tolist()
    for name in ("times", *ENERGIES, *VECTORS):
        first, second = getattr(text, name), getattr(binout, name)
        # The text has five digits.
        assert first.shape == second.shape and numpy.allclose(first, second, rtol=5.1e-5, atol=0), name
    assert (text.internal != binout.internal).any(), "the binout has more digits"
    for file in (tmp_path / "out").glob("binout*"):
        file.unlink()
    assert gapcheck.read_run(tmp_path / "out").parts is None


def test_parts_are_views_and_curves(bumper):
    report = gapcheck.read_run(bumper)
    parts = report.parts
    curves = gapcheck.read_curves(bumper)
    assert curves["matsum part 2 kinetic energy"].values.tolist() == parts.kinetic[:, 1].tolist()
    assert curves["matsum part 3 y-momentum"].times.tolist() == parts.times.tolist()
    assert curves["matsum part 1 resultant momentum"].values == pytest.approx(
        numpy.linalg.norm(parts.momentum[:, 0], axis=1))
    momentum, kept = parts.momentum, parts.momentum.tolist()
    assert not momentum.flags.writeable and not momentum.flags.owndata
    assert momentum.__array_interface__["data"] == report.parts.momentum.__array_interface__["data"]
    del report, parts
    assert momentum.tolist() == kept


def test_a_damaged_matsum_is_said_and_read_as_far_as_it_goes(bumper, tmp_path):
    shutil.copytree(bumper, tmp_path / "out")
    for binout in (tmp_path / "out").glob("binout*"):
        binout.unlink()
    matsum = tmp_path / "out/matsum"
    lines = matsum.read_text().splitlines(keepends=True)
    bad = next(i for i, line in enumerate(lines) if "kinen=" in line)
    lines[bad] = lines[bad].replace("kinen=   3", "kinen=   *")
    matsum.write_text("".join(lines[:-20]))
    report = gapcheck.read_run(tmp_path / "out")
    whole = gapcheck.read_run(bumper).parts
    assert len(report.parts.times) == len(whole.times) - 1 and numpy.isnan(report.parts.kinetic[0, 0])
    assert report.parts.kinetic[1:].tolist() == whole.kinetic[1:-1].tolist() and not report.complete
    fault = next(each for each in report.diagnostics if each.severity == "error")
    assert fault.file == str(matsum) and fault.line == bad + 1 and "cannot be read" in fault.message


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
