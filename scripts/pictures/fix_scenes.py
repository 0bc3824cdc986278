#!/usr/bin/env python3
"""Draws scenes of data/fix before and after the correction into docs/pictures: fix_scenes.py GAPCHECK"""

import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = {  # seen from here
    "crossed_30": (1.0, -2.2, 0.7),
    "dome": (1.0, -1.6, -0.35),
    "crumpled": (0.25, -1.0, 0.12),
    "gears": (0.25, 0.2, 1.0),
    "block_in_sheet": (1.0, -1.7, -0.45),
}
COLOURS = ((120, 160, 210), (235, 175, 90), (140, 190, 130))
BRICK_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def read(path):
    """Points by node, and faces with their part: shells, and outer faces of bricks."""
    points, faces, bricks, keyword = {}, [], {}, ""
    for line in path.read_text().splitlines():
        if line.startswith("*"):
            keyword = line
        elif keyword == "*NODE":
            points[int(line[:8])] = tuple(float(line[8 + 16 * i:24 + 16 * i]) for i in range(3))
        elif keyword.startswith("*ELEMENT_"):
            ids = [int(line[i:i + 8]) for i in range(0, len(line), 8)]
            nodes, part = ids[2:], ids[1]
            if keyword == "*ELEMENT_SHELL":
                faces.append((nodes, part))
                continue
            for corners in BRICK_FACES:
                face = [nodes[i] for i in corners]
                key = tuple(sorted(face))
                bricks[key] = None if key in bricks else (face, part)
    return points, faces + [face for face in bricks.values() if face]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def unit(v):
    length = math.sqrt(dot(v, v)) or 1.0
    return tuple(c / length for c in v)


def project(points, view):
    toward = unit(view)
    right = unit(cross((0, 0, 1), toward))
    up = cross(toward, right)
    return {n: (dot(p, right), dot(p, up), dot(p, toward)) for n, p in points.items()}, toward


def split(points, face, parts=4):
    """Smaller quads, so that those of crossing faces are drawn one behind the other."""
    a, b, c, d = (points[n] for n in face)
    grid = [[tuple((1 - s) * (1 - t) * a[k] + s * (1 - t) * b[k] + s * t * c[k] + (1 - s) * t * d[k] for k in range(3))
             for s in (i / parts for i in range(parts + 1))] for t in (j / parts for j in range(parts + 1))]
    for j in range(parts):
        for i in range(parts):
            yield (grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i])


def draw(points, faces, view, left, place):
    flat, toward = project(points, view)
    pieces = []
    for nodes, part in faces:
        corners = [points[n] for n in nodes]
        a = tuple(q - p for p, q in zip(corners[0], corners[2]))
        b = tuple(q - p for p, q in zip(corners[1], corners[3]))
        shade = 0.55 + 0.45 * abs(dot(unit(cross(a, b)), toward))
        colour = "#" + "".join(f"{int(shade * c):02x}" for c in COLOURS[(part - 1) % len(COLOURS)])
        for quad in split(flat, nodes):
            pieces.append((sum(p[2] for p in quad), quad, colour))
        for k in range(4):
            p, q = flat[nodes[k]], flat[nodes[(k + 1) % 4]]
            steps = [tuple(p[i] + (q[i] - p[i]) * s / 4 for i in range(3)) for s in range(5)]
            pieces += [(2 * (u[2] + v[2]) + 0.5, (u, v), None) for u, v in zip(steps, steps[1:])]
    out = []
    for _, shape, colour in sorted(pieces, key=lambda piece: piece[0]):
        xy = [place(p, left) for p in shape]
        if colour is None:
            out.append(f'<path d="M{xy[0]}L{xy[1]}" stroke="#333" stroke-width="0.5"/>')
        else:
            out.append(f'<path d="M{"L".join(xy)}z" fill="{colour}" stroke="{colour}" stroke-width="0.4"/>')
    return out


def picture(before, after, view, size=430):
    flat, _ = project({**before[0], **{-n: p for n, p in after[0].items()}}, view)
    low = [min(p[i] for p in flat.values()) for i in (0, 1)]
    high = [max(p[i] for p in flat.values()) for i in (0, 1)]
    scale = (size - 20) / max(high[0] - low[0], 0.7 * (high[1] - low[1]))
    height = int((high[1] - low[1]) * scale) + 20

    def place(p, left):
        return f"{left + 10 + (p[0] - low[0]) * scale:.1f} {height - 10 - (p[1] - low[1]) * scale:.1f}"
    body = draw(*before, view, 0, place) + draw(*after, view, size, place)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * size} {height}">\n'
            f'<rect width="{2 * size}" height="{height}" fill="white"/>\n' + "\n".join(body) + "\n</svg>\n")


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    for name, view in SCENES.items():
        deck = ROOT / "data" / "fix" / f"{name}.k"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.argv[1], "fix", deck, "-o", folder], capture_output=True, check=True)
            fixed = next(pathlib.Path(folder).rglob(f"{name}.k"))
            (ROOT / "docs" / "pictures" / f"fix_{name}.svg").write_text(picture(read(deck), read(fixed), view))


if __name__ == "__main__":
    main()
