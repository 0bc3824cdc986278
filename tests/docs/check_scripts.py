#!/usr/bin/env python3
"""Checks that the scripts that write pages and pictures of docs/ still work.

    check_scripts.py ROOT BUILD GAPCHECK [TEST_SOLVER]

Runs each on its smallest case, in a temporary copy of what it reads and writes. Scripts whose programs BUILD does not
have, or that need more than the build, are loaded and asked for their --help only; the output says which. Exit code 1 if
one fails, writes nothing or is missing in the lists below.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

COPIED = ["data", "docs", "scripts", "tests/apps", "tests/bench", "tests/fuzz", "tests/solver"]
LIMIT = 120  # seconds; on an idle machine none takes more than 20

# Script, arguments, what it writes (None: it prints). {NAME}: a path of the command line.
RUNS = [
    ("scripts/count_findings.py", "{gapcheck} data --small", "docs/real-decks.md"),
    ("scripts/draw_findings.py", "{gapcheck} data --small", None),
    ("scripts/fuzz.py", "{build} search --seconds 1", "docs/reliability.md"),
    ("scripts/impact_energy.py", "{test_solver} --small", "docs/theory/impact-energy.md"),
    ("scripts/long_runs.py", "{gapcheck} --small", "docs/theory/long-runs.md"),
    ("scripts/pictures/fix_scenes.py", "{gapcheck} --small", "docs/pictures/fix_crossed_30.png"),
    ("scripts/pictures/terminal.py", "{gapcheck}", "docs/pictures/terminal.svg"),
    ("scripts/plot_workshop.py", "{gapcheck} --small", "docs/workshop/rebound_thickness.svg"),
    ("scripts/reliability.py", "{gapcheck} --small", "docs/reliability.md"),
    ("scripts/solver_accuracy.py", "{test_solver} --small", "docs/theory/solver-accuracy.md"),
    ("scripts/solver_benchmarks.py", "{gapcheck} --small", "docs/theory/solver-benchmarks.md"),
    ("scripts/solver_runs.py", "{gapcheck} data/workshop --small", "docs/solver-runs.md"),
    ("scripts/solver_table.py", "{test_solver} --small", "docs/theory/solver-table.md"),
    ("scripts/state_energy.py", "{gapcheck} --small", "docs/theory/state-energy.md"),
    ("scripts/tie_accuracy.py", "{test_solver} --small", "docs/theory/solver-ties.md"),
    ("tests/bench/decisions.py", "{build} work docs/decision-speed.md --rounds 1 --count 50", "docs/decision-speed.md"),
    ("tests/bench/fix_tables.py", "{gapcheck} --small", "docs/fix.md"),
    ("tests/bench/measure.py", "{build} work docs/benchmarks.md --runs 1 --sizes 10 --messag 100 --only timings,rules,messag",
     "docs/benchmarks.md"),
    ("tests/bench/measure_reading.py", "{build} docs/benchmarks.md --rows 1000 --runs 1", "docs/benchmarks.md"),
    ("tests/bench/measure_scale.py", "{build} work docs/benchmarks.md --shells 1000 --runs 1 --kinds plates",
     "docs/benchmarks.md"),
    ("tests/bench/measure_search.py", "{build} docs/benchmarks.md --shells 500 --rounds 1", "docs/benchmarks.md"),
    ("tests/bench/python_speed.py", "{build} work docs/python.md --plates 5 --runs 1", "docs/python.md"),
    ("tests/bench/skipped_work.py", "--program {gapcheck}", "docs/skipped-work.md"),
    ("tests/bench/solver_precision.py", "{build}/tests/bench/gapcheck_solver_precision", "docs/theory/solver-precision.svg"),
]
# Programs of {build} that a run needs.
NEEDS = {
    "tests/bench/decisions.py": ["gapcheck_make_plates", "gapcheck_decide_bench"],
    "tests/bench/measure.py": ["gapcheck_make_plates", "gapcheck_make_messag"],
    "tests/bench/measure_reading.py": ["gapcheck_reading_bench"],
    "tests/bench/measure_scale.py": ["gapcheck_make_scene"],
    "tests/bench/measure_search.py": ["gapcheck_search_bench"],
    "tests/bench/python_speed.py": ["gapcheck_make_plates"],
    "tests/bench/solver_precision.py": ["gapcheck_solver_precision"],
}
# What more than the build is needed for.
LOADED_ONLY = {
    "scripts/build_time.py": "builds the programs from nothing",
    "scripts/fresh_debian.py": "needs root, debootstrap and the network",
    "scripts/make_site.py": "needs Sphinx and Doxygen, and takes minutes",
    "scripts/slurm_campaign.py": "needs root, Slurm and munge",
    "scripts/check_machines.py": "needs the programs of scripts/machines.py, root and emulators",
    "scripts/judge_findings.py": "needs decks that are not part of the project",
    "scripts/pictures/html_page.py": "needs Chromium",
    "tests/bench/html_page.py": "needs Chromium",
    "tests/bench/peers/measure_peers.py": "needs the libraries that it compares with",
    "tests/bench/work_precision/work_precision.py": "builds a program of its own",
}
# These write no page of docs/.
OTHERS = {"scripts/fuzz_programs.py", "scripts/make_fix_scenes.py", "scripts/make_tutorial.py", "scripts/make_workshop.py", "scripts/mutate.py",
          "scripts/pictures/paraview_grid.py"}
LOAD = "import runpy, sys; sys.path.insert(0, sys.argv[2]); runpy.run_path(sys.argv[1], run_name='loaded')"


def writers(root):
    """Scripts that write something and name docs/."""
    found = set()
    for folder in ("scripts", "tests/bench"):
        for path in (root / folder).rglob("*.py"):
            text = path.read_text(encoding="utf-8")
            if re.search(r"\.write_(text|bytes)\(|SaveScreenshot\(", text) and re.search(r"\bdocs\b", text):
                found.add(str(path.relative_to(root)))
    return found


def call(command, root):
    """What went wrong; empty: nothing."""
    try:
        done = subprocess.run([sys.executable, "-B", *map(str, command)], cwd=root, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return f"takes more than {LIMIT} s"
    return "" if done.returncode == 0 else f"exit {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}"


def run(script, arguments, page, root):
    if page is None:
        return call([script, *arguments], root)
    target = root / page
    before = target.stat().st_mtime_ns if target.exists() else None
    problem = call([script, *arguments], root)
    if not problem and (not target.exists() or target.stat().st_mtime_ns == before):
        problem = f"has not written {page}"
    return problem


def load(script, root):
    path = root / script
    problem = call(["-c", LOAD, path, path.parent], root)
    if not problem and "argparse.ArgumentParser" in path.read_text(encoding="utf-8"):
        problem = call([script, "--help"], root)
    return problem


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("root", "build", "gapcheck"):
        parser.add_argument(name, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("test_solver", type=lambda text: pathlib.Path(text).resolve(), nargs="?")
    arguments = parser.parse_args()
    listed = {script for script, _, _ in RUNS} | set(LOADED_ONLY) | OTHERS
    problems = [f"{script}: writes into docs/ and is not in the lists of this test"
                for script in sorted(writers(arguments.root) - listed)]
    problems += [f"{script}: is listed here and does not exist"
                 for script in sorted(listed) if not (arguments.root / script).exists()]
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in COPIED:
            shutil.copytree(arguments.root / name, root / name)
        loaded = dict(LOADED_ONLY)
        for script, words, page in RUNS:
            missing = [name for name in NEEDS.get(script, []) if not (arguments.build / "tests/bench" / name).exists()]
            if "{test_solver}" in words and arguments.test_solver is None:
                missing.append("gapcheck_test_solver")
            if missing:
                loaded[script] = f"not built: {', '.join(missing)}"
                continue
            start = time.monotonic()
            problem = run(script, [word.format(**vars(arguments)) for word in words.split()], page, root)
            print(f"{script}: {'fails' if problem else 'run'} ({time.monotonic() - start:.1f} s)", flush=True)
            problems += [f"{script}: {problem}"] if problem else []
        for script, why in sorted(loaded.items()):
            problem = load(script, root)
            print(f"{script}: {'cannot be loaded' if problem else 'loaded only'} ({why})", flush=True)
            problems += [f"{script}: {problem}"] if problem else []
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
