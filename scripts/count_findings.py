#!/usr/bin/env python3
"""Counts what every rule finds in other people's decks and rewrites the tables of docs/real-decks.md.

    scripts/count_findings.py GAPCHECK DECKS    GAPCHECK: the program; DECKS: the folder with the decks

Two tables show complete models side by side. The third counts in all decks below DECKS that no other file there
includes, and has every rule that judges decks.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys

import draw_findings

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "real-decks.md"
BEGIN, END = "<!-- findings: begin -->", "<!-- findings: end -->"

# Complete models: name in the table, deck below the folder, further arguments.
DECKS = [
    ("ball_plate", "ball_plate/ball_plate.k", []),
    ("bird_on_panel", "bird_on_panel/bird.k", []),
    ("bird_strike", "bird_strike_composite/input.k", []),
    ("birdball", "birdball_eroding/birdball.k", []),
    ("car6", "car6/car6_crash.k", []),
    ("car6_refined", "car6_refined/lsopt_car6/main_v22.k", []),
    ("roll_forming", "roll_forming/model.k", []),
    ("projectile", "small_decks/tests/testfiles/run/case-keywords/projectile.k", []),
    ("tied_plate", "tied_plate_with_run/main.k", []),
    ("two_body_impact", "two_body_impact/main.k", []),
    ("body_contacts", "body_contacts_no_mesh/model/50F-seated/vivaplus-50F.key",
     ["-I", "body_contacts_no_mesh/model/common", "--missing-includes", "skip"]),
]

# With --small: DECKS is data/.
SMALL = [("two_plates", "two_plates.k", []), ("tied_then_contact", "tied_then_contact.k", ["-I", "."])]


def audit(program, folder, deck, extra, *more):
    extra = [str(folder / a) if i and extra[i - 1] == "-I" else a for i, a in enumerate(extra)]
    run = subprocess.run([program, "audit", str(folder / deck), "--fail-on", "never", *extra, *more],
                         capture_output=True, text=True)
    if not run.stdout:
        sys.exit(f"{deck}: {run.stderr.strip()}")
    return run.stdout


def findings(program, folder, deck, extra):
    """The model, how often each rule fires (a line that represents many counts as that many), and the lines of the text
    report, short and whole."""
    report = json.loads(audit(program, folder, deck, extra, "--format", "json"))
    lines = [audit(program, folder, deck, extra, *more).count("\n") for more in ([], ["--list"])]
    count = collections.Counter()
    for f in report["findings"]:
        count[f["id"]] += f.get("count", 1)
    return report["model"], count, lines


def deck_rules(program):
    """Id and name of the rules that judge decks; GC6 judges runs."""
    listed = subprocess.run([program, "rules"], capture_output=True, text=True, check=True).stdout.splitlines()
    return [line.split()[:2] for line in listed if line.startswith("GC") and not line.startswith("GC6")]


def link(id_, rule):
    return f"{id_} [{rule}](rules/{rule}.md)"


def model_tables(program, folder, chosen, rules):
    """The models, and the rules that fire in one of them."""
    decks = [(name, *findings(program, folder, deck, extra)) for name, deck, extra in chosen]
    lines = ["| deck | nodes | contacts | lines of the report | with `--list` |", "|---|---:|---:|---:|---:|"]
    lines += [f"| {name} | {model['nodes']:,} | {model['contacts']} | {short} | {whole:,} |"
              for name, model, _, (short, whole) in decks]
    lines += ["", "| rule | " + " | ".join(deck[0] for deck in decks) + " |", "|---|" + "---:|" * len(decks)]
    for id_, rule in rules:
        if any(count[id_] for _, _, count, _ in decks):
            cells = [f"{count[id_]:,}" if count[id_] else "" for _, _, count, _ in decks]
            lines.append(f"| {id_} {rule} | " + " | ".join(cells) + " |")
    return lines


def all_decks_table(program, folder, rules):
    """How many decks each rule fires in, and how often; every rule has its row."""
    decks = draw_findings.main_decks(folder)
    fired, number, cases = collections.Counter(), collections.Counter(), {}
    for deck in decks:
        case = draw_findings.case_of(deck, folder)
        count = collections.Counter()
        for finding in draw_findings.audit(program, deck, folder / case):
            count[finding["id"]] += finding.get("count", 1)
        for id_, found in count.items():
            fired[id_] += 1
            number[id_] += found
            cases.setdefault(id_, {}).setdefault(case, None)
    lines = [f"{len(decks)} decks in {len({draw_findings.case_of(deck, folder) for deck in decks})} folders:", "",
             "| rule | in folders | findings | decks |", "|---|---|---:|---:|"]
    for id_, rule in rules:
        names = list(cases.get(id_, []))
        shown = ", ".join(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")
        lines.append(f"| {link(id_, rule)} | {shown} | {number[id_] or '':,} | {fired[id_] or ''} |"
                     if names else f"| {link(id_, rule)} |  |  |  |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="GAPCHECK")
    parser.add_argument("decks", metavar="DECKS", type=pathlib.Path)
    parser.add_argument("--small", action="store_true", help="two decks of data/ only, to test this script")
    arguments = parser.parse_args()
    text = PAGE.read_text()
    head, rest = text.split(BEGIN)
    _, tail = rest.split(END)
    rules = deck_rules(arguments.program)
    lines = model_tables(arguments.program, arguments.decks, SMALL if arguments.small else DECKS, rules)
    lines += ["", *all_decks_table(arguments.program, arguments.decks, rules)]
    counted = "\n".join(lines)
    PAGE.write_text(f"{head}{BEGIN}\n{counted}\n{END}{tail}")


if __name__ == "__main__":
    main()
