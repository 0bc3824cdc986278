"""Callbacks, Ctrl-C and threads."""
import multiprocessing
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import DATA

import gapcheck

PLATES = DATA / "two_plates.k"


class Own(Exception):
    pass


def test_progress_sees_every_step():
    steps = []
    report = gapcheck.audit(PLATES, progress=lambda *step: steps.append(step))
    names, done, every = zip(*steps)
    assert done == tuple(range(len(steps))) and set(every) == {len(steps)}
    assert names[:3] == ("read", "model", "GC101") and names[-1] == "records" and len(steps) > 70
    assert report.to_csv() == gapcheck.audit(PLATES).to_csv()


@pytest.mark.parametrize("last", ["read", "model", "GC101", "GC510", "records"])
def test_progress_stops_an_audit(last):
    seen = []

    def progress(step, done, every):
        seen.append(step)
        return step != last
    with pytest.raises(gapcheck.Error, match="the audit was stopped"):
        gapcheck.audit(PLATES, progress=progress)
    assert seen[-1] == last


@pytest.mark.parametrize("raised", [Own("mine"), KeyboardInterrupt(), SystemExit(3), MemoryError()])
def test_what_progress_raises_is_raised(raised):
    seen = []

    def progress(step, done, every):
        seen.append(step)
        if step == "GC101":
            raise raised
    with pytest.raises(type(raised)) as caught:
        gapcheck.audit(PLATES, progress=progress)
    assert caught.value is raised and seen == ["read", "model", "GC101"]
    assert any(entry.name == "progress" for entry in caught.traceback)


def test_progress_of_wrong_arguments():
    with pytest.raises(TypeError, match="positional"):
        gapcheck.audit(PLATES, progress=lambda: True)


def test_watch_sees_every_cycle(tmp_path):
    states = []
    summary = gapcheck.run(PLATES, tmp_path / "out", cycles=5, watch=states.append)
    assert summary.end == "cycles" and summary.state.cycle == 5 == states[-1].cycle and len(states) >= 5
    assert states[0].contacts[0].id == 1 and states[0].contacts[0].force_a.shape == (3,)
    assert [state.cycle for state in states] == sorted(state.cycle for state in states)
    assert states[-1].time > states[0].time and "messag" in summary.files


def test_watch_ends_a_run(tmp_path):
    summary = gapcheck.run(PLATES, tmp_path / "out", until=1.0, watch=lambda state: state.cycle < 20)
    assert summary.end == "stopped" and 20 <= summary.state.cycle <= 22
    with pytest.raises(Own, match="mine"):
        def watch(state):
            if state.cycle == 7:
                raise Own("mine")
        gapcheck.run(PLATES, tmp_path / "out", until=1.0, watch=watch)
    with pytest.raises(TypeError, match="watch"):
        gapcheck.run(PLATES, tmp_path / "out", watch="me")


def interrupted(script, *arguments):
    """Runs a script, sends it Ctrl-C a little after it prints a line, and gives what it prints behind."""
    child = subprocess.Popen([sys.executable, "-c", script, *map(str, arguments)], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True)
    try:
        assert child.stdout.readline() == "begins\n"
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        return child.communicate(timeout=60)[0]
    finally:
        child.kill()


def test_ctrl_c_ends_a_run_in_order(tmp_path):
    script = """
import sys, gapcheck
print("begins", flush=True)
try:
    gapcheck.run(sys.argv[1], sys.argv[2], until=1.0)
    print("ended")
except KeyboardInterrupt:
    print("interrupted")
"""
    assert interrupted(script, PLATES, tmp_path / "out") == "interrupted\n"
    run = gapcheck.read_run(tmp_path / "out").run
    assert run.cycles > 0 and 0 < run.problem_time < 0.9 and run.termination != "unknown"


def test_ctrl_c_ends_audits(tmp_path, large):
    deck = tmp_path / "large.k"
    deck.write_text(large)
    script = """
import sys, gapcheck
print("begins", flush=True)
try:
    for round in range(1000):
        gapcheck.audit(sys.argv[1])
except KeyboardInterrupt:
    print("interrupted")
"""
    assert interrupted(script, deck) == "interrupted\n"


def test_signals_arrive_during_an_audit(large):
    """The handler runs between the steps: several times in one call, where it would wait for its end otherwise."""
    calls = []
    before = signal.signal(signal.SIGALRM, lambda *_: calls.append(time.monotonic()))
    signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
    try:
        gapcheck.audit_text(large)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert len(calls) >= 4, calls

    class Stop(Exception):
        pass

    def stop(*_):
        raise Stop
    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, 0.02)
    try:
        with pytest.raises(Stop):
            gapcheck.audit_text(large)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_other_threads_run_during_an_audit(large):
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)
    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    try:
        gapcheck.audit_text(large, jobs=1)
        end = time.monotonic()
    finally:
        done.set()
        thread.join()
    inside = [at for at in ticks if begin < at < end]
    pauses = [b - a for a, b in zip([begin, *inside], [*inside, end])]
    assert len(inside) > 20 and max(pauses) < 0.5 * (end - begin)


def test_audits_in_threads():
    decks = [PLATES, DATA / "solid_on_solid.k", DATA / "tied_then_contact.k", DATA / "triangle.k"] * 3
    alone = [gapcheck.audit(deck).to_csv() for deck in decks]
    seen = []
    with ThreadPoolExecutor(6) as pool:
        together = list(pool.map(lambda deck: gapcheck.audit(deck, progress=lambda *step: seen.append(step)).to_csv(),
                                 decks))
    assert together == alone and len(seen) > 12 * 70


def number_of_penetrations(deck):
    return len(gapcheck.audit(deck).penetrations)


def test_audits_in_processes():
    """Also in processes that begin as a copy of one that has audited with its threads."""
    assert number_of_penetrations(PLATES) == 18
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(number_of_penetrations, [PLATES] * 4).get(60) == [18] * 4
        with pytest.raises(gapcheck.Error, match="cannot be opened"):
            pool.apply_async(number_of_penetrations, ["none.k"]).get(60)


def test_objects_may_be_let_go_in_any_thread():
    def use():
        for _ in range(5):
            report = gapcheck.audit(PLATES, mesh=True)
            array, finding = report.mesh.points, report.findings[0]
            del report
            assert array[0, 0] == 0 and finding.id
    threads = [threading.Thread(target=use) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
