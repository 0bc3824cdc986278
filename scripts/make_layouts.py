#!/usr/bin/env python3
"""Turns a card description (JSON) into lib/keyword/layouts.txt.

Usage: make_layouts.py CARDS_JSON > lib/keyword/layouts.txt

The description lists, for every keyword, its cards and for every card its fields with start column, width, type and
what an id points to. The output is the same table as compact text; its syntax is explained in its first lines and
read by lib/keyword/layout.cpp. What the description leaves open or gets wrong is mended by hand in
lib/keyword/layout_corrections.txt, never in the output.
"""
import json
import sys

HEADER = """\
# Card layouts: names, columns, widths and types. Written by scripts/make_layouts.py; mend it in
# layout_corrections.txt, which has the same syntax and is read after this file.
#   fields ID name:column:width:type ...   a list of fields; type is int, real, text or what the number identifies:
#                                          node, element, part, material, set, function, define, other;
#                                          a fifth item *N repeats the field N times side by side
#   card KEYWORD name=ID ...               the cards of a keyword, in the order of reading
#   kind KEYWORDS name type                sets the type of that field in every card of the keywords read so far;
#                                          KEYWORDS may end in `*`, the name in `#` for any number
"""

TYPES = {"int": "int", "float": "real", "str": "text", "flag": "text"}


def kind(link):
    """The family of ids that a link names, or None."""
    if link is None:
        return None
    if link.startswith("DEFINE_"):
        return "function" if link.startswith(("DEFINE_CURVE", "DEFINE_TABLE", "DEFINE_FUNCTION")) else "define"
    for prefix, name in (("NODE", "node"), ("ELEMENT_", "element"), ("PART", "part"), ("MAT", "material"),
                         ("SET_", "set"), ("SECTION", "other"), ("HOURGLASS", "other")):
        if link.startswith(prefix):
            return name
    raise SystemExit(f"unknown link {link}: say in make_layouts.py which family of ids it belongs to")


def field_text(field):
    name = field["name"].lower().replace(" ", "_")
    assert ":" not in name, name
    type_name = TYPES[field["type"]]
    if type_name == "int":
        type_name = kind(field.get("link")) or "int"
    text = f'{name}:{field["col"]}:{field["width"]}:{type_name}'
    return text + f':*{field["count"]}' if "count" in field else text


def card_name(name):
    return name.replace(" ", "_").removeprefix("opt_")


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        table = json.load(file)
    ids, keyword_lines = {}, []
    for keyword in table["keywords"]:
        if " " in keyword["keyword"]:  # a remark, not a name that a deck can hold
            continue
        cards = []
        for card in keyword.get("cards", []):
            fields = " ".join(field_text(f) for f in sorted(table["fieldsets"][card["fields"]], key=lambda f: f["col"]))
            if fields:
                cards.append(f'{card_name(card["name"])}={ids.setdefault(fields, f"F{len(ids)}")}')
        keyword_lines.append(f'card {keyword["keyword"]} {" ".join(cards)}'.rstrip())
    print(HEADER, end="")
    for fields, name in ids.items():
        print("fields", name, fields)
    print("\n".join(sorted(keyword_lines)))


if __name__ == "__main__":
    main()
