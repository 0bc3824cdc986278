"""Ctrl-C ends long calls at once, leaves nothing half-written, and costs no memory."""
import os
import signal
import subprocess
import sys
import time

import pytest
from conftest import DATA

import gapcheck

SCRIPT = """
import sys, gapcheck
print("begins", flush=True)
try:
    getattr(gapcheck, sys.argv[1])(*sys.argv[2:])
    print("ended")
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.fixture(scope="module")
def inputs(tmp_path_factory, large):
    """What each function reads, some seconds long."""
    folder = tmp_path_factory.mktemp("inputs")
    (folder / "first.k").write_text(large)
    (folder / "second.k").write_text(large)
    run = folder / "run"
    gapcheck.run(DATA / "two_plates.k", run, cycles=2)
    with open(run / "messag", "a") as messag:
        messag.write(" a line that says nothing of contacts, of which there may be many in the files of a long run\n" * 4_000_000)
    return {"fix": (folder / "first.k",), "compare": (folder / "first.k", folder / "second.k"), "read_run": (run,),
            "start": (folder / "first.k",)}


def files_in(folder):
    return sorted((str(path), path.stat().st_size) for path in folder.rglob("*") if path.is_file())


@pytest.mark.parametrize("name", ["fix", "compare", "read_run", "start"])
def test_ctrl_c_ends_a_call_and_leaves_nothing(name, inputs, tmp_path):
    """Also fix, which takes minutes for this deck."""
    before = files_in(inputs[name][0].parent)
    child = subprocess.Popen([sys.executable, "-c", SCRIPT, name, *map(str, inputs[name])], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, cwd=tmp_path)
    try:
        assert child.stdout.readline() == "begins\n"
        time.sleep(0.1)
        begin = time.monotonic()
        child.send_signal(signal.SIGINT)
        assert child.communicate(timeout=60)[0] == "interrupted\n"
        assert time.monotonic() - begin < 3  # a second, on an idle machine much less
    finally:
        child.kill()
    assert files_in(inputs[name][0].parent) == before and list(tmp_path.iterdir()) == []


class Alarm:
    """Raises KeyboardInterrupt in this thread after a time, as Ctrl-C does."""

    def __init__(self, seconds):
        self.seconds = seconds

    def __enter__(self):
        def ring(*_):
            raise KeyboardInterrupt
        self.before = signal.signal(signal.SIGALRM, ring)
        signal.setitimer(signal.ITIMER_REAL, self.seconds)

    def __exit__(self, *_):
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, self.before)


@pytest.mark.parametrize("name", ["compare", "read_run", "start"])
def test_an_interrupted_call_ends_before_its_time(name, inputs):
    """Of three tries, for the sake of busy machines."""
    def seconds(alarm=None):
        begin = time.monotonic()
        if alarm is None:
            getattr(gapcheck, name)(*inputs[name])
        else:
            with pytest.raises(KeyboardInterrupt), Alarm(alarm):
                getattr(gapcheck, name)(*inputs[name])
        return time.monotonic() - begin
    whole = seconds()
    assert min(seconds(whole / 10) for _ in range(3)) < 0.6 * whole


def resident():
    """Bytes of memory that this process holds."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.parametrize("name", ["fix", "compare", "read_run"])
def test_interrupted_calls_give_their_memory_back(name, inputs):
    def interrupt():
        with pytest.raises(KeyboardInterrupt), Alarm(0.05):
            getattr(gapcheck, name)(*inputs[name])
    for _ in range(3):
        interrupt()
    held = resident()
    for _ in range(10):
        interrupt()
    # Each call reads 17 MB at least, and makes a model of it. Which blocks fit into gaps of large pages differs from call to call.
    assert resident() - held < 100e6


def test_a_write_that_is_interrupted_leaves_nothing(tmp_path, monkeypatch):
    fix = gapcheck.fix(DATA / "two_plates.k")

    def interrupted(*_):
        raise KeyboardInterrupt
    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        fix.write(tmp_path / "fixed")
    assert list((tmp_path / "fixed").iterdir()) == []
