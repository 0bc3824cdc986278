#!/usr/bin/env python3
"""Checks that references resolve.

    check_references.py ROOT
    check_references.py --self-test

In comments of lib/, apps/ and tests/ (*.hpp, *.cpp): "contact rules, section N" names a numbered heading of
docs/theory/contact-rules.md, and a page (docs/theory/search.md, search.md) or folder of docs/ exists. Messages in string
literals of lib/ and apps/ name pages of docs/ that exist. Relative links of docs/**/*.md and of the pages at the top name
files and headings that exist. Prints a line for each dangling reference; exit code 1 if there is any, or if the comments
name the contact rules so rarely that this program must have missed them.
"""

import bisect
import contextlib
import io
import re
import sys
import tempfile
from pathlib import Path
from urllib.parse import unquote

RULES_PAGE = "docs/theory/contact-rules.md"
LEAST_RULES = 20  # references to the contact rules: fewer mean that they are no longer recognised

# Comments, string literals, and what could be mistaken for the begin of one: character literals and 1'000.
CPP_TOKEN = re.compile(
    r"""(?P<line>//[^\n]*)
      | (?P<block>/\*.*?\*/)
      | R"(?P<delimiter>[^()\\\s]{0,16})\(.*?\)(?P=delimiter)"
      | (?P<string>"(?:\\.|[^"\\\n])*")
      | '(?:\\.|[^'\\\n])+'
      | (?<!\w)\d(?:'?[\w.])*""",
    re.S | re.X,
)
NUMBER = r"\d+(?:\.\d+)*"
RULES = re.compile(
    r"\bcontact[ _-]rules\b(?!\.md)(?P<place>\s*,?\s*(?:sections?\s+)?"
    rf"(?P<list>{NUMBER}(?:\s*(?:,\s*and|,|and|or|to|–)\s*{NUMBER})*))?",
    re.I,
)
PAGE = re.compile(r"(?<![\w/<>*.{-])(?P<path>(?:[\w.<>*{}-]+/)*[\w<>*{}-][\w.<>*{}-]*\.md)\b(?:#(?P<anchor>[\w-]+))?")
FOLDER = re.compile(r"(?<![\w/])docs(?:/[\w-]+)+/?(?![\w/-]*(?:\.\w|[<*{]))")
PLACEHOLDER = re.compile(r"[<>*{}]")
LINK = re.compile(
    r"\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(\s*(?P<target><[^>]*>|[^\s()]*(?:\([^\s()]*\)[^\s()]*)*)(?:\s+\"[^\"]*\")?\s*\)"
)
DEFINITION = re.compile(r"^ {0,3}\[[^\]]+\]:\s*(?P<target>\S+)", re.M)
HTML_LINK = re.compile(r"<(?:a|img)\b[^>]*?\b(?:href|src)=[\"'](?P<target>[^\"']*)[\"']")
HTML_ANCHOR = re.compile(r"<\w+\b[^>]*?\b(?:id|name)=[\"']([^\"']+)[\"']")
HEADING = re.compile(r"^ {0,3}#{1,6}\s+(?P<title>.*?)\s*#*\s*$")
SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:|//")


class Text:
    """A text that keeps the line of each character, also where lines were joined."""

    def __init__(self):
        self.text = ""
        self.starts, self.lines = [], []

    def add(self, piece, line):
        for number, part in enumerate(piece.split("\n")):
            if self.text:
                self.text += " "
            self.starts.append(len(self.text))
            self.lines.append(line + number)
            self.text += part

    def line(self, offset):
        return self.lines[bisect.bisect_right(self.starts, offset) - 1]


def without_marks(comment):
    if comment.startswith("/*"):
        return "\n".join(re.sub(r"^\s*(?:/\*+|\*(?!/))?\s?|\*/$", "", part) for part in comment.split("\n"))
    return re.sub(r"^//[/!]?<?\s?", "", comment)


def comments_and_strings(source):
    """(comments, strings): comments that follow one another without code between are one Text."""
    comments, strings = [], []
    end, line, counted = -1, 1, 0
    for token in CPP_TOKEN.finditer(source):
        line += source.count("\n", counted, token.start())
        counted = token.start()
        comment = token["line"] or token["block"]
        if comment:
            if not comments or end < 0 or source[end : token.start()].strip():
                comments.append(Text())
            comments[-1].add(without_marks(comment), line)
            end = token.end()
        elif token["string"]:
            string = Text()
            string.add(token["string"], line)
            strings.append(string)
    return comments, strings


def blanked(match):
    return re.sub(r"[^\n]", " ", match.group())


def without_code(markdown):
    """The page with its code blanked out, so that lines and columns stay."""
    lines, fence, indented, in_list, after_blank = [], "", False, False, True
    for line in markdown.split("\n"):
        mark = re.match(r"\s*(`{3,}|~{3,})", line)
        if fence:
            if mark and mark[1].startswith(fence):
                fence = ""
            line = ""
        elif mark:
            fence, line = mark[1], ""
        elif not line.strip():
            after_blank = True
            lines.append(line)
            continue
        else:
            deep = line.startswith(("    ", "\t"))
            indented = deep and not in_list and (indented or after_blank)
            if not deep:
                item = bool(re.match(r"\s*(?:[-*+]|\d+[.)])\s", line))
                in_list = item or (in_list and (not after_blank or line.startswith("  ")))
            if indented:
                line = ""
        after_blank = False
        lines.append(line)
    return re.sub(r"(?<!`)(`+)(?!`)(?:(?!\n\s*\n).)+?(?<!`)\1(?!`)", blanked, "\n".join(lines), flags=re.S)


def titles(markdown):
    fence = ""
    for line in markdown.split("\n"):
        mark = re.match(r"\s*(`{3,}|~{3,})", line)
        if mark and (not fence or mark[1].startswith(fence)):
            fence = "" if fence else mark[1]
        elif not fence and (heading := HEADING.match(line)):
            yield heading["title"]


def anchors(markdown):
    """The anchors that GitHub makes of headings, and those that the page sets itself."""
    found, count = set(HTML_ANCHOR.findall(markdown)), {}
    for title in titles(markdown):
        title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title)
        slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        number = count[slug] = count.get(slug, -1) + 1
        found.add(f"{slug}-{number}" if number else slug)
    return found


def sections(markdown):
    """Numbers of the numbered headings: "7" of "## 7. Release", "7.1" of "### 7.1 Depth"."""
    return {match[1] for title in titles(markdown) if (match := re.match(rf"({NUMBER})\.?\s", title))}


class Checker:
    def __init__(self, root):
        self.root = root
        self.references = self.rules = 0
        self.dangling = []
        page = root / RULES_PAGE
        self.sections = sections(page.read_text(encoding="utf-8")) if page.is_file() else set()
        self.pages = sorted(root.glob("*.md")) + sorted((root / "docs").rglob("*.md"))
        self.page_names = {path.name for path in self.pages}
        self.anchors = {}

    def report(self, path, line, message):
        self.dangling.append(f"{path.relative_to(self.root)}:{line}: {message}")

    def has_anchor(self, page, anchor):
        if page not in self.anchors:
            self.anchors[page] = anchors(page.read_text(encoding="utf-8"))
        return anchor in self.anchors[page]

    def check_rules(self, path, text, must_have_place):
        """The sections of the contact rules that a text names."""
        for match in RULES.finditer(text.text):
            line = text.line(match.start())
            if not match["place"]:
                if must_have_place:
                    self.references += 1
                    self.report(path, line, f"'{match[0]}' names no section: write 'contact rules, section N'")
                continue
            self.references += 1
            self.rules += must_have_place
            for number in re.findall(NUMBER, match["list"]):
                if number not in self.sections:
                    self.report(path, line, f"contact rules, section {number}: {RULES_PAGE} has no such heading")

    def check_pages(self, path, text, full_paths_only):
        """The pages and folders of docs/ that a text names."""
        for match in PAGE.finditer(text.text):
            name, anchor = match["path"], match["anchor"]
            if PLACEHOLDER.search(name) or (full_paths_only and not name.startswith("docs/")):
                continue
            self.references += 1
            line = text.line(match.start())
            page = next((p for p in (self.root / name, self.root / "docs" / name) if p.is_file()), None)
            if page is None and ("/" in name or name not in self.page_names):
                self.report(path, line, f"there is no page {name}")
            elif page is not None and anchor and not self.has_anchor(page, anchor):
                self.report(path, line, f"{name} has no heading #{anchor}")
        for match in () if full_paths_only else FOLDER.finditer(text.text):
            self.references += 1
            if not (self.root / match[0]).exists():
                self.report(path, text.line(match.start()), f"there is no {match[0]}")

    def check_source(self, path):
        comments, strings = comments_and_strings(path.read_text(encoding="utf-8"))
        for comment in comments:
            self.check_rules(path, comment, must_have_place=True)
            self.check_pages(path, comment, full_paths_only=False)
        if path.relative_to(self.root).parts[0] != "tests":
            for string in strings:
                self.check_pages(path, string, full_paths_only=True)

    def check_link(self, path, line, target):
        target = target.strip("<>")
        if not target or SCHEME.match(target):
            return
        self.references += 1
        name, _, anchor = target.partition("#")
        file = path.parent / unquote(name) if name else path
        if name.startswith("/"):
            self.report(path, line, f"{target} is not relative to the page")
        elif not file.exists():
            self.report(path, line, f"there is no {name}")
        elif anchor and file.is_dir():
            self.report(path, line, f"{name} is a folder and has no heading #{anchor}")
        elif anchor and file.suffix == ".md" and not self.has_anchor(file, unquote(anchor)):
            self.report(path, line, f"{name or 'this page'} has no heading #{anchor}")

    def check_page(self, path):
        markdown = path.read_text(encoding="utf-8")
        prose = without_code(markdown)
        found = [match for pattern in (LINK, DEFINITION, HTML_LINK) for match in pattern.finditer(prose)]
        for match in sorted(found, key=lambda m: m.start()):
            self.check_link(path, prose.count("\n", 0, match.start("target")) + 1, match["target"])
        text = Text()
        text.add(markdown, 1)
        self.check_rules(path, text, must_have_place=False)

    def run(self):
        for folder in ("lib", "apps", "tests"):
            for path in sorted((self.root / folder).rglob("*")):
                if path.suffix in (".hpp", ".cpp") and path.is_file():
                    self.check_source(path)
        for path in self.pages:
            self.check_page(path)


def check(root, least_rules=LEAST_RULES):
    """The exit code; prints what dangles."""
    checker = Checker(Path(root).resolve())
    checker.run()
    for message in checker.dangling:
        print(message)
    few = checker.rules < least_rules
    if few:
        print(f"only {checker.rules} comments name a section of the contact rules, expected at least {least_rules}")
    result = f"{len(checker.dangling)} dangling" if checker.dangling else "all resolve"
    print(f"{checker.references} references, {result}")
    return 1 if checker.dangling or few else 0


# --- self-test ---------------------------------------------------------------------------------------------------

SOUND = {
    RULES_PAGE: "# Contact rules\n\n## 1. Types\n\n### 1.1 Words\n\n```\n## 8. In a block\n```\n\n## 4. Contact thickness\n\n"
    "## 7. `IGNORE` & SNLOG\n\n## 7. `IGNORE` & SNLOG\n\nBy contact rules,\nsection 4.\n",
    "docs/index.md": "# Index\n\n[rules](theory/contact-rules.md), [thickness](theory/contact-rules.md#4-contact-thickness),\n"
    "[second](theory/contact-rules.md#7-ignore--snlog-1), [here](#index), [folder](theory/), [web](https://example.org/no.md),\n"
    "[a\nlong one](theory/contact-rules.md), ![picture](a%20b.svg), `[code](no.md)`\n\n    [code](no.md)\n\n"
    "```\n[code](no.md)\n```\n\n- item\n\n    [in the item](index.md)\n",
    "docs/a b.svg": "<svg/>\n",
    "README.md": "# Read me\n\n[manual](docs/index.md#index) <a href=\"docs/index.md\">again</a>\n",
    "lib/a.hpp": "/// Source: contact rules, section 4. See docs/index.md and docs/theory.\n"
    "int a = 1'000;  ///< contact rules, sections 1.1, 4 and 7; page docs/rules/<name>.md\n"
    "/* By contact\n * rules, section 7 */\n"
    "const char* text = \"contact rules, section 99 // see docs/index.md\";\n"
    "const char* raw = R\"(// contact rules, section 99)\";\n",
    "apps/b.cpp": "// index.md and theory/contact-rules.md#1-types, in the contact\n// rules, 4 as well\n",
    "tests/c.cpp": "const char* text = \"docs/no.md\";\n",
}
FAULTS = {
    "lib/a.hpp": "// fine: contact rules, section 4\n// but contact rules, section 5 and the contact\n// rules, section 1.2 are not there\nint a;  // contact rules 9\n"
    "int b;  // contact rules, sections 4 and 8\n// as in contact_rules: no place\n",
    "lib/b.cpp": "// docs/index.md\n// docs/gone.md, gone.md, docs/gone/\nint a = 1'000;  // docs/index.md#gone\n"
    "const char* text = \"see docs/gone.md\";\n",
    "docs/page.md": "# Page\n\n[good](index.md)\n[gone](gone.md) and [gone too](../gone.svg)\n\n- [heading](index.md#gone)\n- [here](#gone)\n\n"
    "[absolute](/docs/index.md) [folder](theory#gone)\n\nBy contact rules, section 3.\n\n<img src='gone.png'>\n\n[defined]: gone.md\n",
    "README.md": "[gone](docs/gone.md)\n",
}
REPORTS = [
    "lib/a.hpp:2: contact rules, section 5: docs/theory/contact-rules.md has no such heading",
    "lib/a.hpp:2: contact rules, section 1.2: docs/theory/contact-rules.md has no such heading",
    "lib/a.hpp:4: contact rules, section 9: docs/theory/contact-rules.md has no such heading",
    "lib/a.hpp:5: contact rules, section 8: docs/theory/contact-rules.md has no such heading",
    "lib/a.hpp:6: 'contact_rules' names no section: write 'contact rules, section N'",
    "lib/b.cpp:2: there is no page docs/gone.md",
    "lib/b.cpp:2: there is no page gone.md",
    "lib/b.cpp:2: there is no docs/gone/",
    "lib/b.cpp:3: docs/index.md has no heading #gone",
    "lib/b.cpp:4: there is no page docs/gone.md",
    "README.md:1: there is no docs/gone.md",
    "docs/page.md:4: there is no gone.md",
    "docs/page.md:4: there is no ../gone.svg",
    "docs/page.md:6: index.md has no heading #gone",
    "docs/page.md:7: this page has no heading #gone",
    "docs/page.md:9: /docs/index.md is not relative to the page",
    "docs/page.md:9: theory is a folder and has no heading #gone",
    "docs/page.md:13: there is no gone.png",
    "docs/page.md:15: there is no gone.md",
    "docs/page.md:11: contact rules, section 3: docs/theory/contact-rules.md has no such heading",
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
    expected = {
        "a sound tree": ((0, ["20 references, all resolve"]), outcome(SOUND, 4)),
        "too few references": (
            (1, ["only 4 comments name a section of the contact rules, expected at least 20", "20 references, all resolve"]),
            outcome(SOUND),
        ),
        "dangling references": ((1, REPORTS + ["35 references, 20 dangling"]), outcome({**SOUND, **FAULTS}, 4)),
    }
    wrong = {name: pair for name, pair in expected.items() if pair[0] != pair[1]}
    for name, (wanted, got) in wrong.items():
        print(f"{name}: exit code {got[0]}, expected {wanted[0]}")
        for line in wanted[1]:
            if line not in got[1]:
                print(f"  missing:    {line}")
        for line in got[1]:
            if line not in wanted[1]:
                print(f"  unexpected: {line}")
        if sorted(got[1]) == sorted(wanted[1]):
            print("  the lines are in another order")
    print(f"self-test: {len(expected) - len(wrong)} of {len(expected)} cases as expected")
    return 1 if wrong else 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print("usage: check_references.py ROOT | --self-test", file=sys.stderr)
        return 2
    return check(arguments[0])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
