#!/usr/bin/env python3
"""Checks what scripts/make_site.py does before and after Sphinx: every page has a place in the contents, links to files lead to
copies of them, and links that lead nowhere are found.

usage: check_site.py ROOT
"""

import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(ROOT / "scripts"))
import make_site  # noqa: E402

TREE = re.compile(r"^```\{toctree\}\n(.*?)^```", re.M | re.S)
LEAST_PAGES = 150


def listed(source):
    """Pages that the contents list, as paths from the project's root; they may be listed once only."""
    for page in source.rglob("*.md"):
        for tree in TREE.findall(page.read_text(encoding="utf-8")):
            for entry in filter(None, (line for line in tree.splitlines() if not line.startswith(":"))):
                yield make_site.rooted(page.relative_to(source), entry)


def check_contents(folder):
    source = folder / "source"
    source.mkdir()
    make_site.collect(source)
    make_site.add_contents(source)
    entries = [entry for entry in listed(source) if not entry.startswith("docs/reference/")]
    assert len(entries) == len(set(entries)), sorted(entry for entry in entries if entries.count(entry) > 1)
    pages = {str(path.relative_to(source)) for path in source.rglob("*.md") if path.parts[-2] != "data"} - {"docs/index.md"}
    assert pages == set(entries), f"without a place, or without a page: {sorted(pages ^ set(entries))}"
    assert len(pages) > LEAST_PAGES, len(pages)
    files = [link for page in source.rglob("*.md") for link in make_site.LINK.findall(page.read_text(encoding="utf-8"))
             if "/files/" in f"/{link[0]}"]
    assert len(files) > 5, "links to files of the project"
    assert "](../files/examples/audit_deck.cpp)" in (source / "docs/api.md").read_text(encoding="utf-8")
    assert (source / "files/examples/audit_deck.cpp").exists()
    return len(pages)


def check_faults(folder):
    """A site with one fault of each kind, beside links that are right."""
    site = folder / "site"
    (site / "sub").mkdir(parents=True)
    (site / "style.css").write_text("")
    (site / "a b.html").write_text('<link href="style.css"><h1 id="top"></h1><a href="#top"></a><a href="sub/c.html#x"></a>'
                                   '<a href="https://example.com"></a><a href="mailto:a@example.com"></a>')
    (site / "sub/c.html").write_text('<p id="x"></p><a href="../a%20b.html?q=1#top"></a>')
    assert list(make_site.faults(site)) == []
    (site / "sub/d.html").write_text('<script src="https://cdn.example.com/x.js"></script><img src="none.png"><a href="e.html"></a>'
                                     '<a href="c.html#y"></a><a href="#z"></a>')
    assert list(make_site.faults(site)) == [
        "sub/d.html: loads https://cdn.example.com/x.js", "sub/d.html: e.html leads nowhere",
        "sub/d.html: c.html#y: the page has no such anchor", "sub/d.html: #z: the page has no such anchor",
        "sub/d.html: none.png leads nowhere"]


def main():
    with tempfile.TemporaryDirectory() as name:
        pages = check_contents(pathlib.Path(name))
        check_faults(pathlib.Path(name))
    print(f"{pages} pages, each with a place in the contents")


if __name__ == "__main__":
    main()
