#!/usr/bin/env python3
"""The guard against slowness: builds an older commit and the present state of the working tree, runs both in turn and
prints the ratio of their times, stage by stage. What seems slower is measured once more. Exit 0: no stage is slower by
more than the limit in the median; 1: one is, both times; 2: it could not be measured, or the two find different things.

usage: compare.py [COMMIT] [--rounds 11] [--limit 1.10] [--results-may-differ]
       compare.py --builds OLD_FOLDER NEW_FOLDER       (two build folders that exist, with GAPCHECK_BENCH)

COMMIT is the last one if the working tree has changes, else the one before it. Everything runs on one processor, and
what is judged is processor time, so other programs disturb little; a quiet machine is still better.
"""

import argparse
import json
import os
import pathlib
import re
import resource
import shutil
import statistics
import subprocess
import sys

from scenes import plates, wavy_sheets

ROOT = pathlib.Path(__file__).resolve().parents[3]
WORK = ROOT / "build" / "compare"
STAGES = "^(read|model|surfaces|search_grid|decide|audit)/(100|300)(/|$)"


def git(*arguments, **options):
    return subprocess.run(["git", "-C", ROOT, *arguments], check=True, capture_output=True, **options).stdout


def previous():
    changed = git("status", "--porcelain", text=True).strip() != ""
    return "HEAD" if changed else "HEAD~1"


def unpack(commit):
    """The files of a commit, once."""
    sha = git("rev-parse", "--verify", f"{commit}^{{commit}}", text=True).strip()
    folder = WORK / sha
    if not (folder / "main").exists():
        (folder / "part").mkdir(parents=True, exist_ok=True)
        subprocess.run(["tar", "-x", "-C", folder / "part"], input=git("archive", sha), check=True)
        (folder / "part").rename(folder / "main")
    return folder


def copy_present():
    """The files of the working tree, as they are now; what has not changed keeps its time, so little is rebuilt."""
    folder = WORK / "present"
    names = set(git("ls-files", "-z", "--cached", "--others", "--exclude-standard", text=True).split("\0")) - {""}
    names = {name for name in names if (ROOT / name).is_file()}
    for name in names:
        source, target = ROOT / name, folder / "main" / name
        if target.exists() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)
    for path in [p for p in (folder / "main").rglob("*") if p.is_file()]:
        if str(path.relative_to(folder / "main")) not in names:
            path.unlink()
    return folder


def build(folder):
    """Both states lie alike, beside their build folders, so that a compiler cache serves one with the other's files."""
    environment = dict(os.environ, CCACHE_BASEDIR=str(folder), CCACHE_NOHASHDIR="1")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    commands = (["cmake", "-S", folder / "main", "-B", folder / "build", "-DCMAKE_BUILD_TYPE=Release",
                 "-DGAPCHECK_BENCH=ON", "-DGAPCHECK_TESTS=OFF", *generator],
                ["cmake", "--build", folder / "build", "--target", "gapcheck", "gapcheck_bench"])
    for command in commands:
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            stop(f"{' '.join(map(str, command))}:\n{done.stdout[-3000:]}")
    return folder / "build"


def stop(message):
    print(message, file=sys.stderr)
    raise SystemExit(2)


def audit(folder, deck, *options):
    """Standard output and processor seconds of an audit."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([folder / "apps/gapcheck/gapcheck", "audit", "--fail-on", "never", "--jobs", "1", *options, deck],
                          capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        stop(f"{folder}: audit of {deck.name}: exit {done.returncode}\n{done.stderr[-3000:]}")
    seconds = (after.ru_utime - before.ru_utime) + (after.ru_stime - before.ru_stime)
    return done.stdout, seconds


def audit_times(folder, deck):
    """By name: the whole process in processor time (judged), its stages by the clock (shown)."""
    text, seconds = audit(folder, deck, "--stats", "--top", "0")
    times = {f"{deck.stem}: whole audit": (seconds, True)}
    for name, value in re.findall(r"^ *time: (\w+) +([\d.]+) s", text, re.MULTILINE):
        if name != "total":
            times[f"{deck.stem}: {name}, by the clock"] = (float(value), False)
    return times


def stage_times(folder):
    out = subprocess.run([folder / "tests/bench/gapcheck_bench", f"--benchmark_filter={STAGES}",
                          "--benchmark_min_time=0.1", "--benchmark_format=json"], capture_output=True, text=True)
    try:
        runs = json.loads(out.stdout)["benchmarks"]
    except (json.JSONDecodeError, KeyError):
        stop(f"{folder}: gapcheck_bench is not understood: {out.stdout[:500]} {out.stderr[-500:]}")
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
    for run in runs:
        if run.get("error_occurred"):
            stop(f"{folder}: {run['name']}: {run.get('error_message')}")
    return {"plates: " + run["name"].replace("/real_time", ""): (run["cpu_time"] * unit[run["time_unit"]], True)
            for run in runs}


def same_results(old, new, decks, may_differ):
    for deck in decks:
        one, other = (re.sub(r'"timing":\{[^}]*\}', "", audit(folder, deck, "--format", "json")[0])
                      for folder in (old, new))
        if one == other:
            continue
        print(f"{deck.name}: the two find different things")
        if not may_differ:
            raise SystemExit(2)


def quartiles(values):
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive")
    return middle, low, high


def compare(old, new, decks, rounds):
    """Samples by stage: (old seconds, new seconds, judged)."""
    samples = {}
    for number in range(-1, rounds):  # the first one warms the file cache
        times = []
        for folder in (old, new) if number % 2 == 0 else (new, old):
            found = stage_times(folder)
            for deck in decks:
                found.update(audit_times(folder, deck))
            times.append(found)
        one, other = times if number % 2 == 0 else reversed(times)
        if number < 0:
            continue
        for name in one.keys() & other.keys():
            samples.setdefault(name, []).append((one[name][0], other[name][0], one[name][1]))
        print(f"round {number + 1} of {rounds}", file=sys.stderr, flush=True)
    return samples


def judge(samples, limit, rounds):
    slow = []
    print(f"\n{'stage':42} {'old':>10} {'new':>10}   new / old, median (quartiles)")
    for name, sample in sorted(samples.items()):
        if len(sample) < rounds or min(a for a, _, _ in sample) <= 0:
            continue  # too short for the clock
        ratio, low, high = quartiles([b / a for a, b, _ in sample])
        judged = sample[0][2]
        mark = "  SLOWER" if judged and ratio > limit else "" if judged else "  (not judged)"
        print(f"{name:42} {statistics.median(a for a, _, _ in sample) * 1e3:7.2f} ms "
              f"{statistics.median(b for _, b, _ in sample) * 1e3:7.2f} ms   {ratio:.3f} ({low:.3f} … {high:.3f}){mark}")
        if mark == "  SLOWER":
            slow.append(name)
    return slow


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit", nargs="?", help="what to compare with")
    parser.add_argument("--builds", nargs=2, type=pathlib.Path, metavar=("OLD", "NEW"))
    parser.add_argument("--rounds", type=int, default=11)
    parser.add_argument("--limit", type=float, default=1.10, help="largest ratio of times, new to old")
    parser.add_argument("--results-may-differ", action="store_true")
    arguments = parser.parse_args()
    if arguments.rounds < 2:
        stop("at least 2 rounds")
    WORK.mkdir(parents=True, exist_ok=True)
    if arguments.builds:
        old, new = arguments.builds
    else:
        commit = arguments.commit or previous()
        print(f"building {commit} and the present state …", file=sys.stderr, flush=True)
        old, new = build(unpack(commit)), build(copy_present())
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})  # programs started from here have one thread
    decks = [plates(WORK / "plates.k", 200), wavy_sheets(WORK / "wavy_sheets.k", 150)]
    same_results(old, new, decks, arguments.results_may_differ)
    slow = judge(compare(old, new, decks, arguments.rounds), arguments.limit, arguments.rounds)
    if slow:
        print("\nAgain, to tell what is slower from what was disturbed:")
        again = judge(compare(old, new, decks, arguments.rounds), arguments.limit, arguments.rounds)
        slow = [name for name in slow if name in again]
    print(f"\nslower than {arguments.limit:.2f} times: {', '.join(slow)}" if slow else
          f"\nno stage is slower than {arguments.limit:.2f} times")
    return 1 if slow else 0


if __name__ == "__main__":
    sys.exit(main())
