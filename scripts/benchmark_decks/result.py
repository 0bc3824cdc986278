"""Runs a deck and reads what the program writes."""
import collections
import math
import re
import resource
import subprocess

FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
Force = collections.namedtuple("Force", "node force pressure position")


def corner_area(before, corner, after):
    """Of the triangle of a corner and its neighbours."""
    first, second = [q - p for p, q in zip(corner, after)], [q - p for p, q in zip(corner, before)]
    cross = [first[i - 2] * second[i - 1] - first[i - 1] * second[i - 2] for i in range(3)]
    return 0.5 * math.sqrt(sum(q * q for q in cross))


class Result:
    """A run's files. nodes: {id: rows of displacement, velocity, acceleration and position} of nodout."""

    def __init__(self, program, deck, folder, options=()):
        self.program, self.deck, self.folder = program, deck, folder / "out"
        path = folder / "deck.k"
        path.write_text(deck, encoding="ascii")
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run([program, "run", path, "-o", self.folder, "--force", "--jobs", "1", *options],
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stdout[-2000:] + done.stderr[-2000:])
        self.seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        self.text = done.stdout
        self.cycles = int(re.search(r"cycle (\d+)", done.stdout)[1])
        self.glstat = self.read("glstat")
        self.nodes, self.times = self.nodout()

        self.milliseconds = 1000 * self.seconds / max(self.cycles, 1)

    def ratio(self):
        return self.last("total energy / initial energy")

    def read(self, name):
        path = self.folder / name
        return path.read_text(encoding="ascii") if path.exists() else ""

    def history(self, label):
        """A row of glstat over time."""
        return [float(v) for v in re.findall(rf"^ {re.escape(label)}[ .]*\.\s*(\S+)", self.glstat, re.MULTILINE)]

    def last(self, label):
        return self.history(label)[-1]

    def nodout(self):
        nodes, times, kind = {}, [], ""
        for line in self.read("nodout").splitlines():
            # Columns of 12 behind ten of the id; the blocks of rotations have other headings.
            if "nodal point  x-disp" in line:
                kind = "moved"
            elif "nodal point  x-rot" in line:
                kind = "turned"
            elif found := re.search(r"at time\s+(\S+)", line):
                if not times or times[-1] != float(found[1].rstrip(")")):
                    times.append(float(found[1].rstrip(")")))
            elif re.match(r"^ *\d+ [ -]\d\.\d{5}E", line) and kind == "moved":
                nodes.setdefault(int(line[:10]), []).append([float(line[10 + 12 * i:22 + 12 * i]) for i in range(12)])
        return nodes, times

    def rcforc(self, contact=1, side="A"):
        """[(time, (x, y, z))]."""
        rows = re.findall(rf"^  SURF{side} +{contact} time +(\S+) +x +(\S+) +y +(\S+) +z +(\S+)", self.read("rcforc"),
                          re.MULTILINE)
        return [(float(t), tuple(map(float, force))) for t, *force in rows]

    def rwforc(self, wall=1):
        """[(time, normal force)]."""
        rows = re.findall(rf"^ +(\S+) +{wall} +(\S+) +\S+ +\S+ +\S+$", self.read("rwforc"), re.MULTILINE)
        return [(float(t), float(force)) for t, force in rows]

    def bndout(self, nodes, axis):
        """[(time, force along the axis)], the sum over the nodes, of loads and prescribed motions."""
        sums = {}
        for block in self.read("bndout").split("o u t p u t   t=")[1:]:  # one for each kind
            forces = re.findall(rf"^ *nd# *(\d+) .*\b{axis}force= *(\S+)", block, re.MULTILINE)
            time = float(block.split()[0])
            sums[time] = sums.get(time, 0.0) + sum(float(f) for n, f in forces if int(n) in nodes)
        return list(sums.items())

    def node_forces(self, state=-1):
        """Of the last state of ncforc, of all contacts."""
        blocks = self.read("ncforc").split("\n forces (t=")[1:]
        times = [b.split(")")[0] for b in blocks]
        wanted = sorted(set(times), key=float)[state]
        found = []
        for block, time in zip(blocks, times):
            if time != wanted:
                continue
            rows = [line for line in block.splitlines()[4:] if line.strip()]
            for line, place in zip(rows[::2], rows[1::2]):
                v = [float(line[16 + 14 * i:30 + 14 * i]) for i in range(4)]
                found.append(Force(int(line[:10]), tuple(v[:3]), v[3],
                                   tuple(float(place[16 + 14 * i:30 + 14 * i]) for i in range(3))))
        return found

    def rows_of(self, keyword):
        kind = ""
        for line in self.deck.splitlines():
            if line.startswith("*"):
                kind = line
            elif kind == keyword:
                yield line

    def points(self):
        """Nodes at the start, from the deck."""
        return {int(line[:8]): tuple(float(line[i:i + 16]) for i in (8, 24, 40)) for line in self.rows_of("*NODE")}

    def solids_of(self, part):
        return [[int(line[i:i + 8]) for i in range(16, 80, 8)] for line in self.rows_of("*ELEMENT_SOLID")
                if int(line[8:16]) == part]

    def shells_of(self, part):
        return [[int(line[i:i + 8]) for i in range(16, 48, 8)] for line in self.rows_of("*ELEMENT_SHELL")
                if int(line[8:16]) == part]

    def pressures(self, part, on_surface):
        """As `shares`, with the size of the force over the node's share of the surface in place of the share."""
        return {n: (point, force, math.sqrt(sum(q * q for q in force)) / area)
                for n, (point, force, area) in self.shares(part, on_surface).items()}

    def shares(self, part, on_surface):
        """{node: (point, force, the node's share of the surface)} of the outer faces of a part whose corners all satisfy
        `on_surface(point)` at the start; where they are at the end. The force is 0 where there is no contact."""
        points = self.points()
        now = {**points, **{f.node: f.position for f in self.node_forces()}}
        faces = {}
        for brick in self.solids_of(part):
            for face in FACES:
                corners = [brick[c] for c in face]
                if all(on_surface(points[c]) for c in corners):
                    faces[tuple(sorted(corners))] = corners
        areas = {}
        for corners in faces.values():
            # ∫ N dA: the density of a plane face, linear over it, is that of the triangles at its corners.
            x = [now[n] for n in corners]
            density = [corner_area(x[c - 1], x[c], x[(c + 1) % 4]) / 2 for c in range(4)]
            for c, n in enumerate(corners):
                share = (4 * density[c] + 2 * density[c - 1] + 2 * density[(c + 1) % 4] + density[c - 2]) / 9
                areas[n] = areas.get(n, 0) + share
        forces = {f.node: f.force for f in self.node_forces()}
        return {n: (now[n], forces.get(n, (0.0, 0.0, 0.0)), area) for n, area in areas.items()}
