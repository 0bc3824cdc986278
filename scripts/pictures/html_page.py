#!/usr/bin/env python3
"""Makes the pictures of docs/html.md and docs/tutorial.md: pages of example decks, and of real ones where a folder of them is given.

usage: html_page.py GAPCHECK [DECKS]
"""

import json
import pathlib
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(root / "tests" / "apps"))
from chromium import Browser, program  # noqa: E402

# Name of the picture, deck, dark, width, height, rule of the finding whose picture alone is
# kept ("": the page as it opens).
EXAMPLES = [
    ("html_light", "two_plates_tilted.k", False, 1200, 800, ""),
    ("html_dark", "solid_on_solid.k", True, 700, 900, ""),
    ("tutorial", "tutorial/bumper.k", False, 1200, 800, ""),
]
REAL = [
    ("html_car6_released", "car6/car6_crash.k", False, 1200, 800, ""),
    ("html_refined_released", "car6_refined/lsopt_car6/car6_crash_v22.k", True, 1100, 760, "GC102"),
    ("html_car6_narrow", "car6/car6_crash.k", False, 700, 900, "GC111"),
    ("html_refined_sliver", "car6_refined/lsopt_car6/car6_crash_v22.k", False, 1100, 760, "GC506"),
    ("html_bird_corner", "bird_strike_composite/input.k", True, 1100, 760, "GC512"),
    ("html_column_corner", "crush_column/00final_run.key", False, 1100, 760, "GC512"),
]


def choose(browser, rule):
    """Selects the first finding of a rule."""
    data = json.loads(browser.value("document.getElementById('data').textContent"))
    findings = data["findings"]
    for i, text in enumerate(findings["id"]):
        if data["texts"][text] == rule:
            browser.value(f"location.hash = '#f{findings['number'][i]}'")
            return
    raise SystemExit(f"{rule} is not in the page")


def draw(program_path, name, deck, dark, width, height, rule):
    with tempfile.TemporaryDirectory() as folder, Browser(width, height, dark) as browser:
        page = pathlib.Path(folder) / "page.html"
        subprocess.run([program_path, "audit", "--quiet", "--fail-on", "never", "--html", page, deck.name],
                       cwd=deck.parent, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        browser.open(page)
        browser.settle()
        if rule:
            choose(browser, rule)
            browser.settle()
        path = root / "docs" / "pictures" / f"{name}.png"
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(browser.picture(".picture" if rule else None))
        print(f"{path.relative_to(root)}: {path.stat().st_size // 1000} kB")


def main():
    if program() is None:
        raise SystemExit("Chromium is not installed")
    gapcheck = pathlib.Path(sys.argv[1]).resolve()
    folders = [(root / "data", EXAMPLES)] + [(pathlib.Path(path).resolve(), REAL) for path in sys.argv[2:]]
    for folder, pictures in folders:
        for name, deck, *rest in pictures:
            draw(gapcheck, name, folder / deck, *rest)


if __name__ == "__main__":
    main()
