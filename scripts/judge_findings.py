#!/usr/bin/env python3
"""Recalculates drawn findings from the decks themselves: a reader and formulas of its own, nothing of gapcheck.

    scripts/draw_findings.py GAPCHECK DECKS --format json > drawn.json
    scripts/judge_findings.py drawn.json DECKS

Prints one line per finding: number, deck, rule, and what the deck gives. Whether a finding is true and useful is for a
person to say: docs/judged-findings.md. With --program GAPCHECK it also compares all penetrating nodes of the car decks
with those that an audit lists.
"""
import argparse
import functools
import json
import math
import pathlib
import re

import draw_findings
from plain_deck import (Deck, area, contact_thickness, cross, dot, edges, length, middle, minus, node_thickness, number,
                        plus, times)

TOLERANCE = 1e-9  # of the contact distance
FACES = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))


# Distance of a node from a shell

def to_line(point, a, b):
    along = minus(b, a)
    at = min(1, max(0, dot(minus(point, a), along) / (dot(along, along) or 1)))
    return length(minus(point, plus(a, times(at, along))))


def on_patch(points, s, t):
    weights = [(1 - s) * (1 - t) / 4, (1 + s) * (1 - t) / 4, (1 + s) * (1 + t) / 4, (1 - s) * (1 + t) / 4]
    return plus(*(times(w, p) for w, p in zip(weights, points)))


def foot(point, points):
    """Coordinates s, t of the normal projection on the quadrilateral, by Gauss and Newton."""
    s = t = 0.0
    for _ in range(50):
        ds = minus(on_patch(points, 1, t), on_patch(points, -1, t))
        dt = minus(on_patch(points, s, 1), on_patch(points, s, -1))
        ds, dt = times(0.5, ds), times(0.5, dt)
        gap = minus(point, on_patch(points, s, t))
        a, b, c = dot(ds, ds), dot(ds, dt), dot(dt, dt)
        determinant = a * c - b * b
        if determinant == 0:
            return None
        step_s = (c * dot(gap, ds) - b * dot(gap, dt)) / determinant
        step_t = (a * dot(gap, dt) - b * dot(gap, ds)) / determinant
        s, t = min(9, max(-9, s + step_s)), min(9, max(-9, t + step_t))
        if abs(step_s) + abs(step_t) < 1e-14:
            break
    return s, t


def distance(point, points):
    """From the segment; None beyond the band of half its width."""
    if len(points) == 3:
        return triangle_distance(point, points)
    at = foot(point, points)
    if at is None or max(abs(at[0]), abs(at[1])) > 1.5:
        return None
    if max(abs(at[0]), abs(at[1])) <= 1:
        return length(minus(point, on_patch(points, *at)))
    return min(to_line(point, points[i], points[i - 1]) for i in range(4))


def triangle_distance(point, points):
    normal = cross(minus(points[1], points[0]), minus(points[2], points[0]))
    normal = times(1 / length(normal), normal)
    sides = [dot(cross(minus(points[i], points[i - 1]), minus(point, points[i - 1])), normal) for i in range(3)]
    if min(sides) >= 0:
        return abs(dot(minus(point, points[0]), normal))
    near = min(to_line(point, points[i], points[i - 1]) for i in range(3))
    return near if near < 0.25 * min(edges(points)) else None


class Penetrations:
    """Nodes of a single-surface contact of shells that are nearer to a segment than the contact distance."""

    def __init__(self, deck, parts):
        self.deck = deck
        self.thickness = node_thickness(deck, parts)
        self.segments = []
        for shell, (part, corners, _) in deck.shells.items():
            if part in parts:
                points = deck.points(corners)
                box = [(min(p[i] for p in points), max(p[i] for p in points)) for i in range(3)]
                self.segments.append((shell, corners, points, box, contact_thickness(deck, shell)))

    def closest(self, node):
        """Distance, contact distance, release limit and shell of the closest segment within the contact distance."""
        best = None
        point = self.deck.nodes[node]
        for shell, corners, points, box, thickness in self.segments:
            reach = (self.thickness[node] + thickness) / 2
            outside = any(point[i] < low - reach or point[i] > high + reach for i, (low, high) in enumerate(box))
            if outside or node in corners:
                continue
            d = distance(point, points)
            if d is not None and d < reach * (1 - TOLERANCE) and (best is None or d < best[0]):
                best = (d, reach, 0.4 * (self.thickness[node] + thickness), shell)
        return best

    @functools.cached_property
    def all(self):
        found = {node: self.closest(node) for node in self.thickness}
        return {node: best for node, best in found.items() if best and best[1] - best[0] > 1e-6 * best[1]}

    def released(self):
        return [node for node, (d, reach, limit, _) in self.all.items() if reach - d > limit]


# Rules

CAR_PARTS = {1, 2, 3, 4}


@functools.lru_cache(maxsize=None)
def car(deck):
    return Penetrations(deck, CAR_PARTS)


def penetration(deck, finding):
    d, reach, limit, shell = car(deck).all[finding["node"]]
    word = "released" if reach - d > limit else "not released"
    return f"d = {d:.6g} from shell {shell}, h = {reach:g}, p = {reach - d:.6g}, limit {limit:g}: {word}"


def count_penetrations(deck, finding):
    found, released = len(car(deck).all), len(car(deck).released())
    return f"{found} nodes penetrate, {released} of them released, {found - released} not"


def free_thickness(deck, finding):
    distances = sorted((best[0], node) for node, best in car(deck).all.items())
    flat = sum(d <= 1e-9 for d, _ in distances)
    return f"{len(distances)} nodes; least distance {distances[0][0]:.4g} (node {distances[0][1]}); {flat} at 0 (1e-9)"


def conflict(deck, finding):
    own = contact_thickness(deck, finding["element"])
    return f"shell {finding['element']}: {own:g}, node {finding['node']}: {car(deck).thickness[finding['node']]:g}"


def sliver(deck, finding):
    points = deck.points(deck.shells[finding["element"]][1])
    longest = max(edges(points))
    height = area(points) / longest
    return f"area {area(points):.5g}, edges {', '.join(f'{e:.4g}' for e in edges(points))}; " \
           f"area / longest = {height:.4g}, ratio {height / longest:.4g}"


def same_nodes(deck, finding):
    _, corners, _ = deck.shells[finding["element"]]
    others = [shell for shell, (_, c, _) in deck.shells.items() if set(c) == set(corners)]
    parts = {deck.shells[shell][0] for shell in others}
    return f"shells {others} on nodes {sorted(corners)}; parts {sorted(parts)}; shells of part 6 on those of part 1: " \
           f"{doubled(deck, 6, 1)}"


def doubled(deck, part, other):
    corners = {frozenset(c) for p, c, _ in deck.shells.values() if p == other}
    return sum(p == part and frozenset(c) in corners for p, c, _ in deck.shells.values())


def limited(deck, finding):
    part = deck.shells[finding["element"]][0]
    short = [shell for shell, (p, _, t) in deck.shells.items() if p == part and contact_thickness(deck, shell) < t]
    shell = finding["element"]
    return f"shells {short} of part {part}; shell {shell}: plies {deck.shells[shell][2]:g}, " \
           f"0.4 x shortest edge {contact_thickness(deck, shell):.4g}"


def uncontacted(deck, finding):
    shells = [corners for part, corners, _ in deck.shells.values() if part == finding["part"]]
    solids = [corners for part, corners in deck.solids.values() if part == finding["part"]]
    points = deck.points({node for corners in shells for node in corners})
    words = [f"{len(shells)} shells, {len(solids)} solids; contacts: {contacts(deck)}"]
    for rows in deck.rows(r"\*RIGIDWALL_GEOMETRIC_CYLINDER.*"):
        at = 1 if len(rows) == 4 else 0
        axis, radius = [number(cell) for cell in rows[at + 1][:2]], number(rows[at + 2][0])
        off = [math.hypot(p[0] - axis[0], p[1] - axis[1]) - radius for p in points]
        if off:
            words.append(f"distance of its nodes from the rigid wall's cylinder (radius {radius:g}): "
                         f"{min(off):.4g} to {max(off):.4g}")
        words.append(f"nodes in the wall's set {rows[at][0][0]}: {len(in_node_set(deck, int(rows[at][0][0]), shells))}")
    return "; ".join(words)


def contacts(deck):
    """Each contact with its card 1, as written."""
    found = []
    for keyword, _, _, lines, _ in deck.blocks:
        if keyword.startswith("*CONTACT"):
            titled = "_ID" in keyword or "_TITLE" in keyword
            card = lines[2 if "MPP" in keyword else 1 if titled else 0] if len(lines) > titled else ""
            found.append(f"{keyword[9:]} {' '.join(card.split()[:4])}")
    return ", ".join(found) or "none"


def in_node_set(deck, wanted, shells):
    nodes = {node for corners in shells for node in corners}
    for rows in deck.rows(r"\*SET_NODE_LIST"):
        if int(rows[0][0]) == wanted:
            return nodes & {int(cell) for row in rows[1:] for cell in row if cell}
    return set()


# Time steps

def element_step(deck, shell):
    """0.9 L / c of a shell, L the area over the longest edge."""
    part, corners, _ = deck.shells[shell]
    density, young, poisson = deck.materials[deck.parts[part][1]]
    points = deck.points(corners)
    across = area(points) / (max(edges(points)) if len(points) == 4 else max(edges(points)) / 2)
    return 0.9 * across / math.sqrt(young / (density * (1 - poisson ** 2)))


def node_masses(deck):
    mass = {}
    for part, corners, thickness in deck.shells.values():
        density = deck.materials[deck.parts[part][1]][0]
        for node in corners:
            mass[node] = mass.get(node, 0) + density * thickness * area(deck.points(corners)) / len(corners)
    return mass


def stiffness(deck, shell, printed):
    """Of the contact spring: over the shorter diagonal or the thickness as printed, else over the longer diagonal."""
    part, corners, thickness = deck.shells[shell]
    _, young, poisson = deck.materials[deck.parts[part][1]]
    p = deck.points(corners if len(corners) == 4 else [*corners, corners[2]])
    diagonals = [length(minus(p[2], p[0])), length(minus(p[3], p[1]))]
    across = max(thickness, min(diagonals)) if printed else max(diagonals)
    return 0.1 * young / (3 * (1 - 2 * poisson)) * area(p) / across


def contact_step(deck, parts, printed):
    """The least sqrt(m / (2 k)) over the nodes of shells, and its node."""
    mass, weight, sum_of = node_masses(deck), {}, {}
    for shell, (part, corners, _) in deck.shells.items():
        if part in parts:
            share = area(deck.points(corners)) / 4
            for node in corners if len(corners) == 4 else [*corners, corners[2]]:
                weight[node] = weight.get(node, 0) + share
                sum_of[node] = sum_of.get(node, 0) + share * stiffness(deck, shell, printed)
    return min((math.sqrt(mass[n] / (2 * sum_of[n] / weight[n])), n) for n in weight if mass[n] > 0)


def steps(deck, finding):
    def both():
        run, shell = min((element_step(deck, s), s) for s, (p, _, _) in deck.shells.items() if p != 6)
        stable, node = contact_step(deck, {finding["part"]}, printed=False)
        return f"stable below {2 * stable:.4g} (node {node}), run {run:.4g} (shell {shell})"
    printed, _ = contact_step(deck, {finding["part"]}, printed=True)
    at_node = [(s, p, t) for s, (p, corners, t) in deck.shells.items() if finding["node"] in corners]
    words = f"{both()}, printed {printed:.4g}; shells (id, part, thickness) of node {finding['node']}: {at_node}"
    deck.set_parameters(tbumper="3", thood="1")
    words += f"; with the thickness of 3 and 1 that car6 has: {both()}"
    deck.set_parameters(tbumper="0", thood="0")
    return words


def eroding(deck, finding):
    step, node = contact_step(deck, {2}, printed=True)
    named = [keyword for keyword, *_ in deck.blocks if keyword.startswith("*CONTROL_CONTACT")]
    return f"contact prints {step:.4g} (node {node}); *CONTROL_CONTACT: {len(named)}"


# Solids

def outer_faces(deck, parts):
    count = {}
    for solid, (part, corners) in deck.solids.items():
        if part in parts:
            for face in FACES:
                nodes = list(dict.fromkeys(corners[i] for i in face))
                if len(nodes) >= 3:
                    count.setdefault(frozenset(nodes), []).append((solid, nodes))
    return [found[0] for found in count.values() if len(found) == 1]


def fold(first, second, deck):
    """Degrees between two segments at their common edge."""
    edge = [node for node in first if node in second]
    a, b = deck.points(edge[:2])
    along = times(1 / length(minus(b, a)), minus(b, a))
    arms = []
    for corners in (first, second):
        arm = minus(middle(deck.points([node for node in corners if node not in edge])), a)
        arms.append(minus(arm, times(dot(arm, along), along)))
    return math.degrees(math.atan2(length(cross(*arms)), dot(*arms)))


def corner(deck, finding):
    faces = [[int(word) for word in words.split()] for words in re.findall(r"face ((?:\d+ )+)", finding["message"])]
    if len(faces) == 2:
        part, solid = deck.solids[finding["element"]][0], finding["element"]
        outer = {frozenset(nodes) for _, nodes in outer_faces(deck, {part})}
        known = all(frozenset(face) in outer for face in faces)
        return f"solid {solid}: {fold(*faces, deck):.3g} degrees; both faces outside: {known}; " \
               f"solids with two outer faces below 30 degrees: {sharp_solids(deck, part)} of part {part}"
    part = finding["element_part"]
    return f"pairs of shells of part {part} below 30 degrees: {sharp_shells(deck, part)}"


def sharp_solids(deck, part):
    outer = {}
    for solid, nodes in outer_faces(deck, {part}):
        outer.setdefault(solid, []).append(nodes)
    return sum(any(len(set(a) & set(b)) == 2 and fold(a, b, deck) < 30 for i, a in enumerate(faces) for b in faces[:i])
               for faces in outer.values())


def sharp_shells(deck, part):
    at_edge = {}
    for shell, (own, corners, _) in deck.shells.items():
        if own == part:
            for i, node in enumerate(corners):
                at_edge.setdefault(frozenset((node, corners[i - 1])), []).append(corners)
    angles = [fold(a, b, deck) for found in at_edge.values() for i, a in enumerate(found) for b in found[:i]
              if len(set(a) & set(b)) == 2]
    sharp = [angle for angle in angles if angle < 30]
    return f"{len(sharp)}, least {min(sharp):.4g}"


def free_nodes(deck, finding):
    used = {n for _, corners in deck.solids.values() for n in corners}
    used |= {n for _, corners, _ in deck.shells.values() for n in corners}
    named = set()
    for keyword, _, _, lines, _ in deck.blocks:
        if not re.match(r"\*(NODE|ELEMENT)", keyword):
            named |= {int(word) for line in lines for word in re.findall(r"\b\d+\b", line)}
    free = set(deck.nodes) - used
    return f"{len(deck.nodes)} nodes, {len(free)} in no element, {len(free - named)} of them named nowhere else; " \
           f"{len(deck.solids)} solids, {len(deck.shells)} shells; first {min(free - named, default=0)}"


def apart(deck, finding):
    """The ranges of two solids and of their parts along the axis on which they overlap least."""
    first, second = [int(word) for word in re.findall(r"solid (\d+)", finding["message"])]
    overlaps = []
    for axis in range(3):
        low_a, high_a = extent(deck, deck.solids[first][1], axis)
        low_b, high_b = extent(deck, deck.solids[second][1], axis)
        overlaps.append((min(high_a, high_b) - max(low_a, low_b), axis))
    least, axis = min(overlaps)
    words = [f"overlap of the boxes along {'xyz'[axis]}: {least:.6g}"]
    for part in (deck.solids[first][0], deck.solids[second][0]):
        nodes = {node for p, corners in deck.solids.values() if p == part for node in corners}
        words.append("part {}: {:.10g} to {:.10g}".format(part, *extent(deck, nodes, axis)))
    return "; ".join(words)


def extent(deck, nodes, axis):
    values = [deck.nodes[node][axis] for node in nodes]
    return min(values), max(values)


# What the deck says

def blocks_named(pattern):
    def answer(deck, finding):
        found = [f"{keyword} line {line} of {path.name}, {len(lines)} lines: {' / '.join(lines)[:150].strip()}"
                 for keyword, path, line, lines, _ in deck.blocks if re.match(pattern, keyword)]
        return " || ".join(found[:8])
    return answer


def sides(deck, finding):
    """What card 1 of the contact names, and what the deck has."""
    for keyword, _, _, lines, _ in deck.blocks:
        titled = "_ID" in keyword or "_TITLE" in keyword
        if keyword.startswith("*CONTACT") and (not titled or not lines[0][:10].strip()
                                               or int(lines[0][:10]) == finding["contact"]):
            card = lines[2 if "MPP" in keyword else 1 if titled else 0]
            return f"card 1: {' '.join(card.split()[:4]) or 'blank'}; the deck has {len(deck.nodes)} nodes, " \
                   f"{len(deck.shells)} shells, {len(deck.solids)} solids; {len(deck.missing)} includes missing"
    return "no such contact"


def missing(deck, finding):
    name = re.search(r'"(.*?)"', finding["message"])[1]
    return f"include {name}: found {name not in deck.missing}; {len(deck.missing)} includes missing"


def reference(deck, finding):
    words = re.findall(r"\d+", finding["message"])
    parts = [int(word) for word in words if int(word) in deck.parts]
    nodes = [int(word) for word in words if int(word) in deck.nodes]
    return f"{len(deck.nodes)} nodes, {len(deck.parts)} parts; of the ids {words[:10]}: parts {parts}, nodes {nodes}" \
           f"; missing includes: {len(deck.missing)}"


def duplicates(deck, finding):
    kind, identity = re.match(r"(\w+(?: set)?) (\d+)", finding["message"]).groups()
    pattern = {"curve": r"\*DEFINE_CURVE", "part set": r"\*SET_PART", "node set": r"\*SET_NODE"}[kind]
    found = [f"line {line} of {path.name} in case {case}" for keyword, path, line, lines, case in deck.blocks
             if re.match(pattern, keyword) and identity in [words.split()[0] for words in lines if words.split()]]
    return f"{kind} {identity}: " + "; ".join(found)


CHECKS = {
    "GC101": penetration, "GC102": penetration, "GC103": apart, "GC111": same_nodes, "GC302": limited,
    "GC307": conflict, "GC308": free_thickness,
    "GC401": blocks_named(r"\*CONTACT"), "GC412": blocks_named(r"\*CONTACT"),
    "GC415": uncontacted, "GC419": eroding, "GC420": steps, "GC421": count_penetrations,
    "GC501": duplicates, "GC502": reference, "GC503": sides, "GC506": sliver,
    "GC508": free_nodes, "GC512": corner, "GC516": blocks_named(r"\*SET_PART"), "GC901": missing,
}


def compare(program, decks, name, deck):
    """All penetrating nodes here and in the audit, and how many have the same depth."""
    listed = {finding["node"]: finding["penetration"]
              for finding in draw_findings.audit(program, decks / name, decks / name.split("/")[0])
              if finding["id"] in ("GC101", "GC102")}
    depths = {node: reach - d for node, (d, reach, _, _) in car(deck).all.items()}
    differ = [node for node in sorted(set(depths) & set(listed)) if abs(depths[node] - listed[node]) > 1e-6]
    return f"{name}: {len(depths)} nodes here, {len(listed)} in the audit, {len(set(depths) & set(listed))} in both; " \
           f"of other depth: {differ}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drawn", metavar="DRAWN.json", type=pathlib.Path)
    parser.add_argument("decks", metavar="DECKS", type=pathlib.Path)
    parser.add_argument("--program", metavar="GAPCHECK", help="compare all penetrating nodes with its audits")
    arguments = parser.parse_args()

    @functools.lru_cache(maxsize=None)
    def read(name):
        case = arguments.decks / name.split("/")[0]
        folders = sorted({path.parent for path in case.rglob("*") if path.is_file()})
        return Deck(arguments.decks / name, folders)

    drawn = json.loads(arguments.drawn.read_text())
    for at, finding in enumerate(drawn, 1):
        check = CHECKS.get(finding["id"])
        answer = check(read(finding["deck"]), finding) if check else "no calculation for this rule"
        print(f"{at} {finding['deck']} {finding['id']}: {answer}", flush=True)
    if arguments.program:
        for name in sorted({finding["deck"] for finding in drawn if finding["id"] in ("GC308", "GC421")}):
            print(compare(arguments.program, arguments.decks, name, read(name)), flush=True)


if __name__ == "__main__":
    main()
