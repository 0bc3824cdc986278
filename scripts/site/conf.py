"""Settings of Sphinx for the documentation site; scripts/make_site.py puts them beside the pages."""
import os
import re

project = "gapcheck"
root_doc = "docs/index"
html_title = "gapcheck"
extensions = ["myst_parser", "nbsphinx", "breathe", "sphinx.ext.autodoc"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["data", "xml"]
suppress_warnings = ["misc.highlighting_failure", "myst.header"]
highlight_language = "none"

myst_heading_anchors = 6  # as GitHub makes them

# Everything that a page needs is in the site, so that it works from files without a network.
html_theme = "furo"
html_static_path = []
html_show_sourcelink = html_copy_source = False
html_show_search_summary = False  # the summaries of results are fetched, which browsers refuse for files
nbsphinx_requirejs_path = ""
nbsphinx_execute = "always"

breathe_projects = {"gapcheck": os.environ["GAPCHECK_XML"]}
breathe_default_project = "gapcheck"
primary_domain = "cpp"
autodoc_member_order = "bysource"
autodoc_typehints = "signature"


def plain(text):
    """A text of a docstring, which is plain but for code between backticks, in reStructuredText."""
    pieces = text.split("`")
    return "``".join(re.sub(r"([*_|\\])", r"\\\1", piece) if i % 2 == 0 else piece for i, piece in enumerate(pieces))


def restructured(paragraph):
    """One paragraph of a docstring: code if all of it is indented, a list if its lines are "names: meaning"."""
    if all(line.startswith("    ") for line in paragraph):
        return ["::", "", *paragraph]
    text = [plain(line) for line in paragraph]
    if not re.match(r"[\w\\]+(, [\w\\]+)*: ", text[0]):
        return [line.strip() for line in text]
    return [f"  {line.strip()}" if line.startswith("    ") else f"- {line}" for line in text]


def process_docstring(app, what, name, thing, options, lines):
    paragraphs = [part.split("\n") for part in re.split(r"\n\s*\n", "\n".join(lines).strip("\n"))]
    lines[:] = [line for paragraph in paragraphs for line in [*restructured(paragraph), ""]]


def without_formulas(app, environment):
    """Notebooks are taken to have formulas, and would load MathJax from the network."""
    environment.get_domain("math").data["has_equations"].clear()


def setup(app):
    app.connect("env-updated", without_formulas)
    app.connect("autodoc-process-docstring", process_docstring)
