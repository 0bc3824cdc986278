"""The rows of faults.py: each function injects one kind of fault and says what is wrong afterwards."""

import contextlib
import os
import shutil
import signal
import socket
import time

import faults
import programs

NOBODY = 65534
MB = programs.MB


def plates(n):
    """Two plates of n × n shells that penetrate; the run would take hours."""
    nodes, shells = [], []
    for plate in range(2):
        first = 1 + plate * (n + 1) ** 2
        for i in range(n + 1):
            for j in range(n + 1):
                corner = first + j + i * (n + 1)
                nodes.append(f"{corner},{i * 5},{j * 5},{0.9 if plate else 0.}")
                if i < n and j < n:
                    shells.append(f"{len(shells) + 1},{plate + 1},{corner},{corner + n + 1},{corner + n + 2},{corner + 1}")
    head = ["*KEYWORD", "*CONTROL_TERMINATION", "1000.0", "*SECTION_SHELL", "1,2", "1.,1.,1.,1.", "*MAT_ELASTIC",
            "1,7.8E-6,210.,0.3", "*PART", "a", "1,1,1", "*PART", "b", "2,1,1",
            "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", "", ""]
    return "\n".join([*head, "*NODE", *nodes, "*ELEMENT_SHELL", *shells, "*END", ""])


class Bench:
    """The programs, and a folder in which each row begins with the same files."""

    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.data = options.root / "data/two_plates.k"
        log = (options.root / "tests/apps/fixtures/smp/messag").read_bytes()
        self.files = {"p.k": plates(30).encode(), "small.k": plates(6).encode(), "messag": log, "long": log * 300,
                      "main.k": b"*KEYWORD\n*INCLUDE\nx.k\n*END\n"}
        self.limits = programs.Limits(memory=None, cpu=200 if options.sanitized else 20)
        self.durations, self.sizes = {}, {}

    def begin(self):
        """The files, and no others."""
        for path in self.folder.iterdir():
            os.chmod(path, 0o700, follow_symlinks=True) if path.is_dir() and not path.is_symlink() else None
            shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink()
        for name, data in self.files.items():
            (self.folder / name).write_bytes(data)
        return self

    def words(self, call, **names):
        """The words of a call: G audit D."""
        names |= {"G": str(self.options.gapcheck), "C": str(self.options.check_c), "D": str(self.data)}
        return [names.get(word, word) for word in call.split()]

    def start(self, call, limits=None, names=None, **more):
        return programs.Running(self.words(call, **(names or {})), self.folder, limits or self.limits, **more)

    def run(self, call, limits=None, names=None, **more):
        return self.start(call, limits, names, **more).wait()

    def piped(self, call, limits, names=None):
        """Standard output is thrown away; messages come through a pipe, which no limit of file sizes concerns."""
        read, write = os.pipe()
        with open(os.devnull, "wb") as null:
            ended = self.run(call, limits, names, out=null.fileno(), err=write)
        os.close(write)
        with os.fdopen(read, "rb") as pipe:
            return ended._replace(err=pipe.read())

    def duration(self, call):
        """Of an undisturbed call, and what it writes."""
        if call not in self.durations:
            self.begin()
            self.run(call)
            self.durations[call] = min(self.run(call).seconds for _ in range(2))
        return self.durations[call]

    def read(self, name):
        path = self.folder / name
        return path.read_bytes() if path.is_file() else None

    def fragments(self):
        return [str(path.relative_to(self.folder)) for path in self.folder.rglob(".gapcheck-*")]


def wrong_end(ended, codes=(0, 1, 2), named=()):
    """What is wrong with the end of a program as such."""
    found = []
    if ended.code not in codes:
        found.append(f"ends with {ended.how()}, not {' or '.join(map(str, codes))}: {ended.text[:300]}")
    elif ended.code == 2:
        if "error: " not in ended.text:
            found.append("exit 2 without a message")
        for name in named:
            if name not in ended.text:
                found.append(f"no message has {name!r}: {ended.text[:300]}")
    return found


# ---- The groups. Each function gives the problems of one row.

def standard_output(bench, call, end):
    bench.begin()
    read, write = os.pipe()
    os.close(read)
    full = os.open("/dev/full", os.O_WRONLY)
    words = bench.words(call)
    if end == "closed":
        words = ["/bin/sh", "-c", 'exec "$0" "$@" >&-', *words]
    ended = programs.run(words, bench.folder, bench.limits, out={"full": full, "pipe": write}.get(end))
    os.close(write)
    os.close(full)
    return wrong_end(ended, (2,), ("cannot be written: ", *(("Broken pipe",) if end == "pipe" else ())))


def full_disk(bench, call, share):
    bench.begin()
    written = next((names for key, names in faults.WRITTEN.items() if key in call), ["F"])
    folder = "out" if " run " in call else None
    if call not in bench.sizes:
        bench.run(call)
        sizes = [path.stat().st_size for path in (bench.folder / folder).iterdir()] if folder else [
            (bench.folder / name).stat().st_size for name in written]
        bench.sizes[call] = max(sizes)
        bench.begin()
    for name in written if not folder else []:
        (bench.folder / name).parent.mkdir(exist_ok=True)
        (bench.folder / name).write_text("good")
    ended = bench.piped(call, bench.limits._replace(file_size=int(share * bench.sizes[call]), from_start=True))
    found = wrong_end(ended, (2,), ("File too large",))
    for name in written if not folder else []:
        if bench.read(name) != b"good":
            found.append(f"{name} has changed")
    if bench.fragments():
        found.append(f"left: {bench.fragments()}")
    return found


def interrupted(bench, command, name, moment):
    words = faults.INTERRUPTED[command]
    call = " ".join(["G", *words])
    outputs = [word for word in ("page", "grid", "sets", "key", "known", "table", "report", "fixed/p.k") if
               word in words or (word == "fixed/p.k" and command == "fix")]
    if command != "run" and call not in bench.sizes:
        bench.duration(call)
        bench.sizes[call] = {output: bench.read(output) for output in outputs}
    bench.begin()
    for output in outputs:
        (bench.folder / output).parent.mkdir(exist_ok=True)
        (bench.folder / output).write_text("old")
    running = bench.start(call)
    if command == "run":
        time.sleep(0.01 * moment)
    elif moment % 2 == 0:
        time.sleep(bench.duration(call) * moment / faults.MOMENTS)
    else:
        # Around the writing, which is short.
        while not running.has_ended() and not bench.fragments():
            pass
        time.sleep(0.0002 * moment)
    number = signal.Signals[name]
    running.send(number)
    ended = running.wait()
    found = [f"left: {bench.fragments()}"] if bench.fragments() else []
    if command == "run":
        return found + wrong_end_of_run(bench, ended, number)
    if ended.signal != number and ended.code not in (0, 1):
        found.append(f"ends with {ended.how()}: {ended.text[:300]}")
    for output in outputs:
        if bench.read(output) not in (b"old", bench.sizes[call][output]):
            found.append(f"{output} is neither the old nor the new one")
        if ended.code is not None and bench.read(output) == b"old":
            found.append(f"{output} is the old one after {ended.how()}")
    return found


def wrong_end_of_run(bench, ended, number):
    if ended.signal == number:
        return ["out/messag is there, but without its end"] if (bench.folder / "out/messag").exists() else []
    found = wrong_end(ended, (2,), (f"terminated by {number.name}",))
    for log in ("messag", "d3hsp"):
        text = bench.read(f"out/{log}") or b""
        if b" *** terminated by a signal ***" not in text or not text.endswith(b"E r r o r   t e r m i n a t i o n\n"):
            found.append(f"{log} does not say that the run was ended")
    plot = programs.run([str(bench.options.gapcheck), "compare", "out", "out"], bench.folder, bench.limits)
    programs.LAST = ended
    return found + ([f"its results cannot be read: {plot.text[:300]}"] if plot.code != 0 else [])


def little_memory(bench, call, megabytes):
    bench.begin()
    ended = bench.run(call, bench.limits._replace(memory=megabytes * MB, from_start=True))
    return wrong_end(ended) + ([f"left: {bench.fragments()}"] if bench.fragments() else [])


def few_descriptors(bench, call, count):
    bench.begin()
    ended = bench.run(call, bench.limits._replace(files=count, from_start=True))
    if ended.code == 127 and count <= 3:
        return []  # the libraries of the program take one
    return wrong_end(ended) + ([f"left: {bench.fragments()}"] if bench.fragments() else [])


def put_instead(bench, path, what):
    """Something that is not a readable file; its name."""
    if what == "folder":
        path.mkdir()
    elif what == "pipe":
        os.mkfifo(path)
    elif what == "socket":
        # The address of a socket has no room for the path of a deep folder.
        here = os.open(path.parent, os.O_PATH)
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(f"/proc/self/fd/{here}/{path.name}")
        os.close(here)
    elif what == "link to itself":
        path.symlink_to(path.name)
    elif what == "link to nothing":
        path.symlink_to("nothing")
    elif what == "device":
        path.symlink_to("/dev/zero")
    elif what == "file without permission":
        path.write_bytes(bench.files["p.k"])
        path.chmod(0)
    elif what == "below a file":
        return "messag/x.k"
    elif what == "name too long":
        return "x" * 300
    return path.name


def wrong_input(bench, kind, what):
    bench.begin()
    call, name = faults.INPUTS[kind]
    named = put_instead(bench, bench.folder / name, what)
    if kind == "include":
        (bench.folder / "main.k").write_text(f"*KEYWORD\n*INCLUDE\n{named}\n*END\n")
    limits = bench.limits
    if what == "file without permission" and os.geteuid() == 0:
        for path in (bench.folder, bench.folder.parent):
            path.chmod(0o777)
        limits = limits._replace(user=NOBODY)
    ended = bench.run(call, limits, {"WHAT": named})
    return wrong_end(ended, (2,), ("main.k" if kind == "include" else named[:100],))


def wrong_output(bench, call, place):
    bench.begin()
    # fix and run make their folder.
    folder = " -o " in call
    limits = bench.limits
    name = {"a folder": "there", "below a file": "messag/F", "in a missing folder": "nowhere/at/all/F",
        "link to itself": "F",
            "/dev/full": "/dev/full", "name too long": "x" * 300, "empty name": "", "folder without permission":
                "closed/F"}[place]
    (bench.folder / "there").mkdir()
    (bench.folder / "closed").mkdir()
    if place == "link to itself":
        (bench.folder / "F").symlink_to("F")
    if place == "folder without permission":
        (bench.folder / "closed").chmod(0o555)
        if os.geteuid() == 0:
            for path in (bench.folder, bench.folder.parent):
                path.chmod(0o777)
            limits = limits._replace(user=NOBODY)
    words = [name if word == "F" else word for word in bench.words(call)]
    ended = programs.run(words, bench.folder, limits)
    if (folder and place in faults.FOLDERS) or (not folder and place == "empty name"):
        return wrong_end(ended, (0, 1))
    return wrong_end(ended, (2,), (name[:100] or "-o",))


def changed_input(bench, reading, what, moment):
    call, name = faults.READING[reading]
    long = bench.duration(call)
    bench.begin()
    (bench.folder / "fixed").mkdir()
    (bench.folder / "fixed/p.k").write_text("old")
    path = bench.folder / name
    running = bench.start(call)
    time.sleep(long * moment / faults.CHANGE_MOMENTS * 0.9)
    if what == "grows":
        with open(path, "ab") as file:
            file.write(b"$ one more line\n" * 1000)
    elif what == "shrinks":
        os.truncate(path, 4096)
    elif what == "is replaced":
        (bench.folder / "other").write_bytes(bench.files[name][::-1])
        os.replace(bench.folder / "other", path)
    else:
        path.unlink()
        if what == "becomes a folder":
            path.mkdir()
    ended = running.wait()
    found = wrong_end(ended)
    if ended.code == 2 and name not in ended.text:
        found.append(f"no message names {name}: {ended.text[:300]}")
    fixed = bench.read("fixed/p.k")
    if fixed is None or b"\0" in fixed or (ended.code == 2 and fixed != b"old"):
        found.append(f"fixed/p.k is wrong after {ended.how()}")
    if fixed != b"old" and b"*ELEMENT_SHELL" not in fixed:
        found.append("fixed/p.k is not whole")
    return found + ([f"left: {bench.fragments()}"] if bench.fragments() else [])


def open_or_none(path):
    return open(path, "rb") if path.exists() else contextlib.nullcontext()


def size_of(file):
    return os.fstat(file.fileno()).st_size if file else 0


def vanishing_folder(bench, command, what, moment):
    call = faults.VANISHING[command]
    long = bench.duration(call if command != "audit" else "G audit p.k")
    bench.begin()
    folder = bench.folder / ("fixed" if command == "fix" else "out")
    folder.mkdir()
    running = bench.start(call)
    time.sleep(long * moment / faults.VANISH_MOMENTS)
    name = {"fix": "p.k", "run": "messag", "audit": "page"}[command]
    # A run writes to its files until it ends. The other commands give a file its name when it is complete.
    with open_or_none(folder / name) as file:
        finished = running.has_ended() or (command != "run" and file is not None)
        folder.rename(bench.folder / "gone")
        # It may have got its name since the look for it.
        finished |= command != "run" and (bench.folder / "gone" / name).exists()
        if what == "removed":
            shutil.rmtree(bench.folder / "gone", ignore_errors=True)
        written = size_of(file)
        ended = running.wait()
        # What is removed after its last byte nobody can notice.
        finished |= file is not None and written > 0 and size_of(file) == written
    # fix and run make the folder again where they have not begun to write.
    found = wrong_end(ended)
    if ended.code != 2 and not finished and not (folder / name).exists():
        found.append(f"{ended.how()}, and {folder.name}/{name} is not there")
    return found + ([f"left: {bench.fragments()}"] if bench.fragments() else [])


def no_threads(bench, call, jobs):
    if os.geteuid() != 0:
        return []
    bench.begin()
    for path in (bench.folder, bench.folder.parent):
        path.chmod(0o777)
    free = bench.run(f"{call} --jobs {jobs}")
    ended = bench.run(f"{call} --jobs {jobs}", bench.limits._replace(user=NOBODY, processes=1))
    if jobs == 1:
        same = ended.code == free.code and ended.err == free.err
        return wrong_end(ended) + ([] if same else [f"ends with {ended.how()}, not {free.how()}: {ended.text[:300]}"])
    return wrong_end(ended, (free.code, 2)) + (
        ["no message names --jobs 1"] if ended.code == 2 != free.code and "--jobs 1" not in ended.text else [])


def all_rows(sanitized):
    """Group, name, function and its arguments."""
    rows = []

    def add(group, function, *lists):
        combinations = [[]]
        for values in lists:
            combinations = [[*before, value] for before in combinations for value in values]
        rows.extend((group, f"{group}: {', '.join(map(str, values))}", function, values) for values in combinations)

    add("standard output", standard_output, faults.PRINTING, faults.ENDS_OF_OUTPUT)
    add("full disk", full_disk, faults.WRITING, faults.SHARES)
    add("signals", interrupted, faults.INTERRUPTED, faults.SIGNALS, range(faults.MOMENTS))
    if not sanitized:
        add("memory in MB", little_memory, faults.LIMITED, faults.MEMORY)
        add("threads", no_threads, faults.THREADLESS, [1, 4])
    add("descriptors", few_descriptors, faults.LIMITED, faults.DESCRIPTORS)
    add("inputs", wrong_input, faults.INPUTS, faults.INSTEAD)
    add("outputs", wrong_output, faults.OUTPUTS, faults.PLACES)
    add("inputs that change", changed_input, faults.READING, faults.CHANGES, range(1, faults.CHANGE_MOMENTS + 1))
    add("folders that vanish", vanishing_folder, faults.VANISHING, faults.VANISH, range(faults.VANISH_MOMENTS))
    return rows
