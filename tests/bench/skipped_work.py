#!/usr/bin/env python3
"""Rewrites the output in docs/skipped-work.md: what audits of two decks leave out, by their own counters.

    tests/bench/skipped_work.py [--program build/release/apps/gapcheck/gapcheck]
"""

import argparse
import pathlib
import subprocess

import page

root = pathlib.Path(__file__).resolve().parents[2]
runs = {"two_plates": ["data/two_plates.k"], "one_rule": ["data/two_plates.k", "--select", "GC101"],
        "stray_part": ["data/stray_part.k"]}


def statistics(program, arguments):
    command = [program, "audit", *arguments, "--stats", "--fail-on", "never"]
    result = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: exit {result.returncode}\n{result.stderr}")
    lines = result.stdout.split("\nstatistics\n", 1)[1].split("\n\n", 1)[0].splitlines()
    # Times are those of one run and no measurement.
    kept = [line for line in lines if not line.lstrip().startswith("time: ")]
    return "\n".join(["```", f"$ gapcheck audit {' '.join(arguments)} --stats", "…", *kept, "```"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(root / "build/release/apps/gapcheck/gapcheck"))
    program = str(pathlib.Path(parser.parse_args().program).resolve())
    document = root / "docs/skipped-work.md"
    text = document.read_text()
    for name, arguments in runs.items():
        text = page.section(name, text, statistics(program, arguments))
    document.write_text(text)


if __name__ == "__main__":
    main()
