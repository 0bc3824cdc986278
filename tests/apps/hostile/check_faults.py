#!/usr/bin/env python3
"""Injects the faults of faults.py and holds what is left against docs/reliability.md.

    check_faults.py GAPCHECK CHECK_C ROOT [--sample N] [--only TEXT] [--self-test]

Each fault is a row with a name, by which --only finds it again. --sample takes that many rows, evenly. --sanitized: the
programs are built with the address sanitizer; limits of memory are left out. --self-test: broken programs must be
noticed in every group.
"""

import argparse
import json
import multiprocessing
import os
import pathlib
import stat
import sys
import tempfile
import time

import fault_rows
import faults
import programs

BENCH, ROWS = None, None  # of each process


def begin_process(options, parent):
    global BENCH
    folder = pathlib.Path(tempfile.mkdtemp(dir=parent))
    os.chmod(folder, stat.S_IRWXU | stat.S_IRWXG | stat.S_IRWXO)
    BENCH = fault_rows.Bench(options, folder)


def check_row(number):
    _, _, function, values = ROWS[number]
    try:
        found = function(BENCH, *values)
        return number, found, programs.LAST.how() if programs.LAST else ""
    except OSError as error:
        return number, [f"the test itself fails: {error}"], ""


# What a broken program does, and the groups in which it cannot be noticed.
BROKEN = {"kill -ABRT $$": [],
          # Does nothing and says that all is well.
          "exit 0": ["memory in MB", "threads", "descriptors", "inputs that change", "folders that vanish"],
          # Leaves a file that is half written.
          "echo > .gapcheck-1; sleep 0.3; echo 'gapcheck: error: no' >&2; exit 2": ["threads"],
          # Writes over everything at once, and says so.
          "trap '' TERM; for f in F page fixed/p.k check-c.key; do echo > $f; done\n"
          "echo 'error: File too large p.k long' >&2; exit 2": [
              "threads", "memory in MB", "descriptors", "standard output", "inputs", "outputs", "folders that vanish"]}


def self_test(options, folder):
    """Exit code. One row of each group, with each broken program."""
    rows, missed = {}, 0
    for group, name, function, values in fault_rows.all_rows(False):
        rows.setdefault(group, []).append((name, function, values))
    # The shell needs a moment, and some descriptors.
    rows = {group: of_group[{"signals": 2, "descriptors": -1}.get(group, 0)] for group, of_group in rows.items()}
    for script, unnoticed in BROKEN.items():
        options.gapcheck = options.check_c = pathlib.Path(programs.broken(folder, script))
        for group, (name, function, values) in rows.items():
            if group in unnoticed or (group == "threads" and os.geteuid() != 0):
                continue
            bench = fault_rows.Bench(options, pathlib.Path(tempfile.mkdtemp(dir=folder)))
            # Sizes of what it writes come from the program that is not broken.
            bench.sizes = dict.fromkeys(["G audit p.k --output F"], 100) | {
                " ".join(["G", *words]): dict.fromkeys(words, b"new") for words in faults.INTERRUPTED.values()}
            bench.durations = dict.fromkeys([" ".join(["G", *words]) for words in faults.INTERRUPTED.values()], 0.1)
            try:
                found = function(bench, *values)
            except OSError as error:
                found = [str(error)]
            if not found:
                print(f"{name}: a program that does {script!r} is not noticed")
                missed += 1
    print(f"{len(BROKEN)} broken programs in {len(rows)} groups, {missed} not noticed")
    return 1 if missed else 0


def check_all(options, folder):
    """Exit code."""
    global ROWS
    begin = time.monotonic()
    ROWS = [row for row in fault_rows.all_rows(options.sanitized) if options.only in row[1]]
    numbers = list(range(len(ROWS)))
    if options.sample and options.sample < len(numbers):
        numbers = numbers[::len(numbers) // options.sample][:options.sample]
    groups, bad, met = {}, 0, dict.fromkeys(faults.LEAST, 0)
    with multiprocessing.Pool(2, begin_process, [options, folder]) as pool:
        for number, found, how in pool.imap_unordered(check_row, numbers, 4):
            group, name, _, _ = ROWS[number]
            ends = groups.setdefault(group, {})
            ends[how] = ends.get(how, 0) + 1
            bad += bool(found)
            for begin_of_name in met:
                met[begin_of_name] += name.startswith(begin_of_name) and how not in ("exit 0", "exit 1")
            for problem in found:
                print(f"{name}\n    {problem}", flush=True)
    spent = time.monotonic() - begin
    for name, ends in groups.items():
        print(f"{name}: {sum(ends.values())} (" + ", ".join(f"{count} {how}" for how, count in sorted(ends.items()))
            + ")")
    print(f"{len(numbers)} faults, {spent:.1f} s, {bad} with a wrong end")
    if options.summary:
        options.summary.write_text(json.dumps({"groups": groups, "processor": programs.processor_seconds(), "bad": bad}))
    if not options.sample and not options.only:
        rare = [f"{name}: the fault came only {count} times at the right moment" for name, count in met.items()
                if count < faults.LEAST[name]]
        rare += ["fewer than 200 faults: has the table lost rows?"] if len(numbers) < 200 else []
        for one in rare:
            print(one)
        bad += len(rare)
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("gapcheck", "check_c", "root"):
        parser.add_argument(name, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--sample", type=int)
    parser.add_argument("--only", default="")
    parser.add_argument("--sanitized", action="store_true")
    parser.add_argument("--summary", type=pathlib.Path, help="write numbers by kind of fault there, as JSON")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    for program in (options.gapcheck, options.check_c):
        if not program.exists():
            print(f"{program} is not built")
            return 77  # skipped
    if options.sanitized:
        # Otherwise what a sanitizer finds would be exit code 1.
        os.environ |= {"ASAN_OPTIONS": "detect_leaks=1:exitcode=99", "UBSAN_OPTIONS": "print_stacktrace=1:exitcode=99"}
    with tempfile.TemporaryDirectory(prefix="gapcheck_faults_") as folder:
        os.chmod(folder, 0o755)
        return self_test(options, folder) if options.self_test else check_all(options, folder)


if __name__ == "__main__":
    sys.exit(main())
