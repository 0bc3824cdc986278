#!/usr/bin/env python3
"""Draws scenes of data/fix before and after the correction into docs/pictures."""

import argparse
import math
import pathlib
import struct
import subprocess
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = {  # seen from here
    "crossed_30": (1.0, -2.2, 0.7),
    "dome": (1.0, -1.6, -0.35),
    "crumpled": (0.25, -1.0, 0.12),
    "gears": (0.25, 0.2, 1.0),
    "block_in_sheet": (1.0, -1.7, -0.45),
}
COLOURS = ((120, 160, 210), (235, 175, 90), (140, 190, 130))
FINE = 3  # samples of each pixel, each way
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


class Image:
    """Pixels with depth; the nearest thing drawn counts. Three samples each way per pixel of the file."""

    def __init__(self, width, height):
        self.width, self.height = width * FINE, height * FINE
        self.pixels = [(255, 255, 255)] * (self.width * self.height)
        self.depth = [-1e300] * (self.width * self.height)

    def put(self, x, y, z, colour):
        if 0 <= x < self.width and 0 <= y < self.height and z > self.depth[y * self.width + x]:
            self.depth[y * self.width + x] = z
            self.pixels[y * self.width + x] = colour

    def triangle(self, p, q, r, colour):
        area = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])
        if area == 0:
            return
        for y in range(max(0, int(min(p[1], q[1], r[1]))), min(self.height, int(max(p[1], q[1], r[1])) + 2)):
            for x in range(max(0, int(min(p[0], q[0], r[0]))), min(self.width, int(max(p[0], q[0], r[0])) + 2)):
                u = ((q[0] - x) * (r[1] - y) - (r[0] - x) * (q[1] - y)) / area
                v = ((r[0] - x) * (p[1] - y) - (p[0] - x) * (r[1] - y)) / area
                if u >= 0 and v >= 0 and u + v <= 1:
                    self.put(x, y, u * p[2] + v * q[2] + (1 - u - v) * r[2], colour)

    def line(self, p, q, above):
        steps = int(max(abs(q[0] - p[0]), abs(q[1] - p[1]))) + 1
        for i in range(steps + 1):
            x, y, z = (p[k] + (q[k] - p[k]) * i / steps for k in range(3))
            for dx in (0, 1):
                self.put(int(x) + dx, int(y), z + above, (60, 60, 60))

    def write(self, path):
        rows = bytearray()
        for y in range(0, self.height, FINE):
            rows.append(0)
            for x in range(0, self.width, FINE):
                block = [self.pixels[(y + j) * self.width + x + i] for j in range(FINE) for i in range(FINE)]
                rows += bytes(sum(c[k] for c in block) // len(block) for k in range(3))

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        head = struct.pack(">IIBBBBB", self.width // FINE, self.height // FINE, 8, 2, 0, 0, 0)
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(rows), 9))
                         + chunk(b"IEND", b""))


def draw(image, points, faces, view, place):
    flat, toward = project(points, view)
    at = {n: place(p) for n, p in flat.items()}
    for nodes, part in faces:
        corners = [points[n] for n in nodes]
        a = tuple(q - p for p, q in zip(corners[0], corners[2]))
        b = tuple(q - p for p, q in zip(corners[1], corners[3]))
        shade = 0.55 + 0.45 * abs(dot(unit(cross(a, b)), toward))
        colour = tuple(int(shade * c) for c in COLOURS[(part - 1) % len(COLOURS)])
        n = [at[i] for i in nodes]
        image.triangle(n[0], n[1], n[2], colour)
        image.triangle(n[0], n[2], n[3], colour)
    for nodes, _ in faces:
        for k in range(4):
            image.line(at[nodes[k]], at[nodes[(k + 1) % 4]], 0.15)


def picture(before, after, view, path, size=430):
    flat, _ = project({**before[0], **{-n: p for n, p in after[0].items()}}, view)
    low = [min(p[i] for p in flat.values()) for i in (0, 1)]
    high = [max(p[i] for p in flat.values()) for i in (0, 1)]
    scale = (size - 20) / max(high[0] - low[0], 0.7 * (high[1] - low[1]))
    height = int((high[1] - low[1]) * scale) + 20
    image = Image(2 * size, height)
    for left, (points, faces) in ((0, before), (size, after)):
        def place(p, left=left):
            return (FINE * (left + 10 + (p[0] - low[0]) * scale), FINE * (height - 10 - (p[1] - low[1]) * scale), p[2])
        draw(image, points, faces, view, place)
    image.write(path)


def main():
    global FINE
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("gapcheck", help="the program")
    parser.add_argument("--small", action="store_true", help="only the first scene, without smooth edges")
    arguments = parser.parse_args()
    if arguments.small:
        FINE = 1
    for name, view in list(SCENES.items())[:1 if arguments.small else None]:
        deck = ROOT / "data" / "fix" / f"{name}.k"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([arguments.gapcheck, "fix", deck, "-o", folder], capture_output=True, check=True)
            fixed = next(pathlib.Path(folder).rglob(f"{name}.k"))
            picture(read(deck), read(fixed), view, ROOT / "docs" / "pictures" / f"fix_{name}.png")


if __name__ == "__main__":
    main()
