#!/usr/bin/env python3
"""Runs the commands of README.md as they stand there, and those of docs/tutorial.md, whose output the page shows.

    readme_commands.py ROOT GAPCHECK CHECK_C [--write]

Of README.md it takes every `./run …`, `gapcheck …` and `check-c …` of the page, in code blocks and between backticks, and runs it with
the programs GAPCHECK and CHECK_C in a temporary folder: data/ is the project's, model.k and models/plates.k are
data/two_plates.k, messag and out/ come from a run of it. Prints a line for each command. Exit code 1 if one ends with
exit code 2 or a signal, if it is unknown, or if there are so few that this program must have missed them.

Of docs/tutorial.md it takes the code blocks of "$ COMMAND" lines, each with its output below it. They are run one after the
other by the shell; the exit code is 1 if one prints anything else. --write puts what they print into the page.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LEAST = 15  # commands of each page: fewer mean that they are no longer recognised
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


def readme(root, gapcheck, check_c):
    """The exit code for README.md."""
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


def with_output(block, folder, environment):
    """A code block of the tutorial, each command with what it prints now."""
    lines = []
    for command in re.findall(r"^\$ (.*)$", block, re.M):
        ended = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=SECONDS)
        lines += [f"$ {command}", *ended.stdout.splitlines()]
    return "\n".join(lines) + "\n"


def tutorial(root, gapcheck, write):
    """The exit code for docs/tutorial.md."""
    page = root / "docs/tutorial.md"
    pieces = re.split(r"^```\n(\$ .*?)^```\n", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    commands = wrong = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copytree(root / "data", folder / "data")
        environment = os.environ | {"PATH": f"{Path(gapcheck).parent}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}
        for i in range(1, len(pieces), 2):
            commands += len(re.findall(r"^\$ ", pieces[i], re.M))
            printed = with_output(pieces[i], folder, environment)
            if not write and printed != pieces[i]:
                wrong += 1
                print(f"docs/tutorial.md shows\n{pieces[i]}and it is\n{printed}")
            pieces[i] = f"```\n{printed}```\n"
    if write:
        page.write_text("".join(pieces), encoding="utf-8")
    print(f"tutorial: {commands} commands, {wrong} blocks differ")
    return 1 if wrong or commands < LEAST else 0


def main(arguments):
    write = "--write" in arguments
    paths = [argument for argument in arguments if argument != "--write"]
    if len(paths) != 3:
        sys.exit(__doc__)
    root, gapcheck, check_c = Path(paths[0]).resolve(), *(str(Path(path).resolve()) for path in paths[1:])
    if write:
        return tutorial(root, gapcheck, True)
    return max(readme(root, gapcheck, check_c), tutorial(root, gapcheck, False))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
