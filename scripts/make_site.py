#!/usr/bin/env python3
"""Builds the documentation as one site in HTML: the pages of docs/, the rules, the C++ interface from its headers, the Python
package from its docstrings, the notebooks with their outputs. It has a search, and works from files without a network.

usage: make_site.py [--build BUILD] [--output FOLDER]
Needs the packages of scripts/site/packages.txt, and BUILD with the Python package (-DGAPCHECK_PYTHON=ON). Exit code 1 if
Sphinx warns of anything, if a link of the site leads nowhere, if a page loads something from the network, or if the search,
tried in Chromium where that is installed, does not find what it must.
"""

import argparse
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
from urllib.parse import unquote, urldefrag
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOP_PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
PUBLIC_HEADERS = "lib/api/gapcheck"
DOXYGEN = """
INPUT = {headers}
OUTPUT_DIRECTORY = {output}
STRIP_FROM_PATH = {headers}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
JAVADOC_AUTOBRIEF = YES
EXTRACT_ALL = YES
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
"""
SEARCHES = {"audit_arrays": "docs/reference/python.html#gapcheck.audit_arrays", "released": "docs/rules/released-node.html"}
LINK = re.compile(r"\]\(([^)#\s]+)(#[^)\s]*)?\)")


def rooted(page, link):
    """Where a link of a page leads, from the project's root; None if it leads out of the project."""
    target = os.path.normpath(page.parent / unquote(link))
    return None if re.match(r"[a-z]+:", link) or target.startswith("..") else target


def collect(source):
    """The pages, the notebooks, what both need, and the files that pages refer to, laid out as in the project."""
    for folder in ("docs", "examples", "data"):
        shutil.copytree(ROOT / folder, source / folder)
    for name in TOP_PAGES:
        shutil.copy(ROOT / name, source / name)
    for path in sorted(source.rglob("*.md")):
        page = path.relative_to(source)
        if page.parts[0] == "data":
            continue
        text = path.read_text(encoding="utf-8")
        path.write_text(LINK.sub(lambda match: site_link(source, page, match), text), encoding="utf-8")


def site_link(source, page, match):
    """A link of a page as the site has it: files that are not pages become downloads, folders their names."""
    target = rooted(page, match[1])
    if target is None or target.endswith((".md", ".ipynb", ".png", ".svg")):
        return match[0]
    if (ROOT / target).is_dir():
        return "]"
    copy = source / "files" / target
    copy.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(ROOT / target, copy)
    return f"]({os.path.relpath(copy, (source / page).parent)})"


def toctree(caption, pages):
    """A list of pages that only the contents show; the caption may be empty."""
    return "\n".join(["", "```{toctree}", ":hidden:", *([f":caption: {caption}"] if caption else []), "", *pages, "```", ""])


def add_contents(source):
    """The pages that docs/index.md lists, as the contents beside every page."""
    index = source / "docs/index.md"
    text = index.read_text(encoding="utf-8")
    pages = [name for name in re.findall(r"^\| (?:GC\d+ \| )?\[[^\]]*\]\(([^)#]+\.md)\)", text, re.M)]
    about = ["../CONTRIBUTING.md", "../CHANGELOG.md", "../README.md", "architecture.md"]
    groups = {"Manual": [page for page in pages if not page.startswith(("theory/", "rules/", "../")) and page not in about],
              "Reference": ["reference/cpp.md", "reference/python.md", "reference/notebooks.md"],
              "Rules": [page for page in pages if page.startswith("rules/")],
              "Theory": [page for page in pages if page.startswith("theory/")], "Project": about}
    index.write_text(text + "".join(toctree(*group) for group in groups.items()), encoding="utf-8")
    for parent, pattern in (("workshop/index.md", "*.md"), ("theory/solver-benchmarks.md", "benchmarks/*.md")):
        page = source / "docs" / parent
        names = [path.relative_to(page.parent).as_posix() for path in sorted(page.parent.glob(pattern)) if path != page]
        page.write_text(page.read_text(encoding="utf-8") + toctree("", names), encoding="utf-8")


def entities(xml):
    """What each header declares, as directives of breathe: classes and structs, then enumerations, types, functions."""
    found = {}
    for file in sorted(xml.glob("*_8hpp.xml")):
        compound = ElementTree.parse(file).getroot().find("compounddef")
        classes = {entry.text: entry.get("refid").startswith("struct") for entry in compound.findall("innerclass")}
        found[compound.findtext("compoundname")] = [
            (f"doxygen{'struct' if is_struct else 'class'}", name, ":members:") for name, is_struct in classes.items()
            if name.rpartition("::")[0] not in classes]
    members = ElementTree.parse(xml / "namespacegapcheck_1_1api.xml").getroot().findall(".//memberdef")
    names = [member.findtext("name") for member in members]
    for kind in ("enum", "typedef", "variable", "function"):
        for member in (member for member in members if member.get("kind") == kind):
            name = member.findtext("name")
            overloaded = member.findtext("argsstring") if kind == "function" and names.count(name) > 1 else ""
            header = pathlib.Path(member.find("location").get("file")).name
            found[header].append((f"doxygen{kind}", f"gapcheck::api::{name}{overloaded}", ""))
    return {header: listed for header, listed in found.items() if listed}


def add_reference(source, xml):
    """Pages of the C++ and Python interfaces and of the notebooks, and what Doxygen says about the headers."""
    folder = source / "docs/reference"
    folder.mkdir()
    subprocess.run(["doxygen", "-"], input=DOXYGEN.format(headers=ROOT / PUBLIC_HEADERS, output=xml.parent), text=True, check=True)
    cpp = "# C++ reference\n\nThe public headers; [the C++ interface](../api.md) says what holds for all of them.\n"
    for header, listed in entities(xml).items():
        cpp += f"\n## gapcheck/{header}\n"
        for directive, name, options in listed:
            cpp += f"\n```{{{directive}}} {name}\n{options}\n```\n"
    (folder / "cpp.md").write_text(cpp, encoding="utf-8")
    (folder / "python.md").write_text(
        "# Python reference\n\nThe package `gapcheck`; [Python](../python.md) is the introduction.\n\n```{eval-rst}\n"
        ".. automodule:: gapcheck\n   :members:\n   :imported-members:\n   :inherited-members: tuple, int, object\n```\n", encoding="utf-8")
    notebooks = "\n".join(f"/{path.relative_to(ROOT)}" for path in sorted((ROOT / "examples").glob("*.ipynb")))
    (folder / "notebooks.md").write_text(
        f"# Notebooks\n\nRun when the site was built.\n\n```{{toctree}}\n{notebooks}\n```\n", encoding="utf-8")


class Links(html.parser.HTMLParser):
    """The links, the loaded files and the anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(filter(None, (values.get("id"), values.get("name"))))
        for name in ("href", "src"):
            if values.get(name):
                (self.links if tag == "a" else self.loaded).append(values[name])


def faults(site):
    """Links of the site that lead nowhere, and files that it loads from elsewhere."""
    pages = {path: Links(path) for path in sorted(site.rglob("*.html"))}
    for path, page in pages.items():
        name = path.relative_to(site)
        for link in page.loaded:
            if re.match(r"(https?:)?//", link):
                yield f"{name}: loads {link}"
        for link in page.links + page.loaded:
            address, anchor = urldefrag(link)
            if re.match(r"[a-z]+:|//", address):
                continue
            target = pathlib.Path(os.path.normpath(path.parent / unquote(address.split("?")[0]))) if address else path
            if not target.exists():
                yield f"{name}: {link} leads nowhere"
            elif anchor and target in pages and unquote(anchor) not in pages[target].anchors:
                yield f"{name}: {link}: the page has no such anchor"


def search_faults(site):
    """Searches that do not find their page, in a browser that reads the site from files."""
    chromium = shutil.which("chromium")
    if chromium is None:
        print("the search was not tried: Chromium is not installed")
        return
    for words, page in SEARCHES.items():
        shown = subprocess.run([chromium, "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=8000", "--dump-dom",
                                f"file://{site}/search.html?q={words}"], capture_output=True, text=True, timeout=120).stdout
        if f'<a href="{page}"' not in shown:
            yield f"search.html: {words} does not lead to {page}"


def build(source, site, xml, python):
    """Sphinx; what it warns of."""
    environment = {**os.environ, "PYTHONPATH": str(python), "GAPCHECK_XML": str(xml), "PYTHONDONTWRITEBYTECODE": "1",
                   "PYDEVD_DISABLE_FILE_VALIDATION": "1"}
    warnings = source.parent / "warnings"
    subprocess.run(["/usr/bin/python3", "-m", "sphinx", "-q", "-b", "html", "-j", "2", "-d", source.parent / "doctrees", "-w", warnings,
                    source, site], env=environment, check=True)
    return warnings.read_text(encoding="utf-8").splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/site")
    arguments = parser.parse_args()
    python = arguments.build.resolve() / "python"
    if not list(python.glob("gapcheck/_core*")):
        sys.exit(f"{python} has no Python package; build it with -DGAPCHECK_PYTHON=ON")
    work = arguments.output.resolve().with_name(arguments.output.name + "-work")
    for folder in (work, arguments.output):
        shutil.rmtree(folder, ignore_errors=True)
    source, xml = work / "source", work / "xml"
    source.mkdir(parents=True)
    collect(source)
    add_contents(source)
    add_reference(source, xml)
    shutil.copy(ROOT / "scripts/site/conf.py", source)
    problems = build(source, arguments.output.resolve(), xml, python)
    (arguments.output / "index.html").write_text(
        '<!doctype html>\n<meta charset="utf-8">\n<title>gapcheck</title>\n<meta http-equiv="refresh" content="0; url=docs/index.html">\n'
        '<a href="docs/index.html">gapcheck</a>\n')
    problems += [*faults(arguments.output.resolve()), *search_faults(arguments.output.resolve())]
    for problem in problems:
        print(problem)
    pages = len(list(arguments.output.rglob("*.html")))
    print(f"{arguments.output}/index.html: {pages} pages, {len(problems) or 'no'} faults")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
