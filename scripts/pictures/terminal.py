#!/usr/bin/env python3
"""Draws docs/pictures/terminal.svg: what gapcheck prints on a terminal, with its colours.

usage: terminal.py GAPCHECK            writes the picture
       terminal.py --check GAPCHECK    exit code 1 if the picture is not what gapcheck prints now
"""

import html
import os
import pathlib
import pty
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs" / "pictures" / "terminal.svg"
ARGUMENTS = ["audit", "data/two_plates.k"]
COMMAND = "$ ./run " + " ".join(ARGUMENTS)
COLUMNS = 124
CHARACTER, LINE, MARGIN, SIZE = 7.8, 17, 14, 13  # widths and heights in pixels
BACK, TEXT, FAINT = "#14171b", "#d5dae0", "#8b949e"
COLORS = {31: "#ff7b72", 32: "#7ee787", 33: "#e3b341", 34: "#79c0ff", 35: "#d2a8ff", 36: "#76e3ea"}


def printed(gapcheck):
    """What the program writes to a terminal."""
    ours, theirs = pty.openpty()
    environment = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    run = subprocess.Popen([gapcheck, *ARGUMENTS], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=theirs,
                           stderr=subprocess.DEVNULL, env=environment)
    os.close(theirs)
    text = b""
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:  # the end of a terminal
            break
        if not piece:
            break
        text += piece
    os.close(ours)
    if run.wait() not in (0, 1):
        raise SystemExit(f"gapcheck ended with {run.returncode}")
    return text.decode().replace("\r\n", "\n")


def characters(text):
    """Pairs of character and style, line by line; a style is bold, faint and a colour."""
    lines, style = [[]], (False, False, None)
    for piece in re.split(r"(\x1b\[[0-9;]*m|\n)", text):
        if piece == "\n":
            lines.append([])
        elif piece.startswith("\x1b["):
            for code in (int(number or 0) for number in piece[2:-1].split(";")):
                if code == 0:
                    style = (False, False, None)
                elif code == 1:
                    style = (True, style[1], style[2])
                elif code == 2:
                    style = (style[0], True, style[2])
                elif code in COLORS:
                    style = (style[0], style[1], COLORS[code])
                else:
                    raise SystemExit(f"the picture knows no terminal code {code}")
        else:
            lines[-1] += [(character, style) for character in piece]
    while not lines[-1]:
        lines.pop()
    return lines


def wrapped(lines):
    for line in lines:
        for start in range(0, max(1, len(line)), COLUMNS):
            yield line[start:start + COLUMNS]


def runs(line):
    """Neighbours with one style: place, text, style. Blanks at either end are left out."""
    place = 0
    while place < len(line):
        end = place
        while end < len(line) and line[end][1] == line[place][1]:
            end += 1
        text = "".join(character for character, _ in line[place:end])
        if text.strip():
            yield place + len(text) - len(text.lstrip()), text.strip(), line[place][1]
        place = end


def drawn(lines):
    width = 2 * MARGIN + COLUMNS * CHARACTER
    height = 2 * MARGIN + len(lines) * LINE
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
           f'height="{height:.0f}" font-family="ui-monospace, Menlo, Consolas, \'DejaVu Sans Mono\', monospace" '
           f'font-size="{SIZE}" xml:space="preserve">')
    yield f'<rect width="100%" height="100%" rx="8" fill="{BACK}"/>'
    for number, line in enumerate(lines):
        for place, text, (bold, faint, color) in runs(line):
            weight = ' font-weight="bold"' if bold else ""
            yield (f'<text x="{MARGIN + place * CHARACTER:.1f}" y="{MARGIN + number * LINE + SIZE}" '
                   f'textLength="{len(text) * CHARACTER:.1f}" lengthAdjust="spacingAndGlyphs" '
                   f'fill="{color or (FAINT if faint else TEXT)}"{weight}>{html.escape(text, quote=False)}</text>')
    yield "</svg>"


def main():
    command = f"\x1b[2m{COMMAND}\x1b[0m\n"
    lines = list(wrapped(characters(command + printed(pathlib.Path(sys.argv[-1]).resolve()))))
    svg = "\n".join(drawn(lines)) + "\n"
    if sys.argv[1] == "--check":
        if PICTURE.read_text() != svg:
            raise SystemExit(f"{PICTURE.relative_to(ROOT)} is not what gapcheck prints; run {sys.argv[0]} GAPCHECK")
        return
    PICTURE.write_text(svg)
    print(f"{PICTURE.relative_to(ROOT)}: {len(lines)} lines, {PICTURE.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
