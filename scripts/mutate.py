#!/usr/bin/env python3
"""Changes one line of the library at a time and counts the changes that no test notices.

    scripts/mutate.py [--count N] [--seed S] [--rooms ROOM,…] [--folder BUILD] [--results FILE] [--report]

A mutant turns an operator, a constant or a condition round or drops a statement. Lines are drawn at random, the same ones
for the same seed, in proportion to the code of the rooms. Each mutant is compiled in a copy of the working tree in BUILD
(default: build/mutants), where the rooms are compiled file by file, and the tests of its room run until the first one
fails. Results are appended to FILE (default: BUILD/mutants.jsonl); mutants that are in there already are not run again, so
a broken run continues. --report prints a table of a file without running anything.
"""
import argparse
import collections
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Test programs that a change in a room must fail, the quickest first.
TESTS = {
    "model": ["model/gapcheck_test_model", "audit/gapcheck_test_audit"],
    "contact": ["contact/gapcheck_test_contact", "audit/gapcheck_test_audit"],
    "audit": ["audit/gapcheck_test_rules", "audit/gapcheck_test_audit", "audit/fix/gapcheck_test_fix"],
    "solver": ["solver/gapcheck_test_solver"],
}

# Lines ------------------------------------------------------------------------------------------------------------------

OPERATORS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "*": "/", "/": "*",
             "&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
# With blanks around, as the format of the code has it for binary operators; so no template or reference is meant.
OPERATOR = re.compile(r"(?<= )(<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|[-+*/<>])(?= )")
NUMBER = re.compile(r"(?<![\w.'])(\d+\.\d*(?:e[-+]?\d+)?|\.\d+|\d+)(?![\w.'])")
CONDITION = re.compile(r"^(\s*(?:\} else )?(?:if|while) \()(.*)(\)(?: \{| return\b.*| continue;| break;)?)$")
STATEMENT = re.compile(r"^\s*[a-zA-Z_][\w.\->\[\]]*(\(.*\)| [-+*/]?= .*|\+\+|--);$")
SKIPPED = re.compile(r"^\s*(//|#|static_assert|using |namespace |template|case |enum |friend |extern |\*)|constexpr|consteval|"
                     r"\boperator\b|std::string_view \w+ =|\bassert\(")


def code_of(line):
    """The line with strings, characters and comments blanked, of the same length."""
    line = re.sub(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'', lambda m: "\x00" * len(m[0]), line)
    return re.sub(r"//.*$", lambda m: "\x00" * len(m[0]), line)


def changed_number(text):
    if "." in text or "e" in text:
        return "0.5" if float(text) == 0 else repr(2 * float(text))
    return str(int(text) + 1)


def changes(line):
    """(kind, new line) of all mutants of a line."""
    if SKIPPED.search(line) or "R\"" in line:
        return
    code = code_of(line)
    for match in OPERATOR.finditer(code):
        yield "operator", line[:match.start()] + OPERATORS[match[0]] + line[match.end():]
    for match in NUMBER.finditer(code):
        yield "constant", line[:match.start()] + changed_number(match[0]) + line[match.end():]
    if (match := CONDITION.match(code)) and code.count("(") == code.count(")") and ";" not in match[2]:
        start, end = match.span(2)
        yield "condition", f"{line[:start]}!({line[start:end]}){line[end:]}"
    if STATEMENT.match(code) and not line.lstrip().startswith("return"):
        yield "dropped statement", re.match(r"\s*", line)[0] + ";"


def all_mutants(room):
    for path in sorted((ROOT / "lib" / room).rglob("*.cpp")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for kind, new in changes(line):
                yield {"room": room, "file": str(path.relative_to(ROOT)), "line": number, "kind": kind, "old": line.strip(),
                       "new": new.strip(), "text": new}


def drawn(rooms, count, seed):
    """Of every room as many as its share of all, in random order."""
    candidates = {room: list(all_mutants(room)) for room in rooms}
    total = sum(map(len, candidates.values()))
    choice = random.Random(seed)
    chosen = [mutant for room in rooms
              for mutant in choice.sample(candidates[room], round(count * len(candidates[room]) / total))]
    choice.shuffle(chosen)
    return chosen

# Running ----------------------------------------------------------------------------------------------------------------


def mirror(folder):
    """A copy of the working tree; what has not changed keeps its time, so that little is compiled again."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"], check=True,
                            capture_output=True, text=True).stdout
    for name in filter(None, listed.split("\0")):
        source, copy = ROOT / name, folder / name
        if source.is_file() and (not copy.exists() or copy.read_bytes() != source.read_bytes()):
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)
    # Decks beside the project, which some tests read.
    shared = folder.parent / "shared"
    if (ROOT.parent / "shared").exists() and not shared.exists():
        shared.symlink_to(ROOT.parent / "shared")


def slow_tests():
    lines = (ROOT / "tests/slow_tests.txt").read_text(encoding="utf-8").splitlines()
    return ":".join(line for line in lines if line and not line.startswith("#"))


def test(build, programs, limits):
    """The first test that fails, "crashed", "too slow", or nothing."""
    for program in programs:
        command = [build / "tests" / program, f"--gtest_filter=-{slow_tests()}", "--gtest_fail_fast", "--gtest_brief=1"]
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=limits[program])
        except subprocess.TimeoutExpired:
            return "too slow"
        if done.returncode != 0:
            failed = re.search(r"\[  FAILED  \] (\S+?)(?:,| |$)", done.stdout, re.MULTILINE)
            return failed[1] if failed else "crashed"
    return ""


def compiles(build, programs):
    targets = [pathlib.PurePath(program).name for program in programs]
    done = subprocess.run(["ninja", "-C", build, *targets], capture_output=True, text=True)
    return done.returncode == 0, done.stdout[-3000:]


def prepare(folder, rooms):
    """Configures, builds and times the unchanged tests. Returns the build folder and the seconds that each may take."""
    tree, build = folder / "tree", folder / "build"
    mirror(tree)
    if not (build / "build.ninja").exists():
        subprocess.run(["cmake", "--preset", "release", "-B", build, "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                        f"-DGAPCHECK_PLAIN={';'.join(TESTS)}", "-DGAPCHECK_WERROR=OFF"], cwd=tree, check=True,
                       stdout=subprocess.DEVNULL)
    programs = sorted({program for room in rooms for program in TESTS[room]})
    good, log = compiles(build, programs)
    if not good:
        sys.exit("the unchanged tree does not compile:\n" + log)
    limits = {}
    for program in programs:
        start = time.monotonic()
        if failed := test(build, [program], {program: 3600}):
            sys.exit(f"the unchanged {program} fails: {failed}")
        limits[program] = 10 + 4 * (time.monotonic() - start)
    return tree, build, limits


def judge(mutant, tree, build, limits):
    path = tree / mutant["file"]
    before = path.read_text(encoding="utf-8")
    lines = before.split("\n")
    lines[mutant["line"] - 1] = mutant["text"]
    path.write_text("\n".join(lines), encoding="utf-8")
    try:
        good, _ = compiles(build, TESTS[mutant["room"]])
        return test(build, TESTS[mutant["room"]], limits) or "survived" if good else "does not compile"
    finally:
        path.write_text(before, encoding="utf-8")


def key(mutant):
    return mutant["file"], mutant["line"], mutant["new"]


def read(results):
    return [json.loads(line) for line in results.read_text(encoding="utf-8").splitlines()] if results.exists() else []


def report(mutants):
    """Table by room and kind, and the survivors."""
    valid = [mutant for mutant in mutants if mutant["outcome"] != "does not compile"]
    lines = ["| room | mutants | caught | share |", "|---|---:|---:|---:|"]
    by_room = collections.defaultdict(list)
    for mutant in valid:
        by_room[mutant["room"]].append(mutant["outcome"] != "survived")
    for room, caught in [*sorted(by_room.items()), ("all", [one for room in by_room.values() for one in room])]:
        lines.append(f"| {room} | {len(caught)} | {sum(caught)} | {100 * sum(caught) / max(1, len(caught)):.0f} % |")
    lines += ["", "Survivors:"]
    for mutant in sorted(valid, key=key):
        if mutant["outcome"] == "survived":
            lines.append(f"- `{mutant['file']}:{mutant['line']}` {mutant['kind']}: `{mutant['old']}` → `{mutant['new']}`")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rooms", default=",".join(TESTS))
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "mutants")
    parser.add_argument("--results", type=pathlib.Path)
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--list", action="store_true", help="print the mutants and run nothing")
    given = parser.parse_args()
    results = given.results or given.folder / "mutants.jsonl"
    if given.report:
        print(report(read(results)))
        return
    rooms = given.rooms.split(",")
    mutants = drawn(rooms, given.count, given.seed)
    if given.list:
        for mutant in mutants:
            print(f"{mutant['file']}:{mutant['line']} {mutant['kind']}: {mutant['old']}  ->  {mutant['new']}")
        return
    given.folder.mkdir(parents=True, exist_ok=True)
    os.environ["CCACHE_DISABLE"] = "1"
    tree, build, limits = prepare(given.folder.resolve(), rooms)
    done = {key(mutant) for mutant in read(results)}
    for number, mutant in enumerate(mutants, 1):
        if key(mutant) in done:
            continue
        outcome = judge(mutant, tree, build, limits)
        with results.open("a", encoding="utf-8") as file:
            file.write(json.dumps({**mutant, "outcome": outcome}) + "\n")
        print(f"{number}/{len(mutants)} {mutant['file']}:{mutant['line']} {outcome}", flush=True)
    print(report(read(results)))


if __name__ == "__main__":
    main()
