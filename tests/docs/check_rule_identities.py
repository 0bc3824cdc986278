#!/usr/bin/env python3
"""Checks that the identity of a rule, its id and its name, is written once.

    check_rule_identities.py ROOT
    check_rule_identities.py --self-test

A declaration is {"GC101", "initial-penetration", Severity::…}, in lib/records/record_rules.hpp or in the rule's own
file lib/audit/rules/GROUP/NAME.cpp. No other string literal of lib/ and apps/ (*.hpp, *.cpp) contains an id, the
beginning of one (GC1) or the name of a rule: texts are built from the declared constants. ALLOWED lists the exceptions.
Prints a line for each fault; exit code 1 if there is any, or if so few rules are declared that this program must have
missed them.
"""

import contextlib
import io
import re
import sys
import tempfile
from pathlib import Path

from check_references import CPP_TOKEN

RECORD_RULES = "lib/records/record_rules.hpp"
RULES = "lib/audit/rules"
LEAST_RULES = 50  # fewer declarations mean that they are no longer recognised

# (file, literal): why it may name a rule.
ALLOWED = {
    ("lib/results/log/node_lines.cpp", "mortar-penetration"): "the kind of a message, as in message_kinds.txt",
    ("apps/gapcheck/settings/settings_file.cpp", "GC1"): "all rules about penetrations",
    ("apps/gapcheck/messag.cpp", "Judge the run by these rules only (GC6xx)"): "all rules on runs",
}

DECLARATION = re.compile(r'\{\s*"(?P<id>GC\d{3})",\s*"(?P<name>[a-z\d]+(?:-[a-z\d]+)*)",\s*Severity::')
ID = re.compile(r"(?<!\w)GC\d", re.I)


def literals(source):
    """(offset, text) of each string literal, without quotes."""
    for token in CPP_TOKEN.finditer(source):
        text = token[0]
        if text.startswith('"'):
            yield token.start(), text[1:-1]
        elif text.startswith('R"'):
            yield token.start(), text[text.index("(") + 1 : text.rindex(")")]


def without_comments(source):
    """The source with its comments blanked out, so that offsets stay."""

    def blank(token):
        comment = token["line"] or token["block"]
        return re.sub(r"[^\n]", " ", comment) if comment else token[0]

    return CPP_TOKEN.sub(blank, source)


class Checker:
    def __init__(self, root, allowed):
        self.root = root
        self.allowed = allowed
        self.used = set()
        self.faults = []
        self.sources = {}
        for folder in ("lib", "apps"):
            for path in sorted((root / folder).rglob("*")):
                if path.suffix in (".hpp", ".cpp") and path.is_file():
                    self.sources[path.relative_to(root).as_posix()] = path.read_text(encoding="utf-8")
        self.declared = {}  # id or name: "file:line"
        self.places = set()  # (file, offset) of the literals of declarations
        self.names = []

    def report(self, file, offset, message):
        line = self.sources[file].count("\n", 0, offset) + 1
        self.faults.append(f"{file}:{line}: {message}")

    def declare(self, file, match):
        for part in ("id", "name"):
            text, offset = match[part], match.start(part)
            if text in self.declared:
                self.report(file, offset, f"{text} is declared in {self.declared[text]} already")
            else:
                line = self.sources[file].count("\n", 0, offset) + 1
                self.declared[text] = f"{file}:{line}"
            self.places.add((file, offset - 1))
        self.names.append(match["name"])
        own = rf"{RULES}/[^/]+/{match['name'].replace('-', '_')}\.cpp"
        if file != RECORD_RULES and not re.fullmatch(own, file):
            name = match["name"].replace("-", "_")
            self.report(file, match.start(), f"{match['name']} must be declared in {RULES}/GROUP/{name}.cpp")

    def find_declarations(self):
        for file, source in self.sources.items():
            for match in DECLARATION.finditer(without_comments(source)):
                self.declare(file, match)

    def check_literals(self):
        names = "|".join(map(re.escape, sorted(self.names, key=len, reverse=True))) or r"(?!)"
        name = re.compile(rf"(?<![\w-])(?:{names})(?![\w-])")
        for file, source in self.sources.items():
            for offset, text in literals(source):
                if (file, offset) in self.places or not (ID.search(text) or name.search(text)):
                    continue
                if (file, text) in self.allowed:
                    self.used.add((file, text))
                else:
                    self.report(file, offset, f'"{text}" names a rule: use its declared identity')

    def run(self):
        self.find_declarations()
        self.check_literals()
        for file, text in sorted(set(self.allowed) - self.used):
            self.faults.append(f'{file}: there is no "{text}" any more; take it out of ALLOWED')


def check(root, allowed=None, least_rules=LEAST_RULES):
    """The exit code; prints the faults."""
    checker = Checker(Path(root).resolve(), ALLOWED if allowed is None else allowed)
    checker.run()
    for fault in checker.faults:
        print(fault)
    few = len(checker.names) < least_rules
    if few:
        print(f"only {len(checker.names)} rules are declared, expected at least {least_rules}")
    print(f"{len(checker.names)} rules, {len(checker.faults) or 'no'} faults")
    return 1 if checker.faults or few else 0


# --- self-test ---------------------------------------------------------------------------------------------------

SOUND = {
    RECORD_RULES: '// GC101 is "GC101".\n'
    'constexpr Identity a{"GC101", "deep-node", Severity::note, "a node", Need::ties};\n'
    'constexpr Identity b{\n    "GC102",\n    "too-deep-node", Severity::note};\n',
    "lib/audit/rules/mesh/free_node.cpp": 'const Rule definition{{"GC508", "free-node", Severity::note, ""}};\n',
    "lib/other.cpp": '// "GC101", deep-node\n'
    'const char* text = "not-deep-node, deep-nodes, deep node, GC";  /* "GC101" */\n'
    "const char c = '\"';\nint n = 1'000;  // GC101\n",
    "apps/main.cpp": 'const char* prefix = "GC1";\n',
    "tests/test.cpp": 'const char* id = "GC101";\n',
}
SOUND_ALLOWED = {("apps/main.cpp", "GC1"): "a prefix"}
FAULTS = {
    "lib/other.cpp": 'const char* a = "GC101";\nconst char* b = "the deep-node, and others";\n'
    'const char* c = R"(\nGC508)";\n',
    "lib/audit/rules/mesh/other.cpp": 'const Rule definition{{"GC509", "stray-segment", Severity::note}};\n',
    "lib/audit/rules/tie/deep_node.cpp": 'const Rule definition{{"GC101", "deep-node", Severity::note}};\n',
    "apps/main.cpp": 'const char* help = "gc101 or";\n',
}
REPORTS = [
    "lib/audit/rules/mesh/other.cpp:1: stray-segment must be declared in lib/audit/rules/GROUP/stray_segment.cpp",
    "lib/records/record_rules.hpp:2: GC101 is declared in lib/audit/rules/tie/deep_node.cpp:1 already",
    "lib/records/record_rules.hpp:2: deep-node is declared in lib/audit/rules/tie/deep_node.cpp:1 already",
    'lib/other.cpp:1: "GC101" names a rule: use its declared identity',
    'lib/other.cpp:2: "the deep-node, and others" names a rule: use its declared identity',
    'lib/other.cpp:3: "\nGC508" names a rule: use its declared identity',
    'apps/main.cpp:1: "gc101 or" names a rule: use its declared identity',
    'apps/main.cpp: there is no "GC1" any more; take it out of ALLOWED',
]


def outcome(files, *arguments):
    """Exit code and lines of a check of these files."""
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            code = check(folder, *arguments)
    return code, printed.getvalue().splitlines()


def self_test():
    reports = [line for report in REPORTS for line in report.split("\n")]
    expected = {
        "a sound tree": ((0, ["3 rules, no faults"]), outcome(SOUND, SOUND_ALLOWED, 3)),
        "too few rules": (
            (1, ["only 3 rules are declared, expected at least 50", "3 rules, no faults"]),
            outcome(SOUND, SOUND_ALLOWED),
        ),
        "faults": ((1, reports + ["5 rules, 8 faults"]), outcome({**SOUND, **FAULTS}, SOUND_ALLOWED, 3)),
    }
    wrong = {name: pair for name, pair in expected.items() if pair[0] != pair[1]}
    for name, (wanted, got) in wrong.items():
        print(f"{name}: expected {wanted[0]}", *wanted[1], f"got {got[0]}", *got[1], sep="\n  ")
    print(f"self-test: {len(expected) - len(wrong)} of {len(expected)} cases as expected")
    return 1 if wrong else 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print("usage: check_rule_identities.py ROOT | --self-test", file=sys.stderr)
        return 2
    return check(arguments[0])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
