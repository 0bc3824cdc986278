#!/usr/bin/env python3
"""Runs gapcheck_solver_precision and rewrites the tables and the figure of docs/theory/solver-precision.md.

    tests/bench/solver_precision.py BUILD/tests/bench/gapcheck_solver_precision
"""

import json
import math
import pathlib
import subprocess
import sys

import page

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "theory"
ERRORS = [("contact_time", "time of contact", "#1f77b4"), ("velocity", "velocity given on", "#d62728"),
          ("energy", "energy", "#2ca02c")]


def percent(value):
    return f"{100 * value:+.3f} %"


def rods_table(runs):
    rows = ["| setting | cycles | time | time of contact | velocity given on | energy |", "|---|---|---|---|---|---|"]
    for run in runs:
        if not run["ended"]:
            rows.append(f"| {run['group']} = {run['value']:g} | ends after {run['cycles']:,} | | | | |")
            continue
        rows.append(f"| {run['group']} = {run['value']:g} | {run['cycles']:,} | {1e3 * run['seconds']:.1f} ms "
                    f"| {percent(run['contact_time'])} | {percent(run['velocity'])} | {percent(run['energy'])} |")
    return rows


def plates_table(runs):
    rows = ["| BSORT | cycles | searches | time | energy | largest difference of a position from BSORT = 1 |",
            "|---|---|---|---|---|---|"]
    for run in runs:
        name = run["value"] if run["value"] else "none: by margin"
        rows.append(f"| {name} | {run['cycles']:,} | {run['searches']:,} | {1e3 * run['seconds']:.1f} ms "
                    f"| {percent(run['energy'])} | {run['apart']:g} |")
    return rows


def boxes_table(runs):
    rows = ["| coordinates from | pairs | lost, rounded to nearest | lost, rounded outwards | added, rounded outwards |",
            "|---|---|---|---|---|"]
    for run in runs:
        rows.append(f"| {run['value']:g} | {run['pairs']:,} | {run['lost_nearest']:,} | {run['lost_outward']:,} "
                    f"| {run['more_outward']:,} |")
    return rows


def figure(runs):
    """Errors over cycles, both in logarithms, of the runs that differ in TSSFAC or SFS."""
    width, height, left, top, bottom = 640, 420, 70, 20, 60
    right = width - 190
    points = [(run["cycles"], abs(run[key]), key, run["group"]) for run in runs for key, _, _ in ERRORS
              if run["ended"] and run["group"] in ("TSSFAC", "SFS") and run[key] != 0]
    low_x, high_x = (f(math.log10(p[0]) for p in points) for f in (min, max))
    low_y, high_y = math.floor(min(math.log10(p[1]) for p in points)), math.ceil(max(math.log10(p[1]) for p in points))
    span_x = max(high_x - low_x, 0.1)

    def at(cycles, error):
        return (left + 15 + (right - left - 30) * (math.log10(cycles) - low_x) / span_x,
                height - bottom - (height - bottom - top) * (math.log10(error) - low_y) / max(high_y - low_y, 1))

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
           f'font-size="12">', f'<rect width="{width}" height="{height}" fill="white"/>']
    for power in range(low_y, high_y + 1):
        y = at(10 ** low_x, 10.0 ** power)[1]
        out.append(f'<line x1="{left}" x2="{right}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>'
                   f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">1e{power}</text>')
    for cycles in sorted({p[0] for p in points}):
        x = at(cycles, 10.0 ** low_y)[0]
        out.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{height - bottom}" y2="{height - bottom + 4}" stroke="black"/>')
    for cycles in (min(p[0] for p in points), max(p[0] for p in points)):
        x = at(cycles, 10.0 ** low_y)[0]
        out.append(f'<text x="{x:.1f}" y="{height - bottom + 18}" text-anchor="middle">{cycles:,}</text>')
    colors = {key: color for key, _, color in ERRORS}
    for cycles, error, key, group in points:
        x, y = at(cycles, error)
        if group == "TSSFAC":
            out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{colors[key]}"/>')
        else:
            out.append(f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" fill="none" '
                       f'stroke="{colors[key]}" stroke-width="2"/>')
    for i, (_, name, color) in enumerate(ERRORS):
        out.append(f'<text x="{right + 15}" y="{top + 20 + 20 * i}" fill="{color}">{name}</text>')
    out += [f'<text x="{right + 15}" y="{top + 90}">● TSSFAC</text>', f'<text x="{right + 15}" y="{top + 110}">□ SFS</text>',
            f'<text x="{(left + right) / 2}" y="{height - 15}" text-anchor="middle">cycles</text>',
            f'<text transform="translate(18,{(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">'
            'relative error</text>',
            f'<rect x="{left}" y="{top}" width="{right - left}" height="{height - bottom - top}" fill="none" '
            'stroke="black"/>', "</svg>"]
    return "\n".join(out) + "\n"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    output = subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout
    runs = [json.loads(line) for line in output.splitlines()]
    by_model = {name: [run for run in runs if run["model"] == name] for name in ("rods", "plates", "boxes")}
    path = DOCS / "solver-precision.md"
    text = path.read_text()
    text = page.section("machine", text, page.machine() + "; the fastest of three runs.")
    for name, table in (("rods", rods_table), ("plates", plates_table), ("boxes", boxes_table)):
        text = page.section(name, text, "\n".join(table(by_model[name])))
    path.write_text(text)
    (DOCS / "solver-precision.svg").write_text(figure(by_model["rods"]))


if __name__ == "__main__":
    main()
