"""Every deck gives what the program gives."""
import json
import subprocess

from conftest import DATA, ROOT

import gapcheck


def timeless(report):
    return {name: value for name, value in report.items() if name != "timing"}


def test_every_deck_gives_what_the_program_gives(program, monkeypatch):
    monkeypatch.chdir(ROOT)
    decks = sorted(str(path.relative_to(ROOT)) for path in DATA.rglob("*.k"))
    done = subprocess.run([program, "audit", "--format", "json", "--fail-on", "never", *decks], capture_output=True)
    audited = json.loads(done.stdout)["decks"]
    penetrations = ties = 0
    for expected in audited:
        deck = expected["input"]
        report = gapcheck.audit(deck)
        assert timeless(json.loads(report.to_json())) == timeless(expected), deck
        totals, summary = report.totals, expected["summary"]
        assert (totals.errors, totals.warnings, totals.notes) == \
            tuple(summary[name] for name in ("errors", "warnings", "notes")), deck
        found = report.penetrations
        rules = set(gapcheck._core.names["kind_rule"])
        listed = [entry for entry in expected["findings"] if entry["id"] in rules]
        assert list(zip(found.words("rule"), found.contact_id, found.node, found.depth)) == \
            [(entry["id"], entry["contact"], entry["node"], entry["penetration"]) for entry in listed], deck
        assert found.line.tolist() == [entry["line"] for entry in listed], deck
        untied = [entry for entry in expected["findings"] if entry["id"] in set(gapcheck._core.names["reason_rule"])]
        assert list(zip(report.ties.words("rule"), report.ties.node)) == \
            [(entry["id"], entry["node"]) for entry in untied], deck
        penetrations, ties = penetrations + len(found), ties + len(report.ties)
    assert len(audited) > 100 and penetrations > 500 and ties > 10
