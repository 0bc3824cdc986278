#!/usr/bin/env python3
"""Builds gapcheck_peers, runs it and rewrites its table in docs/benchmarks.md. One command, two minutes after the build.
Needs the packages of packages.txt beside it.

usage: measure_peers.py [--program PATH] [--size 300] [--rounds 7]
"""

import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests" / "bench"))
from page import machine, section  # noqa: E402


def build():
    folder = ROOT / "build" / "peers"
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DGAPCHECK_TESTS=OFF",
                    "-DGAPCHECK_PEERS=ON"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "gapcheck_peers"], check=True, stdout=sys.stderr)
    return folder / "tests/bench/peers/gapcheck_peers"


def rows(scene):
    out = []
    for peer in scene["peers"]:
        total = peer["build"] + peer["query"]
        out.append(f"| {peer['name']} | {peer['build'] * 1e3:.1f} ms | {peer['query'] * 1e3:.1f} ms "
                   f"| {total * 1e9 / scene['count']:,.0f} ns | {peer['ratio']:.2f} "
                   f"({peer['ratio_low']:.2f} … {peer['ratio_high']:.2f}) "
                   f"| {'' if peer['candidates_only'] else format(peer['error'], '.0e')} "
                   f"| {format(peer['pairs'], ',') if peer['pairs'] else ''} |")
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, help="gapcheck_peers; built if not given")
    parser.add_argument("--size", type=int, default=300, help="quads along an edge of the plate")
    parser.add_argument("--rounds", type=int, default=7)
    arguments = parser.parse_args()
    text = subprocess.run([arguments.program or build(), str(arguments.size), str(arguments.rounds)], check=True,
                          capture_output=True, text=True).stdout
    data = json.loads(text)
    lines = [machine() + f"; medians of {data['rounds']} rounds, the programs in turn in every round, smallest and largest "
             "ratio in brackets."]
    for scene in data["scenes"]:
        lines += ["", f"{scene['quads']:,} quads, {scene['count']:,} points: {scene['points']}", "",
                  "| | build | queries | in all, per point | in all / gapcheck | largest error | candidates |",
                  "|---|---|---|---|---|---|---|", *rows(scene)]
    page = ROOT / "docs" / "benchmarks.md"
    page.write_text(section("peers", page.read_text(encoding="utf-8"), "\n".join(lines)), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
