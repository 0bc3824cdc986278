#!/usr/bin/env python3
"""Audits generated decks of rising size and rewrites a table in docs/benchmarks.md.

usage: measure_scale.py BUILD_FOLDER WORK_FOLDER DOC [--shells 100000,1000000,10000000] [--runs N] [--kinds KIND,…]
                        [--table scale]

The largest decks take about a gigabyte each in WORK_FOLDER; every deck is deleted after its runs.
"""

import argparse
import math
import os
import pathlib
import re
import statistics
import subprocess
import time

from page import machine, run_once, section


def own_memory(command):
    """Largest anonymous resident memory in MB of one run, looked at every 10 ms."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    most = 0
    while process.poll() is None:
        try:
            status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
        except OSError:
            break
        found = re.search(r"RssAnon:\s+(\d+)", status)
        most = max(most, int(found.group(1)) if found else 0)
        time.sleep(0.01)
    process.wait()
    return most / 1024


def audit(arguments, deck, fewest, most):
    """Median seconds and peak memory of its own in MB of the audits of one deck, once its findings have been checked."""
    command = [str(arguments.gapcheck), "audit", "--fail-on", "never", "--top", "0", str(deck)]
    report = subprocess.run([*command, "--stats"], check=True, capture_output=True, text=True).stdout
    # "… 17 penetrations, deepest …" for each contact; nodes in edge zones are counted beside them.
    found = sum(int(n) for n in re.findall(r"segments: (\d+) penetration", report))
    # Beyond a million the shallowest are only counted.
    found += sum(int(all_) - int(listed) for all_, listed in re.findall(r"of its (\d+) penetrations the (\d+) deepest", report))
    zones = sum(int(n) for n in re.findall(r"(\d+) nodes? in (?:an |the )?edge zone", report))
    if not fewest <= found + zones or not found <= most:
        raise SystemExit(f"{deck}: {found} penetrations and {zones} in edge zones, not {fewest} to {most}")
    samples = [run_once(command) for _ in range(arguments.runs)]
    if any(status != 0 for _, _, status in samples):
        raise SystemExit(f"{' '.join(command)}: failed")
    return statistics.median(wall for wall, _, _ in samples), own_memory(command)


def exponent(points):
    """Of the power law through (size, value) by least squares of the logarithms."""
    xs, ys = [math.log(x) for x, _ in points], [math.log(y) for _, y in points]
    x, y = statistics.mean(xs), statistics.mean(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


def scene_rows(arguments, kind):
    rows, times, memories = [], [], []
    for size in arguments.shells:
        deck = arguments.work / f"{kind}_{size}.k"
        try:
            out = subprocess.run([arguments.make_scene, kind, str(size), deck], check=True, capture_output=True, text=True).stdout
            shells, _, fewest, most = (int(n) for n in re.findall(r"\d+", out))
            megabytes = deck.stat().st_size / 2**20
            wall, own = audit(arguments, deck, fewest, most)
        finally:
            deck.unlink(missing_ok=True)
        times.append((shells, wall))
        memories.append((shells, own))
        rows.append(f"| {kind} | {shells:,} | {megabytes * 2**20 / 1e6:,.0f} MB | {wall:.2f} s | {own * 2**20 / 1e6:,.0f} MB "
                    f"| {wall / shells * 1e9:,.0f} ns | {own * 2**20 / shells:,.0f} | |")
        print(rows[-1], flush=True)
    if len(times) > 1:
        power = exponent(times)
        shells, wall = times[-1]
        factor = 1e8 / shells
        # Never better than in proportion; memory goes on as between the two largest decks.
        on_paper = wall * factor ** max(1, power)
        (before, less), (_, most) = memories[-2:]
        memory = most + (most - less) / (shells - before) * (1e8 - shells)
        rows.append(f"| {kind}, on paper | 100,000,000 | | {on_paper:,.0f} s | {memory * 2**20 / 1e9:,.0f} GB "
                    f"| {on_paper / 1e8 * 1e9:,.0f} ns | {memory * 2**20 / 1e8:,.0f} | {power:.2f} |")
        print(rows[-1], flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "work", "doc"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--shells", type=lambda text: [int(n) for n in text.split(",")], default=[10**5, 10**6, 10**7])
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--kinds", type=lambda text: text.split(","), default=["plates", "airbag", "vehicle", "blocks"])
    parser.add_argument("--table", default="scale", help="the one to rewrite")
    arguments = parser.parse_args()
    arguments.gapcheck = arguments.build / "apps/gapcheck/gapcheck"
    arguments.make_scene = arguments.build / "tests/bench/gapcheck_make_scene"
    arguments.work.mkdir(parents=True, exist_ok=True)
    table = [f"{machine()}; medians of {arguments.runs} runs after one whose findings are checked, {os.cpu_count()} threads, "
             f"{os.sysconf('SC_PHYS_PAGES') * os.sysconf('SC_PAGE_SIZE') / 1e9:.0f} GB of memory.", "",
             "| scene | elements | deck | time | memory beyond the deck | time per element | bytes per element | exponent of time |",
             "|---|---|---|---|---|---|---|---|"]
    for kind in arguments.kinds:
        table += scene_rows(arguments, kind)
    text = arguments.doc.read_text(encoding="utf-8")
    arguments.doc.write_text(section(arguments.table, text, "\n".join(table)), encoding="utf-8")


if __name__ == "__main__":
    main()
