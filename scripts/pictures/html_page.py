#!/usr/bin/env python3
"""Makes the pictures of docs/html.md: pages of two example decks in Chromium.

usage: html_page.py GAPCHECK
"""

import pathlib
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(root / "tests" / "apps"))
from chromium import Browser, program  # noqa: E402

# Name of the picture, deck, whether it is dark, number of the row to click, magnification of the vectors.
PICTURES = [("html_light", "two_plates_tilted.k", False, 2, 1), ("html_dark", "solid_on_solid.k", True, 2, 2)]


def main():
    if program() is None:
        raise SystemExit("Chromium is not installed")
    for name, deck, dark, row, factor in PICTURES:
        with tempfile.TemporaryDirectory() as folder, Browser(1280, 960, dark) as browser:
            page = pathlib.Path(folder) / "page.html"
            subprocess.run([sys.argv[1], "audit", "--quiet", "--fail-on", "never", "--html", page, f"data/{deck}"],
                           cwd=root, check=True, stdout=subprocess.DEVNULL)
            browser.open(page)
            browser.settle()
            browser.click(f"#findings tr.choice[aria-rowindex='{row + 2}']")
            browser.value("(() => { const s = document.querySelector('#tools select'); "
                          f"s.value = '{factor}'; s.dispatchEvent(new Event('change')); scrollTo(0, 0); }})()")
            browser.settle()
            path = root / "docs" / "pictures" / f"{name}.png"
            path.parent.mkdir(exist_ok=True)
            path.write_bytes(browser.picture())
            print(f"{path.relative_to(root)}: {path.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
