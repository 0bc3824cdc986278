"""A plain reader of keyword decks and vectors, for checks that must not use gapcheck's own code: nodes, shells, solids,
parts, sections, materials and blocks, with includes, parameters and cases. Shared by scripts."""
import functools
import math
import re

# Vectors

def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def plus(*vectors):
    return [sum(values) for values in zip(*vectors)]


def times(factor, a):
    return [factor * x for x in a]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return math.sqrt(dot(a, a))


def middle(points):
    return times(1 / len(points), plus(*points))


# Reading

def number(text):
    """A number of a field; `2.00000-3` has an exponent without E."""
    text = text.strip()
    try:
        return float(text or 0)
    except ValueError:
        return float(re.sub(r"(?<=[\d.])([-+]\d+)$", r"E\1", text))


class Deck:
    """The blocks of a deck and its includes: (keyword, path, line, [data lines])."""

    def __init__(self, path, folders=()):
        self.parameters = {}
        self.blocks = []
        self.missing = []
        self.folders = list(folders)
        self.read(path)

    def read(self, path, case=None):
        block = None
        for line_number, line in enumerate(path.read_text(encoding="latin-1").splitlines(), 1):
            if line.startswith("*"):
                self.include(block, path, case)
                keyword = line.strip().upper()
                case = keyword[12:] if keyword.startswith("*CASE_BEGIN_") else case
                case = None if keyword.startswith("*CASE_END") else case
                if keyword == "*END":
                    return
                block = (keyword, path, line_number, [], case)
                self.blocks.append(block)
            elif block and not line.startswith("$"):
                block[3].append(line)
                if block[0] == "*PARAMETER":
                    self.parameter(line)
        self.include(block, path, case)

    def set_parameters(self, **values):
        """Other values; what was read with the old ones is read again."""
        self.parameters.update(values)
        for name in ("shells", "section_thickness"):
            self.__dict__.pop(name, None)

    def parameter(self, line):
        cells = line.split(",") if "," in line else [line[i:i + 10] for i in range(0, len(line), 10)]
        for name, value in zip(cells[::2], cells[1::2]):
            if name.strip():
                self.parameters[name.strip()[1:].strip().lower()] = value.strip()

    def include(self, block, path, case):
        if not block or not re.fullmatch(r"\*INCLUDE(_TRANSFORM)?", block[0]) or not block[3]:
            return
        name = block[3][0].strip().replace("\\", "/")
        for folder in [path.parent, *self.folders]:
            if (folder / name).is_file():
                self.read(folder / name, case)
                return
        self.missing.append(name)

    def cells(self, line, widths):
        """The fields of a line, with the values of parameters."""
        if "," in line:
            cells = line.split(",")
        else:
            cells, start = [], 0
            for width in widths:
                cells.append(line[start:start + width])
                start += width
        cells = [cell.strip() for cell in cells] + [""] * len(widths)
        return [self.parameters.get(cell[1:].lower(), "0") if cell.startswith("&") else cell for cell in cells]

    def rows(self, name, widths=(10,) * 8):
        for keyword, _, _, lines, _ in self.blocks:
            if re.fullmatch(name, keyword):
                yield [self.cells(line, widths) for line in lines]

    @functools.cached_property
    def nodes(self):
        found = {}
        for rows in self.rows(r"\*NODE", (8, 16, 16, 16)):
            for row in rows:
                if row[0]:
                    found.setdefault(int(row[0]), [number(cell) for cell in row[1:4]])
        return found

    @functools.cached_property
    def parts(self):
        """Section and material of each part."""
        found = {}
        for rows in self.rows(r"\*PART"):
            for row in rows[1::2]:
                found[int(row[0])] = (int(row[1] or 0), int(row[2] or 0))
        return found

    @functools.cached_property
    def section_thickness(self):
        found = {}
        for rows in self.rows(r"\*SECTION_SHELL"):
            found[int(rows[0][0])] = number(rows[1][0])
        return found

    @functools.cached_property
    def materials(self):
        """Density, Young's modulus and Poisson's ratio."""
        found = {}
        for rows in self.rows(r"\*MAT_(PLASTIC_KINEMATIC|RIGID)"):
            found[int(rows[0][0])] = [number(cell) for cell in rows[0][1:4]]
        return found

    @functools.cached_property
    def shells(self):
        """Part, corners and thickness of each shell."""
        found = {}
        for keyword, _, _, lines, _ in self.blocks:
            if keyword == "*ELEMENT_SHELL_OFFSET_COMPOSITE":
                found.update(self.composite_shells(lines))
            elif keyword.startswith("*ELEMENT_SHELL"):
                step = 2 if "THICKNESS" in keyword else 1
                for at in range(0, len(lines), step):
                    row = self.cells(lines[at], (8,) * 10)
                    own = number(self.cells(lines[at + 1], (16,) * 4)[0]) if step == 2 else 0
                    self.add_shell(found, row, own)
        return found

    def add_shell(self, found, row, own):
        corners = [int(cell) for cell in row[2:6] if cell and int(cell)]
        if row[0] and len(corners) >= 3:
            part = int(row[1])
            section = self.parts.get(part, (0, 0))[0]
            found[int(row[0])] = (part, corners, own or self.section_thickness.get(section, 0))

    def composite_shells(self, lines):
        """Rows of ids, of the offset, and of plies: material, thickness, angle, twice."""
        found, last = {}, None
        for line in lines:
            row = self.cells(line, (8,) * 6)
            if "." not in line:
                last = int(row[0])
                found[last] = [int(row[1]), [int(cell) for cell in row[2:6]], 0.0]
            elif len(line.split()) > 1:
                plies = self.cells(line, (10,) * 8)
                found[last][2] += number(plies[1]) + number(plies[5])
        return {shell: (part, corners[:3] if corners[2] == corners[3] else corners, thickness)
                for shell, (part, corners, thickness) in found.items()}

    @functools.cached_property
    def solids(self):
        """Part and eight corners of each solid, from one line or two."""
        found = {}
        for keyword, _, _, lines, _ in self.blocks:
            if not keyword.startswith("*ELEMENT_SOLID"):
                continue
            rows = [[int(cell or 0) for cell in self.cells(line, (8,) * 10)[:10]] for line in lines if line.strip()]
            two_lines = not any(rows[0][2:])
            for at in range(0, len(rows), 2 if two_lines else 1):
                corners = rows[at + 1][:8] if two_lines else rows[at][2:10]
                found[rows[at][0]] = (rows[at][1], corners)
        return found

    def points(self, corners):
        return [self.nodes[node] for node in corners]


# Shells: area, edges, thickness in contact

def edges(points):
    return [length(minus(points[i], points[i - 1])) for i in range(len(points))]


def area(points):
    p = points if len(points) == 4 else [*points, points[2]]
    return length(cross(minus(p[2], p[0]), minus(p[3], p[1]))) / 2


def contact_thickness(deck, shell):
    """Single surface with SSTHK = 0: at most 0.4 of the shortest edge."""
    _, corners, thickness = deck.shells[shell]
    return min(thickness, 0.4 * min(edges(deck.points(corners))))


def node_thickness(deck, parts):
    """The largest thickness of a node's shells in these parts."""
    found = {}
    for shell, (part, corners, _) in deck.shells.items():
        if part in parts:
            for node in corners:
                found[node] = max(found.get(node, 0), contact_thickness(deck, shell))
    return found
