#!/usr/bin/env python3
"""Checks that keywords and codes of contacts are text in one place only, lib/model/contact/contact_kind.cpp.

    check_contact_kinds.py ROOT       every other string of lib/ and apps/ that holds a keyword or compares a code
    check_contact_kinds.py --self-test

Prints FILE:LINE: what, exit code 1 if there is any. Sentences may name a kind of contact ("take a SINGLE_SURFACE type");
a keyword is a string without blanks that is a kind's name, or anything with CONTACT_ before a word.
"""
import pathlib
import re
import sys
import tempfile

TABLE = pathlib.PurePosixPath("lib/model/contact/contact_kind.cpp")
LEAST_KINDS = 60  # fewer mean that the table is no longer recognised
# Comments, literals (raw ones too) and everything else, one token after the other.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<tag>\w*)\((?P<raw>.*?)\)(?P=tag)"|"(?P<text>(?:\\.|[^"\\\n])*)"|\'(?:\\.|[^\'\\\n])+\'',
                   re.S)
KEYWORD = re.compile(r"(?<![A-Z_])CONTACT_[A-Z]")
COMPARED = re.compile(r"(?:==|!=|starts_with\(|ends_with\(|find\(|among\()\s*$")
CODE = re.compile(r"[abcimo]?\d{1,2}$")


def literals(source):
    for token in TOKEN.finditer(source):
        text = token.group("raw") if token.group("raw") is not None else token.group("text")
        if text is not None:
            yield token.start(), text


def kinds(root):
    table = (root / TABLE).read_text(encoding="utf-8")
    return {text for _, text in literals(table) if re.fullmatch(r"[A-Z]+(_[A-Z]+)+", text) and not text.startswith("_")}


def faults(root):
    names = kinds(root)
    # Names of cards and of plain words are no keywords of contacts.
    for folder in ("lib", "apps"):
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            place = path.relative_to(root)
            if str(place) in (str(TABLE), str(TABLE).replace(".cpp", ".hpp")):
                continue
            source = path.read_text(encoding="utf-8")
            for at, text in literals(source):
                line = source.count("\n", 0, at) + 1
                if text in names or KEYWORD.search(text):
                    yield f"{place}:{line}: the keyword \"{text}\" belongs into {TABLE}"
                elif CODE.match(text) and COMPARED.search(source[max(0, at - 40):at]) and re.search(
                        r"\b(code|type)\b[^;]{0,30}$", source[max(0, at - 60):at]):
                    yield f"{place}:{line}: the code \"{text}\" is compared as text; use model::ContactCode"


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / TABLE).parent.mkdir(parents=True)
        (root / "apps").mkdir()
        (root / TABLE).write_text('{"SINGLE_SURFACE", C::x}, {"TIED_NODES_TO_SURFACE", C::y}')
        (root / "lib/a.cpp").write_text(
            '// "SINGLE_SURFACE" in a comment\n'
            'say("take a SINGLE_SURFACE type");\n'
            'if (name == "SINGLE_SURFACE") f();\n'
            'if (keyword.starts_with("CONTACT_AUTOMATIC_")) f();\n'
            'if (type.code == "13") f();\n'
            'f("*CONTROL_CONTACT", "13", "PART_CONTACT");\n')
        found = [int(fault.split(":")[1]) for fault in faults(root)]
    if found != [3, 4, 5]:
        sys.exit(f"found faults in lines {found} instead of 3, 4, 5")
    print("1 passed, 0 failed")


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    root = pathlib.Path(sys.argv[1])
    names = kinds(root)
    if len(names) < LEAST_KINDS:
        sys.exit(f"only {len(names)} kinds of contact are recognised in {TABLE}")
    found = list(faults(root))
    print("\n".join(found + [f"{len(names)} kinds of contact, {len(found)} keywords or codes as text outside the table"]))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
