"""Writes one example deck and the findings that it must give."""

import json
import math
import textwrap

SHOOT = 1.002  # a node that is moved goes this multiple of its penetration


def number(value, width):
    """A number in at most width - 1 columns that reads back as the same double."""
    text = repr(float(value))
    if text.endswith(".0"):
        text = text[:-1]
    if len(text) >= width:
        raise ValueError(f"{text} does not fit {width} columns")
    return text


def card(*fields):
    """One line of fields, ten columns each; None is a blank field."""
    cells = ["" if f is None else number(f, 11) if isinstance(f, float) else str(f) for f in fields]
    return "".join(f"{cell:>10}" for cell in cells).rstrip()


class Deck:
    """A deck under construction: nodes, parts and contacts, and the expected findings."""

    def __init__(self, name, text):
        self.name, self.text = name, text
        self.nodes, self.parts, self.contacts, self.controls = {}, [], [], []
        self.shells, self.solids, self.beams = [], [], []
        self.shell_thickness = {}  # element id -> thickness of its card
        self.recommends = False  # IGNORE = 2: the solver says where a node should be
        self.expected, self.not_checked = [], []
        self.other_findings = {}  # name of the rule -> number of findings
        self.reads_ignore = set()  # ids of contacts whose type has IGNORE
        self.mesh_file = None  # name of an include file for nodes and elements

    # Mesh ------------------------------------------------------------------------------------------------------

    def part(self, pid, title, kind="shell", thickness=1.0, optt=None, diameter=2.0):
        self.parts.append((pid, title, kind, thickness, optt, diameter))

    def node(self, nid, x, y, z):
        assert nid not in self.nodes
        self.nodes[nid] = tuple(round(float(v), 9) for v in (x, y, z))
        return nid

    def plate(self, pid, cells, size, origin, height=None, flip=False):
        """A grid of quads; node (i, j) stands at origin + size * (i, j) and, with `height`, at z = height(x, y).
        Returns {(i, j): node id}. The normals look up, or down with `flip`."""
        nx, ny = cells
        x0, y0, z0 = origin
        grid = {}
        for j in range(ny + 1):
            for i in range(nx + 1):
                x, y = x0 + i * size, y0 + j * size
                z = z0 if height is None else height(x, y)
                grid[i, j] = self.node(1000 * pid + j * (nx + 1) + i + 1, x, y, z)
        for j in range(ny):
            for i in range(nx):
                quad = [grid[i, j], grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1]]
                self.shell(pid, quad[::-1] if flip else quad)
        return grid

    def shell(self, pid, quad, thickness=None):
        element = 1000 * pid + len(self.shells) + 1
        self.shells.append((element, pid, quad))
        if thickness is not None:
            self.shell_thickness[element] = thickness
        return element

    def fin(self, pid, first, second, number_of_fin, height=5.0):
        """A quad that stands on the two points given; returns their node ids. Its upper nodes are out of reach."""
        base = 1000 * pid + 10 * number_of_fin
        feet = [self.node(base + k + 1, *point) for k, point in enumerate((first, second))]
        heads = [self.node(base + k + 3, p[0], p[1], p[2] + height) for k, p in enumerate((second, first))]
        self.shell(pid, feet + heads)
        return feet

    def block(self, pid, cells, size, origin, place=lambda point: point):
        """A box of bricks with edges `size` (one number or three), each node put where `place` says; returns
        {(i, j, k): node id}."""
        sizes = size if isinstance(size, tuple) else (size, size, size)
        nx, ny, nz = cells
        grid = {}
        for k in range(nz + 1):
            for j in range(ny + 1):
                for i in range(nx + 1):
                    nid = 1000 * pid + (k * (ny + 1) + j) * (nx + 1) + i + 1
                    point = [o + s * m for o, s, m in zip(origin, sizes, (i, j, k))]
                    grid[i, j, k] = self.node(nid, *place(point))
        for k in range(nz):
            for j in range(ny):
                for i in range(nx):
                    ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                    corners = [grid[a, b, k] for a, b in ring] + [grid[a, b, k + 1] for a, b in ring]
                    self.solids.append((1000 * pid + len(self.solids) + 1, pid, corners))
        return grid

    # Contacts and controls -------------------------------------------------------------------------------------

    def contact(self, keyword, cid, a, b=None, title="", a_type=3, b_type=3, card3=(), soft=None, card_b=None,
                card_c=None, mpp_ignore=None, extra=()):
        """a, b: part ids (type 3) or part set ids (type 2). card_b and card_c are fields of the optional cards."""
        if keyword.startswith("AUTOMATIC"):
            self.reads_ignore.add(cid)
        name = f"*CONTACT_{keyword}" + ("_MPP" if mpp_ignore is not None else "") + "_ID"
        lines = [name, f"{cid:>10}{title}"]
        if mpp_ignore is not None:
            lines.append(card(mpp_ignore))
        lines.append(card(a, b if b is not None else 0, a_type, b_type if b is not None else 0))
        lines += [card(0.0), card(*card3) if card3 else card(1.0, 1.0)]
        lines += list(extra)
        optional = [card(soft if soft is not None else 0), card(*(card_b or (0.0,))), card(*(card_c or (1,)))]
        wanted = 3 if card_c else 2 if card_b else 1 if soft is not None else 0
        self.contacts.append("\n".join(lines + optional[:wanted]))

    def part_set(self, sid, parts):
        self.controls.append(f"*SET_PART_LIST\n{sid:>10}\n" + card(*parts))

    def control_contact(self, shlthk=0, ssthk=0, th=0.0, ignore=0):
        self.recommends = ignore == 2
        self.controls.append("\n".join(["*CONTROL_CONTACT", card(0.1, 0.0, 2, shlthk, 1, 0, 1),
                                        card(0, 0, 10, 0, 4.0, ssthk), card(0.0, 0.0, 0.0, 0.0, th), card(ignore)]))

    # Expectations ----------------------------------------------------------------------------------------------

    def expect(self, contact, node, h, distance, direction=None, outcome="moved", feature="face",
               rule="initial-penetration"):
        """The node is `distance` away from its closest segment, along `direction` (unit vector from the segment)."""
        depth = h - distance
        entry = {"rule": rule, "contact": contact, "node": node, "penetration": depth, "contact_distance": h,
                 "outcome": outcome, "feature": feature}
        if outcome == "moved" or (outcome == "kept" and self.recommends):
            entry["moved_to" if outcome == "moved" else "recommended"] = [x + SHOOT * depth * d for x, d in zip(self.position(contact, node), direction)]
        self.expected.append(entry)

    def position(self, contact, node):
        """Where earlier contacts left the node."""
        for entry in reversed(self.expected):
            if entry["node"] == node and "moved_to" in entry and entry["contact"] != contact:
                return entry["moved_to"]
        return self.nodes[node]

    def expect_released(self, contact, node, h, distance, feature="face"):
        self.expect(contact, node, h, distance, outcome="released", feature=feature, rule="released-node")

    def expect_edge_zone(self, contact, node, h, distance, feature):
        self.expect(contact, node, h, distance, outcome="reported", feature=feature, rule="edge-zone-penetration")

    def expect_others(self, **counts):
        """Findings of rules on definitions, ties and crossings: number by name of the rule, with _ for -."""
        self.other_findings.update({name.replace("_", "-"): count for name, count in counts.items()})

    def others(self):
        """Each contact with penetrations is audited with less thickness too; IGNORE is recommended where it would help."""
        penetrated = {e["contact"] for e in self.expected}
        counts = dict(self.other_findings)
        if penetrated:
            counts["penetration-free-at"] = len(penetrated)
        if any(e["outcome"] in ("moved", "forced") and e["contact"] in self.reads_ignore for e in self.expected):
            counts["ignore-recommended"] = 1
        return dict(sorted(counts.items()))

    # Output ----------------------------------------------------------------------------------------------------

    def write(self, folder):
        (folder / f"{self.name}.k").write_text(self.deck_text(), encoding="ascii")
        if self.mesh_file:
            path = folder / self.mesh_file
            path.parent.mkdir(exist_ok=True)
            path.write_text("\n".join(["*KEYWORD", *self.mesh_lines(), "*END"]) + "\n", encoding="ascii")
        rows = ",\n".join("    " + json.dumps(entry) for entry in sorted(
            self.expected, key=lambda e: (e["contact"], e["node"])))
        body = '{\n  "findings": [' + ("\n" + rows + "\n  " if rows else "") + "],\n"
        body += f'  "others": {json.dumps(self.others())},\n  "not_checked": {json.dumps(self.not_checked)}\n}}\n'
        (folder / f"{self.name}.expected.json").write_text(body, encoding="ascii")

    def header(self):
        text = textwrap.fill(" ".join(self.text.split()), width=78).splitlines()
        lines = [f"$ {line}".rstrip() for line in (self.name, "", *text, "", "Expected findings:")]
        groups = {}
        for e in self.expected:
            groups.setdefault((e["contact"], e["rule"], e["outcome"]), []).append(e["penetration"])
        for (contact, rule, outcome), depths in sorted(groups.items()):
            low, high = f"{min(depths):.4g}", f"{max(depths):.4g}"
            span = high if low == high else f"{low} to {high}"
            lines.append(f"$   contact {contact}: {len(depths)} x {rule} ({outcome}), penetration {span}")
        lines += [f"$   contact {c}: not checked" for c in self.not_checked]
        others = self.others()
        lines += [f"$   {count} x {name}" for name, count in others.items()]
        if not groups and not others and not self.not_checked:
            lines.append("$   none")
        return lines

    def deck_text(self):
        lines = ["*KEYWORD"] + self.header() + ["*TITLE", f"gapcheck example {self.name}", "*CONTROL_TERMINATION",
                                                card(0.001), "*DATABASE_GLSTAT", card(1e-05)]
        lines += self.controls
        for pid, title, kind, thickness, optt, diameter in self.parts:
            lines += self.part_lines(pid, title, kind, thickness, optt, diameter)
        lines += ["*MAT_ELASTIC", card(1, 7.85e-09, 210000.0, 0.3)]
        lines += ["*INCLUDE", self.mesh_file] if self.mesh_file else self.mesh_lines()
        return "\n".join(lines + self.contacts + ["*END"]) + "\n"

    def mesh_lines(self):
        lines = ["*NODE", "$    nid               x               y               z"]
        for nid, point in self.nodes.items():
            lines.append(f"{nid:>8}" + "".join(f"{number(x, 16):>16}" for x in point))
        return lines + self.element_lines()

    @staticmethod
    def part_lines(pid, title, kind, thickness, optt, diameter):
        lines = ["*PART" if optt is None else "*PART_CONTACT", title, card(pid, pid, 1)]
        if optt is not None:
            lines.append(card(0.0, 0.0, 0.0, 0.0, optt))
        if kind == "shell":
            lines += ["*SECTION_SHELL", card(pid, 2, 0.833, 5), card(*[thickness] * 4)]
        elif kind == "solid":
            lines += ["*SECTION_SOLID", card(pid, 1)]
        else:
            lines += ["*SECTION_BEAM", card(pid, 1, 0.9, 2, 1), card(diameter, diameter, 0.0, 0.0)]
        return lines

    def element_lines(self):
        def row(element, pid, nodes):
            return "".join(f"{value:>8}" for value in (element, pid, *nodes))

        plain = [s for s in self.shells if s[0] not in self.shell_thickness]
        own = [s for s in self.shells if s[0] in self.shell_thickness]
        lines = ["*ELEMENT_SHELL"] + [row(*s) for s in plain] if plain else []
        if own:
            lines.append("*ELEMENT_SHELL_THICKNESS")
            for s in own:
                lines += [row(*s), f"{number(self.shell_thickness[s[0]], 16):>16}" * 4]
        if self.solids:
            lines += ["*ELEMENT_SOLID"] + [row(*s) for s in self.solids]
        if self.beams:
            lines += ["*ELEMENT_BEAM"] + [row(*b) for b in self.beams]
        return lines


def unit(vector):
    length = math.sqrt(sum(v * v for v in vector))
    return [v / length for v in vector]
