#!/usr/bin/env python3
"""Runs the commands of README.md as they stand there.

    readme_commands.py ROOT GAPCHECK CHECK_C

Takes every `./run …`, `gapcheck …` and `check-c …` of the page, in code blocks and between backticks, and runs it with
the programs GAPCHECK and CHECK_C in a temporary folder: data/ is the project's, model.k and models/plates.k are
data/two_plates.k, messag and out/ come from a run of it. Prints a line for each command. Exit code 1 if one ends with
exit code 2 or a signal, if it is unknown, or if there are so few that this program must have missed them.
"""

import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LEAST = 15  # commands of the page: fewer mean that they are no longer recognised
SECONDS = 120  # for each


def commands(markdown):
    """The commands in order of appearance, each once, as lists of words."""
    candidates = []
    for match in re.finditer(r"^ {4}(?P<line>\S.*)$|(?<!`)`(?P<inline>[^`]+)`(?!`)", markdown, re.M):
        candidates.append(match["line"] or " ".join(match["inline"].split()))
    found = []
    for text in candidates:
        if not re.match(r"(\./run|gapcheck|check-c)\s+\S", text):
            continue
        words = shlex.split(text, comments=True)
        if words not in found:
            found.append(words)
    return found


def program_and_arguments(words, gapcheck, check_c):
    """./run starts gapcheck, or check-c if that is its first argument."""
    name, arguments = words[0], words[1:]
    if name == "./run" and arguments[0] == "check-c":
        return check_c, arguments[1:]
    return (check_c if name == "check-c" else gapcheck), arguments


def run(command, folder):
    return subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=SECONDS)


def prepare(root, gapcheck, folder):
    """The files that the commands name."""
    shutil.copytree(root / "data", folder / "data")
    shutil.copyfile(root / "data/two_plates.k", folder / "model.k")
    (folder / "models").mkdir()
    shutil.copyfile(root / "data/two_plates.k", folder / "models/plates.k")
    made = run([gapcheck, "run", "model.k", "-o", "out", "--quiet"], folder)
    if made.returncode != 0:
        sys.exit(f"the run that the commands need fails:\n{made.stderr}")
    shutil.copyfile(folder / "out/messag", folder / "messag")


def main(root, gapcheck, check_c):
    found = commands((root / "README.md").read_text(encoding="utf-8"))
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        prepare(root, gapcheck, folder)
        for words in found:
            program, arguments = program_and_arguments(words, gapcheck, check_c)
            ended = run([program, *arguments], folder)
            good = ended.returncode in (0, 1)
            failed += not good
            print(f"{'ok    ' if good else 'FAILED'} {ended.returncode} {shlex.join(words)}")
            if not good:
                print(ended.stderr)
    print(f"{len(found)} commands, {failed} failed")
    if len(found) < LEAST:
        print(f"expected at least {LEAST}")
    return 1 if failed or len(found) < LEAST else 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve(), *(str(Path(p).resolve()) for p in sys.argv[2:])))
