#!/usr/bin/env python3
"""Writes the table of docs/theory/solver-ties.md from what the tests of tied cantilevers measure.

    scripts/tie_accuracy.py BUILD/tests/solver/gapcheck_test_solver
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "theory" / "solver-ties.md"
BEGIN, END = "<!-- measured -->\n", "<!-- end -->\n"

# Suite and what it is.
SUITES = [
    ("Cantilever/TiedShells", "shells, edge in the plane of the other half"),
    ("Cantilever/TiedBricks", "bricks, face on face"),
    ("Cantilever/ShellOnBlock", "shell edge on a block"),
    ("Cantilever/LapJoint", "shells above one another, pulled"),
]


def measure(program, tests):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "tests.json"
        subprocess.run([program, f"--gtest_filter={tests}", f"--gtest_output=json:{path}"],
                       check=True, stdout=subprocess.DEVNULL)
        suites = json.loads(path.read_text())["testsuites"]
    return {suite["name"]: suite["testsuite"] for suite in suites}


def table(found):
    lines = ["| joint | tie | SFS, SFM | deflection | first frequency |", "|---|---|---|---|---|"]
    for suite, what in SUITES:
        for test in found.get(suite, []):
            name = test["name"].split("/")[1].removeprefix("type_").replace("_", " ")
            scale = float(test.get("scale", 1))
            lines.append(f"| {what} | {name} | {scale:g} | {test['deflection']} | {test.get('frequency', '')} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="TEST_SOLVER")
    parser.add_argument("--small", action="store_true", help="one kind of joint only, to test this script")
    arguments = parser.parse_args()
    found = measure(arguments.program, "Cantilever/LapJoint.*" if arguments.small else "Cantilever/*")
    if not arguments.small and len(found) != len(SUITES):
        raise SystemExit(f"{arguments.program}: not the suites that are listed here")
    text = PAGE.read_text()
    head, rest = text.split(BEGIN)
    PAGE.write_text(head + BEGIN + table(found) + END + rest.split(END)[1])


if __name__ == "__main__":
    main()
