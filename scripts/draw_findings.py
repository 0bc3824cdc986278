#!/usr/bin/env python3
"""Draws findings of the audit at random from a folder of decks, for a person to judge one by one.

    scripts/draw_findings.py GAPCHECK DECKS [--seed N] [--count N] [--format table|json]

Audits each keyword file below DECKS that no other file there includes. Findings of one rule that differ in ids and
values only (one contact and one pair of parts, where it has them) are one line, of which one finding is taken. What the
report folds under its cause is not drawn. Rules take turns, errors first; a rule's turns go round the folders of DECKS,
those with samples for parsers last. The same seed, decks and program draw the same findings.
"""
import argparse
import json
import pathlib
import random
import re
import subprocess
import sys

ENDINGS = {".k", ".key", ".dyn"}
SEVERITIES = ["error", "warning", "note"]
SAMPLES = {"keyword_templates", "pydyna_tests", "small_decks"}  # not written to be run
IDS = ("contact", "node", "element", "part", "element_part")
INCLUDE = re.compile(r"\s*\*INCLUDE(?!_PATH|_AUTO)", re.IGNORECASE)


def included_names(path):
    """The file names, without folders, that a keyword file includes."""
    names, after_keyword = set(), False
    for line in path.read_text(encoding="latin-1").splitlines():
        if line.startswith("$"):
            continue
        if line.startswith("*"):
            after_keyword = bool(INCLUDE.match(line))
        elif after_keyword and line.strip():
            names.add(line.strip().replace("\\", "/").rsplit("/", 1)[-1])
            after_keyword = False
    return names


def main_decks(folder):
    """Keyword files that no other file of their case includes, by path. A case is a folder of `folder`, or a file."""
    files = sorted(path for path in folder.rglob("*") if path.suffix.lower() in ENDINGS and path.is_file())
    included = {(case_of(path, folder), name) for path in files for name in included_names(path)}
    return [path for path in files if (case_of(path, folder), path.name) not in included]


def case_of(path, folder):
    return path.relative_to(folder).parts[0]


def audit(program, deck, case):
    """The findings of a deck; folders of its case count as include folders."""
    folders = sorted({str(path.parent) for path in case.rglob("*") if path.is_file()}) if case.is_dir() else []
    command = [program, "audit", str(deck), "--format", "json", "--list", "--no-config", "--fail-on", "never"]
    command += [word for folder in folders for word in ("-I", folder)]
    run = subprocess.run(command, capture_output=True, text=True)
    if not run.stdout:
        sys.exit(f"{deck}: {run.stderr.strip()}")
    return json.loads(run.stdout)["findings"]


def follows(finding):
    """Whether the report counts it behind another finding; `cause` of a penetration is its thickness."""
    return "cause" in finding and "penetration" not in finding


def line_of(deck, finding):
    """What findings that count as one line have in common."""
    pattern = re.sub(r"[-+]?\d[\d.]*(E[-+]?\d+)?", "#", finding["message"], flags=re.IGNORECASE)
    parts = "" if finding["id"] == "GC502" else (finding.get("part"), finding.get("element_part"))
    return (deck, finding["id"], finding.get("contact"), parts, re.sub(r"\(.*\)", "", pattern))


def lines(program, folder, decks):
    """Lines of each rule, by case: {(severity, rule): {case: [[(deck, finding), …], …]}}."""
    found = {}
    for deck in decks:
        name = str(deck.relative_to(folder))
        case = case_of(deck, folder)
        by_line = {}
        for finding in audit(program, deck, folder / case):
            if follows(finding):
                continue
            by_line.setdefault(line_of(name, finding), []).append((name, finding))
        for (_, rule, *_), members in by_line.items():
            key = (SEVERITIES.index(members[0][1]["severity"]), rule)
            found.setdefault(key, {}).setdefault(case, []).append(members)
    return found


def draw(found, count, seed):
    """Takes a line of every rule in turn, and one finding of each line."""
    chance = random.Random(seed)
    queues = {}
    for key in sorted(found):
        names = sorted(found[key], key=lambda name: (name in SAMPLES, chance.random()))
        cases = [chance.sample(found[key][name], len(found[key][name])) for name in names]
        longest = max(len(case) for case in cases)
        queues[key] = [case[turn] for turn in range(longest) for case in cases if turn < len(case)]
    drawn = []
    while len(drawn) < count and any(queues.values()):
        for key in sorted(queues):
            if queues[key] and len(drawn) < count:
                drawn.append((key, chance.choice(queues[key].pop(0))))
    return [member for _, member in sorted(drawn, key=lambda entry: entry[0])]


def ids_of(finding):
    return " ".join(f"{name} {finding[name]}" for name in IDS[1:] if name in finding)


def table(drawn):
    rows = ["| # | deck | rule | severity | contact | ids | message |", "|---:|---|---|---|---|---|---|"]
    for number, (deck, finding) in enumerate(drawn, 1):
        cells = [number, deck, finding["id"], finding["severity"], finding.get("contact", ""), ids_of(finding),
                 finding["message"].replace("|", "\\|")]
        rows.append("| " + " | ".join(str(cell) for cell in cells) + " |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="GAPCHECK")
    parser.add_argument("decks", metavar="DECKS", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (1)")
    parser.add_argument("--count", type=int, default=60, help="how many to draw (60)")
    parser.add_argument("--format", choices=["table", "json"], default="table", help="json: whole findings")
    parser.add_argument("--small", action="store_true", help="the first ten decks only, to test this script")
    arguments = parser.parse_args()
    decks = main_decks(arguments.decks)
    drawn = draw(lines(arguments.program, arguments.decks, decks[:10] if arguments.small else decks),
                 arguments.count, arguments.seed)
    if arguments.format == "json":
        print(json.dumps([{"deck": deck, **finding} for deck, finding in drawn], indent=1))
    else:
        print(table(drawn))


if __name__ == "__main__":
    main()
