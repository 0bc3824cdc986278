#!/usr/bin/env python3
"""Changes one line of the library at a time and counts the changes that no test notices.

    scripts/mutate.py [--count N] [--seed S] [--jobs N] [--rooms ROOM,…] [--folder BUILD] [--results FILE] [--again]
    scripts/mutate.py --report [--folder BUILD] [--results FILE]

A mutant turns an operator, a constant or a condition round or drops a statement. Lines are drawn at random, the same ones
for the same seed, in proportion to the code of the rooms. A copy of the working tree is compiled in BUILD (default:
build/mutants), file by file. Each mutant is compiled alone and linked with the rest, and the tests of its room run until the
first one fails, those of its own file first. Where a mutant survives, the tests of its own file run once more with
sanitizers, as ./test runs them. FILE (default: BUILD/mutants.jsonl) holds the results; a broken run continues there. --again
runs the survivors again, after tests were written. tests/mutants.json holds the reasons of survivors that change nothing
that anybody can see. The table of docs/mutants.md is written at the end; --report does only that.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Test programs that a change in a room must fail, the quickest first.
TESTS = {
    "model": ["model/gapcheck_test_model", "audit/gapcheck_test_audit", "audit/gapcheck_test_contact_rules"],
    "contact": ["contact/gapcheck_test_contact", "audit/gapcheck_test_audit", "audit/gapcheck_test_contact_rules"],
    "audit": ["audit/gapcheck_test_rules", "audit/gapcheck_test_audit", "audit/fix/gapcheck_test_fix"],
    "solver": ["solver/gapcheck_test_solver"],
}
# Of tests/slow_tests.txt, which are left out: the comparison with the reference implementation is worth its time.
KEPT = {"ContactRules.ManyRandomDecks"}
MEMORY = 6 << 30  # bytes of address space that a test program may take
FAST_LINKER = ["-fuse-ld=lld"] if shutil.which("ld.lld") else []
SANITIZERS = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-D_GLIBCXX_ASSERTIONS", "-g1"]
REASONS = ROOT / "tests" / "mutants.json"
PAGE = ROOT / "docs" / "mutants.md"
BEGIN, END = "<!-- mutants -->", "<!-- /mutants -->"

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
    return ":".join(line for line in lines if line and not line.startswith("#") and line not in KEPT)


def near_suites(mutant):
    """A filter for the tests of the mutant's own file: these are the likeliest to fail."""
    suites = {suite for path in (ROOT / "tests").rglob(f"{pathlib.PurePath(mutant['file']).stem}_test.cpp")
              for suite in re.findall(r"^TEST(?:_F|_P)?\((\w+),", path.read_text(encoding="utf-8"), re.MULTILINE)}
    return ":".join(f"{suite}.*:*/{suite}.*" for suite in sorted(suites))


def limited(seconds, memory):
    """For a child process: what a mutant may use of processor time and memory."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    return limit


def test(program, filters, seconds, folder, memory=MEMORY):
    """The first test that fails, "crashed", "too slow", or nothing."""
    command = [program, f"--gtest_filter={filters}-{slow_tests()}", "--gtest_fail_fast", "--gtest_brief=1"]
    environment = {**os.environ, "TMPDIR": str(folder), "TEST_TMPDIR": str(folder)}
    try:
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, errors="replace",
                              timeout=10 * seconds, preexec_fn=limited(seconds, memory))
    except subprocess.TimeoutExpired:
        return "too slow"
    if done.returncode == 0:
        return ""
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "too slow"
    failed = re.search(r"\[  FAILED  \] (\S+?)(?:,| |$)", done.stdout, re.MULTILINE)
    return failed[1] if failed else "crashed"


class Build:
    """The unchanged tree, compiled: how to compile one of its files and to link a test program, and what tests may take."""

    def __init__(self, folder, rooms):
        self.tree, self.build = folder / "tree", folder / "build"
        mirror(self.tree)
        if not (self.build / "build.ninja").exists():
            subprocess.run(["cmake", "--preset", "release", "-B", self.build, "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                            f"-DGAPCHECK_PLAIN={';'.join(TESTS)}", "-DGAPCHECK_WERROR=OFF"], cwd=self.tree, check=True,
                           stdout=subprocess.DEVNULL)
        programs = sorted({program for room in rooms for program in TESTS[room]})
        targets = [pathlib.PurePath(program).name for program in programs]
        done = subprocess.run(["ninja", "-C", self.build, *targets], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit("the unchanged tree does not compile:\n" + done.stdout[-3000:])
        commands = json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8"))
        self.compilers = {str(pathlib.Path(one["file"])): shlex.split(one["command"]) for one in commands}
        self.linkers = {program: self.linker(program) for program in programs}
        self.seconds = {program: self.measured(program, folder) for program in programs}

    def linker(self, program):
        lines = subprocess.run(["ninja", "-C", self.build, "-t", "commands", pathlib.PurePath(program).name], check=True,
                               capture_output=True, text=True).stdout.splitlines()
        return [word for word in shlex.split(lines[-1]) if word not in (":", "&&")]

    def measured(self, program, folder):
        used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
        before = used()
        if failed := test(self.build / "tests" / program, "*", 3600, folder):
            sys.exit(f"the unchanged {program} fails: {failed}")
        return 10 + int(4 * (used() - before))

    def compile(self, mutant, folder, options=()):
        """The object of the changed file, or nothing."""
        path = self.tree / mutant["file"]
        lines = path.read_text(encoding="utf-8").split("\n")
        lines[mutant["line"] - 1] = mutant["text"]
        changed, target = folder / path.name, folder / "mutant.o"
        changed.write_text("\n".join(lines), encoding="utf-8")
        command = list(self.compilers[str(path)])
        command[command.index("-o") + 1] = str(target)
        command[command.index("-c") + 1] = str(changed)
        done = subprocess.run([*command, "-w", "-iquote", path.parent, *options], cwd=self.build, capture_output=True)
        return target if done.returncode == 0 else None

    def link(self, program, target, folder, options=()):
        """The test program with the changed object before the libraries, whose own one is then not taken."""
        command, linked = list(self.linkers[program]), folder / pathlib.PurePath(program).name
        command[command.index("-o") + 1] = str(linked)
        command.insert(1, str(target))
        subprocess.run([*command, *FAST_LINKER, *options], cwd=self.build, check=True, capture_output=True)
        return linked


def failing(mutant, build, filters, options=(), memory=MEMORY):
    """The test that fails with this mutant, or nothing; "does not compile"."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        target = build.compile(mutant, folder, options)
        if target is None:
            return "does not compile"
        linked = {}
        for tests in filter(None, filters):
            for program in TESTS[mutant["room"]]:
                linked[program] = linked.get(program) or build.link(program, target, folder, options)
                # Sanitizers make programs slower.
                seconds = build.seconds[program] * (3 if options else 1)
                if failed := test(linked[program], tests, seconds, folder, memory):
                    return failed
    return ""


def judge(mutant, build):
    """What happens to a mutant: "survived", or who caught it."""
    near = near_suites(mutant)
    if failed := failing(mutant, build, [near, "*"]):
        return failed
    # The sanitizer reserves far more addresses than it uses.
    failed = failing(mutant, build, [near], SANITIZERS, resource.RLIM_INFINITY)
    return failed + ", sanitized" if failed else "survived"


def key(mutant):
    return mutant["file"], mutant["line"], mutant["new"]


def named(mutant):
    """As tests/mutants.json names it: lines move."""
    return mutant["file"], mutant["old"], mutant["new"]


def read(results):
    return [json.loads(line) for line in results.read_text(encoding="utf-8").splitlines()] if results.exists() else []


def write(results, mutants):
    results.write_text("".join(json.dumps(mutant) + "\n" for mutant in mutants), encoding="utf-8")


def found_again(mutant):
    """The line where a mutant of an earlier tree is now; nothing if there is none like it any more."""
    path = ROOT / mutant["file"]
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    places = [number for number, line in enumerate(lines, 1) if line.strip() == mutant["old"]]
    return min(places, key=lambda number: abs(number - mutant["line"])) if places else None


def reasons():
    """Why a survivor changes nothing that anybody can see."""
    listed = json.loads(REASONS.read_text(encoding="utf-8")) if REASONS.exists() else []
    return {named(one): one["reason"] for one in listed}


def cell(code):
    return "`" + code.replace("|", "\\|") + "`"


def report(mutants):
    """Table by room, and the survivors with their reasons."""
    valid = [mutant for mutant in mutants if mutant["outcome"] not in ("open", "does not compile")]
    lines = ["| room | changes | noticed | of these by a sanitizer | line rewritten since | survived | noticed or rewritten |",
             "|---|---:|---:|---:|---:|---:|---:|"]
    for room in [*sorted({mutant["room"] for mutant in valid}), "all"]:
        outcomes = [mutant["outcome"] for mutant in valid if room in (mutant["room"], "all")]
        survived, gone = outcomes.count("survived"), outcomes.count("the line is gone")
        noticed = len(outcomes) - survived - gone
        sanitized = sum(outcome.endswith(", sanitized") for outcome in outcomes)
        share = 100 * (1 - survived / max(1, len(outcomes)))
        lines.append(f"| {room} | {len(outcomes)} | {noticed} | {sanitized} | {gone} | {survived} | {share:.0f} % |")
    known = reasons()
    lines += ["", "| survivor | line | changed to | reason |", "|---|---|---|---|"]
    for mutant in sorted(valid, key=key):
        if mutant["outcome"] == "survived":
            why = known.get(named(mutant), "none is known: a test is missing")
            lines.append(f"| {mutant['file'].removeprefix('lib/')} | {cell(mutant['old'])} | {cell(mutant['new'])} | {why} |")
    return "\n".join(lines)


def write_page(mutants):
    head, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    PAGE.write_text(f"{head}{BEGIN}\n{report(mutants)}\n{END}{rest.split(END)[1]}", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--rooms", default=",".join(TESTS))
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "mutants")
    parser.add_argument("--results", type=pathlib.Path)
    parser.add_argument("--again", action="store_true", help="run the survivors again")
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--list", action="store_true", help="print the mutants and run nothing")
    given = parser.parse_args()
    results = given.results or given.folder / "mutants.jsonl"
    if given.report:
        write_page(read(results))
        return
    rooms = given.rooms.split(",")
    if given.list:
        for mutant in drawn(rooms, given.count, given.seed):
            print(f"{mutant['file']}:{mutant['line']} {mutant['kind']}: {mutant['old']}  ->  {mutant['new']}")
        return
    given.folder.mkdir(parents=True, exist_ok=True)
    os.environ["CCACHE_DISABLE"] = "1"
    build = Build(given.folder.resolve(), rooms)
    mutants = read(results)
    for mutant in mutants:
        if mutant["outcome"] == "open" or (given.again and mutant["outcome"] == "survived"):
            mutant["line"] = found_again(mutant) or 0
            mutant["outcome"] = "open" if mutant["line"] else "the line is gone"
    if not given.again:
        known = {key(mutant) for mutant in mutants}
        mutants += [{**mutant, "outcome": "open"} for mutant in drawn(rooms, given.count, given.seed) if key(mutant) not in known]
    listed = reasons()
    # Those that nobody can notice take all tests: they come last.
    open_ones = sorted((mutant for mutant in mutants if mutant["outcome"] == "open"), key=lambda one: named(one) in listed)
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as workers:
        for number, (mutant, outcome) in enumerate(zip(open_ones, workers.map(lambda one: judge(one, build), open_ones)), 1):
            mutant["outcome"] = outcome
            write(results, mutants)
            print(f"{number}/{len(open_ones)} {mutant['file']}:{mutant['line']} {outcome}", flush=True)
    write_page(mutants)


if __name__ == "__main__":
    main()
