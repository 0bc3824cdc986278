#!/usr/bin/env python3
"""Times `gapcheck audit` as a process on the plate decks and rewrites the table of docs/benchmarks.md.

usage: measure.py GAPCHECK MAKE_PLATES WORK_FOLDER DOC [--runs N] [--sizes 100,300,700]
"""

import argparse
import os
import pathlib
import platform
import statistics
import subprocess
import time

BEGIN, END = "<!-- timings: begin -->", "<!-- timings: end -->"


def run_once(command):
    """Wall time in seconds, peak resident memory in MB and the exit status of one run."""
    start = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return time.perf_counter() - start, usage.ru_maxrss / 1024, process.returncode


def measure(command, runs):
    run_once(command)  # warms the file cache
    samples = [run_once(command) for _ in range(runs)]
    # Exit 1: findings at or above the limit. Anything else but 0 is a failure, not a time.
    bad = [status for _, _, status in samples if status not in (0, 1)]
    if bad:
        raise SystemExit(f"{' '.join(command)}: exit {bad[0]}")
    times = [wall for wall, _, _ in samples]
    return min(times), statistics.median(times), max(rss for _, rss, _ in samples)


def machine():
    model = platform.processor() or "unknown processor"
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    return f"{model}, {os.cpu_count()} processors, {platform.system()} {platform.release().split('-')[0]}"


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


def main():
    parser = argparse.ArgumentParser()
    for name in ("gapcheck", "make_plates", "work", "doc"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--sizes", type=lambda text: [int(n) for n in text.split(",")], default=[100, 300, 700])
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    text = arguments.doc.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    caption = machine() + f"; {arguments.runs} runs each after one to warm the file cache."
    body = "\n".join([caption, "", *table(arguments)])
    arguments.doc.write_text(f"{before}{BEGIN}\n{body}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
