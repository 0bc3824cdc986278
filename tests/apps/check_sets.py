#!/usr/bin/env python3
"""Reads what gapcheck audit --sets writes by the card layouts of a public keyword library and holds it against the
findings of the same audit; then audits each deck with its sets included: nothing may change.

usage: check_sets.py GAPCHECK ROOT CARDS    CARDS: cards.json with the layouts
"""

import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile


class Layouts:
    """Field widths of a keyword's cards, in standard or long format."""

    def __init__(self, path):
        cards = json.loads(pathlib.Path(path).read_text())
        self.fields, self.keywords = cards["fieldsets"], {entry["keyword"]: entry for entry in cards["keywords"]}

    def cards(self, keyword):
        entry = self.keywords[keyword]
        return {card["name"]: self.fields[card["fields"]] for card in entry["cards"]}

    def title_width(self, keyword):
        return self.cards(keyword)["TITLE"][0]["width"]

    def row(self, keyword, card, line, long):
        """The whole numbers of a line; a character that no field has raises."""
        numbers, column = [], 0
        for field in self.cards(keyword)[card]:
            for _ in range(field.get("count", 1)):
                width = max(20, field["width"]) if long else field["width"]
                assert long or field["col"] <= column, field
                text = line[column:column + width].strip()
                if field["type"] == "int" and text:
                    numbers.append(int(text))
                else:
                    assert not text, (keyword, card, line)
                column += width
        assert not line[column:].strip(), (keyword, card, line)
        return numbers


def read_sets(text, layouts):
    """Lists of (keyword, title, id, rows) as the layouts have them."""
    lines = [line for line in text.splitlines() if not line.startswith("$")]
    assert lines[0] in ("*KEYWORD LONG=S", "*KEYWORD LONG=Y") and lines[-1] == "*END"
    long, sets = lines[0].endswith("Y"), []
    starts = [i for i, line in enumerate(lines) if line.startswith("*SET")] + [len(lines) - 1]
    for begin, end in zip(starts, starts[1:]):
        assert lines[begin].endswith("_TITLE")
        keyword = lines[begin][1:].removesuffix("_TITLE")
        title = lines[begin + 1]
        assert len(title.encode()) <= layouts.title_width(keyword), title
        number, = layouts.row(keyword, "card1", lines[begin + 2], long)
        rows = [layouts.row(keyword, "card2", line, long) for line in lines[begin + 3:end]]
        assert rows and all(rows), title
        sets.append((keyword, title, number, rows))
    return sets


class Checker:
    def __init__(self, gapcheck, root, layouts, folder):
        self.gapcheck, self.root, self.layouts, self.folder = gapcheck, root, layouts, folder

    def audit(self, deck, *options):
        run = subprocess.run([self.gapcheck, "audit", str(deck), *map(str, options)], capture_output=True,
                             cwd=self.root)
        assert run.returncode in (0, 1), f"{deck}: exit {run.returncode}: {run.stderr.decode()}"
        return run.stdout.decode()

    def findings(self, deck):
        return list(csv.DictReader(io.StringIO(self.audit(deck, "--format", "csv"), newline="")))

    def check(self, deck):
        path = self.folder / "sets.k"
        self.audit(deck, "--quiet", "--sets", path)
        sets = read_sets(path.read_text(), self.layouts)
        rows = self.findings(deck)
        expected = {}
        for row in rows:
            if row["node"]:
                expected.setdefault((row["id"], row["contact"]), set()).add(int(row["node"]))
        found = {}
        for keyword, title, number, members in sets:
            rule, contact = re.match(r"(GC\d+) [a-z0-9-]+(?: contact (\d+))?: \d+ (?:node|segment)s?", title).groups()
            if keyword == "SET_NODE_LIST":
                nodes = [node for row in members for node in row]
                assert nodes == sorted(set(nodes)) and all(len(row) == 8 for row in members[:-1]), title
                assert f": {len(nodes)} node" in title, title
                found[rule, contact or ""] = set(nodes)
            else:
                assert all(len(row) == 4 for row in members) and f": {len(members)} segment" in title, title
        for key, nodes in expected.items():
            assert nodes <= found[key], (deck.name, key, nodes, found[key])
            if key[0] in ("GC101", "GC102", "GC106", "GC201"):
                assert nodes == found[key], (deck.name, key)
        taken = set(self.set_ids(deck))
        assert not taken & {number for _, _, number, _ in sets}, f"{deck.name}: ids of the deck's own sets"
        both = self.folder / "both.k"
        both.write_text(f"*KEYWORD\n*INCLUDE\n{deck}\n*INCLUDE\n{path}\n*END\n")
        same = [[row[key] for key in ("id", "contact", "node", "penetration")] for row in rows]
        again = [[row[key] for key in ("id", "contact", "node", "penetration")] for row in self.findings(both)]
        assert again == same, f"{deck.name}: the sets change the findings"
        return len(sets)

    @staticmethod
    def set_ids(deck):
        """First numbers behind the keyword lines of sets; titles are passed over."""
        lines = [line for line in deck.read_text().splitlines() if not line.startswith("$")]
        for i, line in enumerate(lines):
            if line.startswith("*SET_"):
                yield int(lines[i + 1 + line.endswith("_TITLE")][:10])


def main():
    gapcheck, root = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    layouts = Layouts(sys.argv[3])
    with tempfile.TemporaryDirectory() as folder:
        checker = Checker(gapcheck, root, layouts, pathlib.Path(folder))
        decks = sorted(root.glob("data/*.k"))
        count = sum(checker.check(deck) for deck in decks)
    assert len(decks) > 30 and count > 60, (len(decks), count)
    print(f"{count} sets of {len(decks)} decks, read by the layouts")


if __name__ == "__main__":
    main()
