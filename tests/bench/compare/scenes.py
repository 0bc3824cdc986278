"""Decks to be audited: two sheets of shells over each other in one single-surface contact."""

import math

SPACING = 5.0

HEAD = """*KEYWORD
*CONTROL_TERMINATION
     0.001
*MAT_ELASTIC
         1  7.85E-09  210000.0       0.3
*SECTION_SHELL
         1         2       1.0         2
       1.0       1.0       1.0       1.0
*PART
lower sheet
         1         1         1
*PART
upper sheet
         2         1         1
*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID
         1all parts
         0         0         5         0
       0.0
       1.0       1.0
"""


def two_sheets(path, n, height, gap):
    """n x n shells each, 1 thick; the upper sheet is shifted by 0.3 and 0.4 of an element and lies `gap` higher."""
    lines = [HEAD.rstrip("\n"), "*NODE"]
    number = 0
    for shift_x, shift_y, up in ((0.0, 0.0, 0.0), (0.3 * SPACING, 0.4 * SPACING, gap)):
        for j in range(n + 1):
            for i in range(n + 1):
                number += 1
                x, y = shift_x + SPACING * i, shift_y + SPACING * j
                lines.append(f"{number:8}{x:16.8E}{y:16.8E}{up + height(x, y):16.8E}")
    lines.append("*ELEMENT_SHELL")
    number = 0
    for part, first in ((1, 1), (2, 1 + (n + 1) ** 2)):
        for j in range(n):
            for i in range(n):
                number += 1
                a = first + j * (n + 1) + i
                lines.append(f"{number:8}{part:8}{a:8}{a + 1:8}{a + n + 2:8}{a + n + 1:8}")
    path.write_text("\n".join(lines + ["*END", ""]), encoding="ascii")
    return path


def plates(path, n):
    """Flat: all nodes over the other plate penetrate by 0.3."""
    return two_sheets(path, n, lambda x, y: 0.0, 0.7)


def wavy_sheets(path, n):
    """Quads warped by up to 13 degrees; nodes of the slopes penetrate, those of crests and hollows barely do."""
    return two_sheets(path, n, lambda x, y: 2.0 * math.sin(x / 8) * math.sin(y / 8), 0.95)
