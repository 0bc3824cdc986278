"""A deck of two files, with a blank and an umlaut in their names, in which two plates penetrate."""
import os

MAIN = """*KEYWORD
*PARAMETER
R      t       1.0
*INCLUDE
mesh türen.k
*SECTION_SHELL
         1         2
        &t        &t        &t        &t
*MAT_ELASTIC
         1   7.8E-6     210.0       0.3
*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID
         1plates
         0
       0.1

*END
"""


def mesh():
    """Two plates of four shells, 0.7 apart with a contact distance of 1."""
    lines = ["*PART", "lower", "         1         1         1", "upper", "         2         1         1", "*NODE"]
    for plate in range(2):
        for i in range(9):
            lines.append(f"{100 * plate + i + 1:8d}{5.0 * (i % 3):16.1f}{5.0 * (i // 3):16.1f}{0.7 * plate:16.1f}")
    lines.append("*ELEMENT_SHELL")
    for plate in range(2):
        for i, corner in enumerate((1, 2, 4, 5)):
            n = 100 * plate + corner
            lines.append(f"{100 * plate + i + 1:8d}{plate + 1:8d}{n:8d}{n + 1:8d}{n + 4:8d}{n + 3:8d}")
    return "\n".join(lines) + "\n"


def write(folder):
    with open(os.path.join(folder, "main deck.k"), "w", encoding="utf-8") as file:
        file.write(MAIN)
    with open(os.path.join(folder, "mesh türen.k"), "w", encoding="utf-8") as file:
        file.write(mesh())
