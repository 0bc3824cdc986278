#!/usr/bin/env python3
"""Times gapcheck and check-c as processes, the single stages and the solver, and rewrites the tables of
docs/benchmarks.md.

usage: measure.py BUILD_FOLDER WORK_FOLDER DOC [--runs N] [--sizes 100,300,700] [--messag BLOCKS]
                  [--only timings,rules,pages,stages,messag,solver] [--plates 100]
"""

import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess

from page import machine, measure, run_once, section


def table(arguments):
    rows = ["| shells | deck | stray shell | threads | min | median | peak memory |",
            "|---|---|---|---|---|---|---|"]
    for n in arguments.sizes:
        for stray in (False, True):
            deck = arguments.work / f"plates_{n}{'_stray' if stray else ''}.k"
            subprocess.run([arguments.make_plates, str(n), deck] + (["--stray"] if stray else []), check=True)
            for jobs in (1, os.cpu_count()):
                command = [str(arguments.gapcheck), "audit", "--fail-on", "never", "--jobs", str(jobs), str(deck)]
                low, median, memory = measure(command, arguments.runs)
                size = deck.stat().st_size / 1e6
                rows.append(f"| {2 * n * n + stray:,} | {size:.1f} MB | {'yes' if stray else 'no'} | {jobs} "
                            f"| {low:.3f} s | {median:.3f} s | {memory:,.0f} MB |")
                print(rows[-1], flush=True)
            deck.unlink()
    return rows


def pairs(arguments, names, commands):
    """Two kinds of audits of the largest deck, in pairs of runs that follow each other. `commands`: of one audit, both."""
    n = max(arguments.sizes)
    deck = arguments.work / f"plates_{n}.k"
    subprocess.run([arguments.make_plates, str(n), deck], check=True)
    rows = [f"| shells | threads | {names[0]}, median | {names[1]}, median | ratio, median of pairs |", "|---|---|---|---|---|"]
    for jobs in (1, os.cpu_count()):
        first, second = commands([str(arguments.gapcheck), "audit", "--fail-on", "never", "--jobs", str(jobs), str(deck)])
        for command in (first, second):
            run_once(command)  # warms the file cache
        times = [(run_once(first)[0], run_once(second)[0]) for _ in range(arguments.runs)]
        rows.append(f"| {2 * n * n:,} | {jobs} | {statistics.median(a for a, _ in times):.3f} s "
                    f"| {statistics.median(b for _, b in times):.3f} s "
                    f"| {statistics.median(b / a for a, b in times):.2f} |")
        print(rows[-1], flush=True)
    deck.unlink()
    return rows


def rules(arguments):
    """All rules beside GC101 alone."""
    return pairs(arguments, ("GC101 alone", "all rules"), lambda audit: ([*audit, "--select", "GC101"], audit))


def pages(arguments):
    """Large and small pages: a process with a limit of its addresses, however high, does not ask for large ones."""
    return pairs(arguments, ("small pages", "large pages"), lambda audit: (["prlimit", f"--as={2**45}", *audit], audit))


def stages(arguments):
    """One row per benchmark of gapcheck_bench, which checks each stage's result before it times it."""
    out = subprocess.run([arguments.bench, "--benchmark_format=json", "--benchmark_repetitions=3",
                          "--benchmark_report_aggregates_only=true"], check=True, capture_output=True, text=True).stdout
    rows = ["| stage / N | median | per shell |", "|---|---|---|"]
    for run in json.loads(out)["benchmarks"]:
        if run.get("aggregate_name") != "median":
            continue
        seconds = run["real_time"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[run["time_unit"]]
        name = run["run_name"].replace("/real_time", "")
        shells = 2 * int(name.split("/")[1]) ** 2 if "/" in name else 0
        rows.append(f"| {name} | {seconds * 1e3:.2f} ms | {seconds / shells * 1e9:.0f} ns |" if shells else
                    f"| {name} | {seconds * 1e3:.2f} ms | |")
        print(rows[-1], flush=True)
    return rows


def messag(arguments):
    """check-c on a generated messag, beside grep on the same file in the same run."""
    path = arguments.work / "big.messag"
    subprocess.run([arguments.make_messag, path, str(arguments.messag)], check=True)
    size = path.stat().st_size / 1e6
    rows = [f"A messag of {size:,.0f} MB with {arguments.messag:,} blocks of warning 40565:", "",
            "| command | min | median | MB/s | peak memory |", "|---|---|---|---|---|"]
    medians = []
    for name, command in (("check-c", [str(arguments.check_c), str(path)]), ("grep -c 40565", ["grep", "-c", "40565", str(path)])):
        low, median, memory = measure(command, min(arguments.runs, 3))
        medians.append(median)
        rows.append(f"| {name} | {low:.3f} s | {median:.3f} s | {size / median:,.0f} | {memory:,.0f} MB |")
        print(rows[-1], flush=True)
    path.unlink()
    return rows + ["", f"check-c / grep: {medians[0] / medians[1]:.1f}."]


def speeds(arguments, n, cycles, jobs, far):
    """One run of gapcheck_solver_speed: the figures of elements alone and of contact."""
    out = subprocess.run([arguments.solver_speed, str(n), str(cycles), str(jobs), str(far)], check=True,
                         capture_output=True, text=True).stdout
    line = re.compile(r"(\d+) shells, [a-z ]+: ([\d.]+) million .* contact ([\d.]+) % .* (\d+) nodes and (\d+) pairs")
    found = [[float(value) for value in match.groups()] for match in line.finditer(out)]
    if len(found) != 2:
        raise SystemExit(f"gapcheck_solver_speed {n} {cycles} {jobs} {far}: not understood: {out}")
    return found


def bricks(arguments, n, cycles):
    """A sentence: brick cycles per second of a block of n x n x n bricks, without contact."""
    rates = []
    for jobs in (1, os.cpu_count()):
        found = []
        for _ in range(arguments.runs):
            out = subprocess.run([arguments.solver_speed, "bricks", str(n), str(cycles), str(jobs)], check=True,
                                 capture_output=True, text=True).stdout
            found.append(float(re.search(r"bricks: ([\d.]+) million", out).group(1)))
        rates.append(statistics.median(found))
    return (f"A block of {n ** 3:,} bricks with one point, without contact: {rates[0]:.2f} million brick cycles per second "
            f"with one thread, {rates[1]:.2f} million with {os.cpu_count()}.")


def solver(arguments):
    """Shell cycles per second; the cases in turn, so that all of them see the same machine."""
    n = arguments.plates
    many = os.cpu_count()
    cases = [(300, 1, 0), (300, many, 0), (100, many, 10 * n)]
    samples = [[] for _ in cases]
    for run in range(arguments.runs):
        for case, sample in zip(cases, samples):
            if case[2] == 0 or run < 2:  # many shells take their time
                sample.append(speeds(arguments, n, *case))
    rows = ["| shells | of them far away | threads | elements alone | with contact | share of contact "
            "| contact per cycle | nodes per cycle | pairs per cycle |", "|---|---|---|---|---|---|---|---|---|"]
    for (_, jobs, far), sample in zip(cases, samples):
        def median(row, column):
            return statistics.median(run[row][column] for run in sample)
        shells = median(1, 0)
        per_cycle = statistics.median(run[1][2] / 100 * run[1][0] / (run[1][1] * 1e6) for run in sample)
        rows.append(f"| {shells:,.0f} | {n * far:,} | {jobs} "
                    f"| {median(0, 1):.2f} million/s | {median(1, 1):.2f} million/s | {median(1, 2):.0f} % "
                    f"| {per_cycle * 1e3:.2f} ms | {median(1, 3):,.0f} | {median(1, 4):,.0f} |")
        print(rows[-1], flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "work", "doc"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--sizes", type=lambda text: [int(n) for n in text.split(",")], default=[100, 300, 700])
    parser.add_argument("--messag", type=int, default=1000000, help="blocks in the messag")
    parser.add_argument("--plates", type=int, default=100, help="shells along an edge of the solver's plates")
    parser.add_argument("--only", type=lambda text: text.split(","), default=["timings", "rules", "pages", "stages", "messag", "solver"],
                        help="tables to measure")
    arguments = parser.parse_args()
    arguments.gapcheck = arguments.build / "apps/gapcheck/gapcheck"
    arguments.check_c = arguments.build / "apps/check-c/check-c"
    arguments.make_plates = arguments.build / "tests/bench/gapcheck_make_plates"
    arguments.make_messag = arguments.build / "tests/bench/gapcheck_make_messag"
    arguments.solver_speed = arguments.build / "tests/bench/gapcheck_solver_speed"
    arguments.bench = arguments.build / "tests/bench/gapcheck_bench"
    arguments.work.mkdir(parents=True, exist_ok=True)
    text = arguments.doc.read_text(encoding="utf-8")
    caption = machine() + f"; {arguments.runs} runs each after one to warm the file cache."
    tables = {"timings": lambda: [caption, "", *table(arguments)], "rules": lambda: rules(arguments),
              "pages": lambda: pages(arguments),
              "stages": lambda: stages(arguments), "messag": lambda: messag(arguments),
              "solver": lambda: [machine() + f"; medians of {arguments.runs} runs, the cases in turn.", "",
                                 *solver(arguments), "", bricks(arguments, 30, 100)]}
    for name in arguments.only:
        text = section(name, text, "\n".join(tables[name]()))
    arguments.doc.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
