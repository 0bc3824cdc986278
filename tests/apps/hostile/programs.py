"""Starts the programs under limits and says how they ended."""

import os
import resource
import select
import signal
import subprocess
import time
from typing import NamedTuple

MB = 1 << 20
LAST = None  # of this process: how the last program ended


def broken(folder, script):
    """A program that does what a shell script says, whatever its arguments: for the tests of the tests."""
    path = os.path.join(folder, "broken")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"#!/bin/sh\n{script}\n")
    os.chmod(path, 0o755)
    return path


class Limits(NamedTuple):
    """None: no limit. Seconds of the wall clock are many, because the machine may have other work."""
    memory: int | None = 1024 * MB
    cpu: int | None = 20
    wall: float = 300
    file_size: int | None = 256 * MB
    files: int | None = None
    processes: int | None = None
    user: int | None = None  # another user, without rights of root; for root only
    from_start: bool = False  # set before the program is loaded, which costs more than the start itself


class Ended(NamedTuple):
    code: int | None  # None: by a signal
    signal: int
    out: bytes
    err: bytes
    seconds: float
    megabytes: float
    stopped: bool = False  # at the limit of the wall clock

    @property
    def text(self):
        return self.err.decode(errors="replace")

    def how(self):
        if self.stopped:
            return f"did not end within {self.seconds:.0f} s"
        return f"exit {self.code}" if self.code is not None else f"{signal.Signals(self.signal).name}"


def set_limits(limits, process=0):
    for kind, value in ((resource.RLIMIT_AS, limits.memory), (resource.RLIMIT_CPU, limits.cpu),
                        (resource.RLIMIT_FSIZE, limits.file_size), (resource.RLIMIT_NOFILE, limits.files),
                        (resource.RLIMIT_NPROC, limits.processes), (resource.RLIMIT_CORE, 0)):
        if value is not None:
            # After the soft limit of time comes SIGXCPU, after the hard one SIGKILL.
            resource.prlimit(process, kind, (value, value + 2 if kind == resource.RLIMIT_CPU else value))


class Running:
    """A program that runs beside the test."""

    def __init__(self, words, folder, limits=Limits(), out=None, err=None, environment=None):
        """`out`, `err`: descriptors or None, then the text is kept."""
        self.limits = limits
        self.out = os.memfd_create("out") if out is None else None
        self.err = os.memfd_create("err") if err is None else None
        more = {"user": limits.user, "group": limits.user, "extra_groups": []} if limits.user is not None else {}
        from_start = limits.from_start or limits.user is not None
        if from_start:
            more["preexec_fn"] = lambda: set_limits(limits)
        self.begin = time.monotonic()
        self.process = subprocess.Popen(
            words, cwd=folder, stdin=subprocess.DEVNULL, stdout=self.out if out is None else out,
            stderr=self.err if err is None else err,
            env={**os.environ, "NO_COLOR": "1", **(environment or {})}, **more)
        self.descriptor = os.pidfd_open(self.process.pid)
        if not from_start:
            set_limits(limits, self.process.pid)

    def has_ended(self, seconds=0.0):
        waiting = select.poll()
        waiting.register(self.descriptor, select.POLLIN)
        return bool(waiting.poll(seconds * 1000))

    def send(self, number):
        if not self.has_ended():
            os.kill(self.process.pid, number)

    def wait(self):
        stopped = not self.has_ended(self.limits.wall)
        if stopped:
            self.process.kill()
        _, status, usage = os.wait4(self.process.pid, 0)
        seconds = time.monotonic() - self.begin
        self.process.returncode = os.waitstatus_to_exitcode(status)
        os.close(self.descriptor)
        code = os.WEXITSTATUS(status) if os.WIFEXITED(status) else None
        number = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
        global LAST
        LAST = Ended(code, number, text_of(self.out), text_of(self.err), seconds, usage.ru_maxrss / 1024, stopped)
        return LAST


def text_of(descriptor):
    if descriptor is None:
        return b""
    with os.fdopen(descriptor, "rb") as file:
        file.seek(0)
        return file.read()


def processor_seconds():
    """Of all programs that have been started and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(words, folder, limits=Limits(), **more):
    return Running(words, folder, limits, **more).wait()
