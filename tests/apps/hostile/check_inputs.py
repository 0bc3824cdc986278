#!/usr/bin/env python3
"""Gives the hostile inputs of inputs.py to the programs and holds the answers against docs/reliability.md.

    check_inputs.py GAPCHECK CHECK_C ROOT [--sample N] [--rounds N] [--only TEXT] [--keep FOLDER] [--self-test]

Each input has a name, by which --only finds it again; --keep leaves its files in a folder. --sample takes that many of
them, evenly. --rounds repeats the rows with other places in the files. --sanitized: the programs are built with the
address sanitizer, which needs more memory and time. --self-test: broken programs must be noticed.
"""

import argparse
import json
import multiprocessing
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time
import xml.parsers.expat

import input_rows
import inputs
import programs

# What a call has written can be read again, by these.
AGAIN = {"run/messag": ["compare", "run", "run"], "fixed/deck.k": ["audit", "fixed/deck.k", "-I", "../in"]}
WRITES = {"-o", "--html", "--key", "--vtu", "--svg", "-key", "-medina", "-ani"}


def put(folder, files):
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data.encode() if isinstance(data, str) else data)


def clear(folder):
    """Folders stay: to remove one takes longer than the program that is tested."""
    for path, _, names in os.walk(folder):
        for name in names:
            os.unlink(os.path.join(path, name))


def state_of(folder):
    """All files with size, time and inode, and all folders."""
    found = {}
    for path, _, names in os.walk(folder):
        found[path] = ()
        for name in names:
            info = os.lstat(os.path.join(path, name))
            found[os.path.join(path, name)] = (info.st_mode, info.st_ino, info.st_size, info.st_mtime_ns)
    return found


def refuse(text):
    raise ValueError(f"{text} is not JSON")


def wrong_text(kind, data):
    """Why a text is not what it should be; empty: it is."""
    try:
        if kind == "json":
            json.loads(data, parse_constant=refuse)
        else:
            xml.parsers.expat.ParserCreate().Parse(data, True)
    except (ValueError, RecursionError, xml.parsers.expat.ExpatError) as error:
        return f"not well-formed: {error}: {data[:200]!r}"
    return ""


def findings(data):
    """Of an audit, without times and places, which another form of the file changes."""
    report = json.loads(data)
    for where in [report, *report["findings"], *report["contacts"]]:
        for name in ("input", "timing", "line", "file", "message"):
            where.pop(name, None)
    return report


def problems_of(one, ended, out):
    """What of docs/reliability.md does not hold."""
    found = []
    if ended.code not in (0, 1, 2):
        return [f"ended with {ended.how()}"]
    if ended.code == 2:
        # Long names are cut or broken in messages.
        if "error: " not in ended.text:
            found.append("exit 2 without an error on standard error")
        elif one.named and not any(name in ended.text for name in one.named):
            found.append(f"exit 2, and no message names {' or '.join(one.named[:3])}")
    for line in ended.text.splitlines():
        # An excerpt of the deck may be below a message, indented.
        if not line.startswith(("gapcheck: ", "check-c: ", "    ")):
            found.append(f"a line of standard error is not a message: {line[:200]}")
            break
    if re.search(rb"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]", ended.err):
        found.append("control characters on standard error")
    if "not enough memory" in ended.text or "std::" in ended.text:
        found.append("an error that no check has found")
    if "SIGXCPU" in ended.text:
        found.append("takes too long")
    kind = {"json": "json", "sarif": "json", "gitlab": "json", "junit": "xml"}.get(
        one.words[one.words.index("--format") + 1] if "--format" in one.words[:-1] else "")
    if kind and (ended.code != 2 or ended.out) and (wrong := wrong_text(kind, ended.out)):
        found.append(f"standard output is {wrong}")
    for path in sorted(out.rglob("*")):
        if path.suffix in (".vtu", ".pvd") or path.name == "vtu.out":
            if wrong := wrong_text("xml", path.read_bytes()):
                found.append(f"{path.name} is {wrong}")
        if path.name.startswith(".gapcheck-"):
            found.append("a file that is half written stays")
    written = [path.name for path in out.rglob("*") if path.is_file()]
    if written and not WRITES & set(one.words):
        found.append(f"writes {written[0]}, which nobody asked for")
    return found


class Checker:
    def __init__(self, options, sources):
        self.options, self.sources = options, sources
        self.limits = programs.Limits(memory=None, cpu=200) if options.sanitized else programs.Limits()
        self.program = {"gapcheck": str(options.gapcheck), "check-c": str(options.check_c)}

    def prepare(self, folder):
        """What stays the same for all inputs."""
        for name in ("in", "out", "good"):
            (folder / name).mkdir()
        put(folder / "good", {"good.k": self.sources.good, "messag": self.sources.log})
        put(folder / "good/run", self.sources.runs[0])

    def check(self, one, folder):
        """What is wrong, and what the program's end was."""
        place, out = folder / "in", folder / "out"
        for each in (place, out):
            clear(each)
        put(place, one.files())
        if one.group == "decks":
            for name, target in inputs.LINKS.items():
                os.symlink(target, place / name)
        good_deck = "../good/good.k"
        if "gapcheck.toml" in one.named:
            put(place, {"good.k": self.sources.good})
            good_deck = "../in/good.k"
        names = {"DECK": "../in/deck.k", "GOOD": good_deck, "LOG": "../good/messag", "FOLDER": "../in",
            "GOOD RUN": "../good/run"}
        words = [self.program[one.words[0]], *(names.get(word, word) for word in one.words[1:])]
        if "--jobs" not in words and len(words) > 2 and words[1] not in ("explain", "rules"):
            words += input_rows.JOBS
        before = state_of(folder)
        ended = programs.run(words, out, self.limits)
        after = state_of(folder)
        found = problems_of(one, ended, out)
        outside = {path for path in before.keys() | after.keys()
                   if before.get(path) != after.get(path) and not path.startswith(str(out))}
        for path, call in AGAIN.items():
            if ended.code in (0, 1) and (out / path).exists():
                again = programs.run([self.options.gapcheck, *call, *input_rows.JOBS], out, self.limits)
                if again.code not in (0, 1):
                    found.append(f"what it wrote cannot be read again: {again.text[:300]}")
        if one.answer == "refused" and ended.code != 2:
            found.append(f"{ended.how()} for a file that is no deck")
        if one.answer == "said" and not ended.err and b"*END" not in (place / "deck.k").read_bytes():
            found.append("nothing is said of what is missing")
        if one.answer == "same" and not found:
            put(place, {"deck.k": self.sources.decks[one.good]})
            good = programs.run(words, out, self.limits)
            if ended.code != good.code or (good.code != 2 and findings(ended.out) != findings(good.out)):
                found.append(f"the findings are not those of the good file ({ended.how()}, {good.how()})")
        if outside:
            found.append(f"changes {', '.join(sorted(outside)[:3])}")
        return found, ended, words


CHECKER, INPUTS, FOLDER = None, None, None  # of each process


def begin_process(parent):
    global FOLDER
    FOLDER = pathlib.Path(tempfile.mkdtemp(dir=parent))
    CHECKER.prepare(FOLDER)


def check_number(number):
    one = INPUTS[number]
    found, ended, words = CHECKER.check(one, FOLDER)
    if found and CHECKER.options.keep:
        shutil.rmtree(CHECKER.options.keep / str(number), ignore_errors=True)
        shutil.copytree(FOLDER, CHECKER.options.keep / str(number), symlinks=True)
    call = " ".join([pathlib.Path(words[0]).name, *(word[:60] for word in words[1:8])])
    return number, found, call, ended.code, ended.seconds, ended.megabytes, ended.text[:300]


# What a broken program does, and what must be said of it.
BROKEN = {"exit 3": "ended with exit 3", "kill -SEGV $$": "ended with SIGSEGV", "exit 2": "without an error",
          "echo 'gapcheck: error: no' >&2; exit 2": "no message names", "echo oops >&2": "is not a message",
          "printf 'gapcheck: \\033[31m\\n' >&2": "control characters", "echo > stray": "which nobody asked for",
          "echo >> ../in/deck.k": "changes", "echo > ../in/new": "changes", "echo '{\"depth\": NaN}'":
              "not well-formed",
          "echo '{'": "not well-formed", "echo > .gapcheck-1": "half written", "while :; do :; done":
              "ended with SIGXCPU",
          "exit 0": "for a file that is no deck", "echo '{}'": "nothing is said of what is missing",
          "mkdir -p run; echo > run/messag": "cannot be read again"}


def self_test(sources, folder):
    """Exit code."""
    CHECKER.limits = CHECKER.limits._replace(cpu=1)
    CHECKER.prepare(folder)
    rows = [one for one in input_rows.deck_inputs(sources, 1) if one.answer in ("refused", "said")]
    # One of each kind, as JSON, and a call of the solver.
    tried = [next(one for one in rows if one.answer == answer and one.words in (input_rows.DECK_CALLS[0],
        input_rows.DECK_CALLS[5]))
             for answer in ("refused", "said")]
    tried = [one._replace(words=words) for one in tried for words in (input_rows.DECK_CALLS[0],
        input_rows.DECK_CALLS[5])]
    missed = 0
    for script, wanted in BROKEN.items():
        real = dict(CHECKER.program)
        CHECKER.program["gapcheck"] = programs.broken(folder, script)
        found = [problem for one in tried for problem in CHECKER.check(one, folder)[0]]
        CHECKER.program = real
        if not any(wanted in problem for problem in found):
            print(f"a program that does {script!r} is not noticed: {found}")
            missed += 1
    print(f"{len(BROKEN)} broken programs, {missed} not noticed")
    return 1 if missed else 0


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("gapcheck", "check_c", "root"):
        parser.add_argument(name, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--sample", type=int)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--sanitized", action="store_true")
    parser.add_argument("--summary", type=pathlib.Path, help="write numbers by kind of input there, as JSON")
    parser.add_argument("--self-test", action="store_true")
    return parser.parse_args()


def check_all(options, folder):
    """Exit code."""
    global CHECKER, INPUTS
    begin = time.monotonic()
    sources = input_rows.Sources(options.root, options.gapcheck, folder)
    CHECKER = Checker(options, sources)
    if options.self_test:
        return self_test(sources, pathlib.Path(folder))
    INPUTS = [one for one in input_rows.all_inputs(sources, options.rounds) if options.only in one.name]
    numbers = list(range(len(INPUTS)))
    if options.sample and options.sample < len(numbers):
        numbers = numbers[::len(numbers) // options.sample][:options.sample]
    groups, slowest, largest, bad = {}, (0, ""), (0, ""), 0
    with multiprocessing.Pool(2, begin_process, [folder]) as pool:
        for number, found, call, code, seconds, megabytes, text in pool.imap_unordered(check_number, numbers, 8):
            one = INPUTS[number]
            group = groups.setdefault(one.group, {"exit 0": 0, "exit 1": 0, "exit 2": 0})
            group[f"exit {code}"] = group.get(f"exit {code}", 0) + 1
            slowest = max(slowest, (seconds, one.name))
            largest = max(largest, (megabytes, one.name))
            bad += bool(found)
            for problem in found:
                print(f"[{number}] {one.name}\n    {call}\n    {problem}\n    {text!r}", flush=True)
    spent = time.monotonic() - begin
    for name, group in groups.items():
        print(f"{name}: {sum(group.values())} (" + ", ".join(f"{count} {end}" for end, count in group.items()) + ")")
    print(f"slowest: {slowest[0]:.1f} s, {slowest[1]}; largest: {largest[0]:.0f} MB, {largest[1]}")
    print(f"{len(numbers)} hostile inputs, {spent:.1f} s, {bad} answered wrongly")
    if options.summary:
        options.summary.write_text(json.dumps({"groups": groups, "processor": programs.processor_seconds(), "bad": bad, "slowest": slowest,
                                               "largest": largest}))
    if not options.sample and not options.only and len(numbers) < 1000:
        print("fewer than 1000 inputs: has the table lost rows?")
        return 1
    return 1 if bad else 0


def main():
    options = parse_arguments()
    for program in (options.gapcheck, options.check_c):
        if not program.exists():
            print(f"{program} is not built")
            return 77  # skipped
    if options.sanitized:
        # Otherwise what a sanitizer finds would be exit code 1.
        os.environ |= {"ASAN_OPTIONS": "detect_leaks=1:exitcode=99", "UBSAN_OPTIONS": "print_stacktrace=1:exitcode=99"}
    with tempfile.TemporaryDirectory(prefix="gapcheck_hostile_") as folder:
        return check_all(options, folder)


if __name__ == "__main__":
    sys.exit(main())
