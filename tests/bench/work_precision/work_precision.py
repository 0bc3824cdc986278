#!/usr/bin/env python3
"""Builds and runs gapcheck_work_precision and rewrites the tables of docs/accuracy.md, its figures (SVG) and its data
(JSON) in docs/accuracy/. One command, half a minute after the build.

usage: work_precision.py [--program PATH] [--pairs 2000] [--rounds 25]
"""

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests" / "bench"))
from page import machine, section  # noqa: E402

from plot import svg  # noqa: E402

PLAIN = ["two triangles", "four triangles", "closed form"]
NEWTON = [f"Newton {i}" for i in range(1, 7)]
CERTIFIED = ["certified", "certified batches"]
IN_BOTH = PLAIN + ["Newton 2", "Newton 4", "Newton 6"]  # precisions
COLUMNS = IN_BOTH + CERTIFIED
COLOURS = {"two triangles": "#c0392b", "four triangles": "#d68910", "closed form": "#8e44ad", "Newton": "#1f4e9c",
           "certified": "#2e8b57",
           "certified batches": "#82c99d"}
ANGLES = [1, 5, 10, 20, 40]
BITS = 1e-17  # where errors of no bits at all are drawn


def build():
    folder = ROOT / "build" / "bench"
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DGAPCHECK_BENCH=ON",
                    "-DGAPCHECK_TESTS=OFF"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "gapcheck_work_precision"], check=True, stdout=sys.stderr)
    return folder / "tests/bench/work_precision/gapcheck_work_precision"


class Data:
    def __init__(self, text):
        self.raw = json.loads(text)
        self.families = self.raw["families"]
        self.by_name = {family["name"]: family for family in self.families}

    def of(self, family, method, precision="double"):
        for entry in family["methods"]:
            if entry["name"] == method and entry["precision"] == precision:
                return entry
        raise SystemExit(f"no figures of {method} in {precision}")

    def group(self, name):
        return [family for family in self.families if family["group"] == name]


# Figures ------------------------------------------------------------------------------------------------------------

def against_time(data, families):
    """Largest error in any of the families against the median of their times."""

    def place(method, precision):
        entries = [data.of(family, method, precision) for family in families]
        return (statistics.median(entry["ns"] for entry in entries), max(entry["largest"] for entry in entries),
                method.split()[-1] if method.startswith("Newton") else "")

    series = []
    for precision in ("double", "float"):
        hollow = precision == "float"
        for method in PLAIN:
            series.append({"label": f"{method}, {precision}", "colour": COLOURS[method], "hollow": hollow,
                           "points": [place(method, precision)]})
        series.append({"label": f"Newton, {precision}", "colour": COLOURS["Newton"], "hollow": hollow, "line": True,
                       "dash": hollow, "points": [place(method, precision) for method in NEWTON]})
    for method in CERTIFIED:
        series.append({"label": method, "colour": COLOURS[method], "points": [place(method, "double")]})
    highest = max(p[1] for one in series for p in one["points"])
    return svg(series, "ns per pair (depth and decision)", "largest depth error / longest side", BITS, max(1, highest),
               x_low=10)


def off_by_warp(angle):
    """How far the two triangles of a diagonal leave the patch of a square, by its side."""
    return math.tan(math.radians(angle) / 2) / (2 * math.sqrt(2))


def against_warp(data):
    def curve(method):
        return [(angle, data.of(data.by_name[f"warped {angle}°"], method)["largest"], "") for angle in ANGLES]

    series = [{"label": "tan(w/2) / √8", "colour": "#888", "line": True, "dash": True, "marker": False,
               "points": [(angle, off_by_warp(angle), "") for angle in ANGLES]}]
    shades = {"Newton 1": "#a9c4ee", "Newton 2": "#7ba3de", "Newton 3": "#4a78c4", "Newton 4": "#1f4e9c"}
    for method in PLAIN + list(shades) + ["certified"]:
        series.append({"label": method, "colour": COLOURS.get(method) or shades[method], "line": True,
                       "points": curve(method)})
    return svg(series, "warp w [degrees]", "largest depth error / longest side", BITS, 1, x_low=1, x_high=100)


# Tables -------------------------------------------------------------------------------------------------------------

def percent(count, pairs):
    return "0" if count == 0 else f"{100 * count / pairs:.2g} %"


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(row) + " |" for row in rows]


def by_family(data, value, columns, precision="double"):
    return table(["family"] + columns,
                 [[family["name"]] + [value(data.of(family, column, precision), family) for column in columns]
                  for family in data.families])


def warp_table(data):
    rows = []
    for angle in ANGLES:
        family = data.by_name[f"warped {angle}°"]
        two, four = data.of(family, "two triangles"), data.of(family, "four triangles")
        rows.append([f"{angle}°", f"{off_by_warp(angle):.4f}", f"{two['largest']:.4f}",
                     percent(two["wrong"], family["pairs"]), f"{off_by_warp(angle) / 4:.4f}", f"{four['largest']:.4f}",
                     percent(four["wrong"], family["pairs"])])
    return table(["warp w", "two triangles: tan(w/2)/√8", "measured", "wrong decisions", "four triangles: a quarter",
                  "measured", "wrong decisions"], rows)


def summary(data):
    """Over all families: the worst, and times on the usual ones."""
    usual, hard = data.by_name["warped 10°"], data.by_name["on the bound, warped 10°"]
    methods = ([(name, precision) for name in IN_BOTH for precision in ("float", "double")] +
               [(name, "double") for name in CERTIFIED])
    rows = []
    for name, precision in methods:
        entries = [(data.of(family, name, precision), family) for family in data.families]
        here, there = data.of(usual, name, precision), data.of(hard, name, precision)
        rows.append([name, precision, percent(here["wrong"], usual["pairs"]), f"{here['largest']:.1e}",
                     percent(there["wrong"], hard["pairs"]),
                     percent(sum(entry["wrong"] for entry, _ in entries), sum(f["pairs"] for _, f in entries)),
                     f"{max(entry['largest'] for entry, f in entries if f['group'] != 'scale'):.1e}",
                     f"{data.of(data.by_name['flat'], name, precision)['ns']:.0f}", f"{here['ns']:.0f}"])
    return table(["method", "precision", "wrong, warped 10°", "largest error there", "wrong, on the bound",
                  "wrong, all families", "largest error, all but offsets and sizes", "ns, flat", "ns, warped 10°"], rows)


def time_spread(data):
    widest = max((entry["ns_high"] - entry["ns_low"]) / entry["ns"] for f in data.families for entry in f["methods"])
    usual = statistics.median((e["ns_high"] - e["ns_low"]) / e["ns"] for f in data.families for e in f["methods"])
    return (f"Times are medians of {data.raw['rounds']} rounds, the methods in turn in every round; half of the rounds "
            f"lie within {100 * usual:.1f} % (median of all cases; widest {100 * widest:.0f} %).")


def price(data):
    """Of the proof, beside the method that comes nearest in accuracy."""
    rows = []
    for family in data.families:
        entry, six = data.of(family, "certified"), data.of(family, "Newton 6")
        rows.append([family["name"], f"{entry['ns']:.0f}", f"{data.of(family, 'decision alone')['ns']:.0f}",
                     f"{data.of(family, 'certified batches')['ns']:.0f}",
                     f"{six['ns']:.0f}", f"{entry['ns'] / six['ns']:.1f}", f"{family['exact_ns']:,.0f}"])
    return table(["family", "certified: depth and decision", "decision alone", "in batches, depth of nearer nodes", "Newton 6", "certified / Newton 6",
                  "exact numbers from the start"], rows)


def everything(data):
    counts = ", ".join(f"{family['name']}: {family['pairs']:,}" for family in data.families
                       if family["pairs"] != data.raw["count"])
    parts = [f"{data.raw['count']:,} pairs in each family ({counts}, from {data.raw['decks']} decks). {time_spread(data)}",
             "", "Wrong decisions, double:", ""]
    parts += by_family(data, lambda e, f: percent(e["wrong"], f["pairs"]), COLUMNS)
    parts += ["", "Wrong decisions, float:", ""]
    parts += by_family(data, lambda e, f: percent(e["wrong"], f["pairs"]), IN_BOTH, "float")
    for title, value in (("Largest depth error by the longest side", "largest"),
                         ("Root of the mean square depth error by the longest side", "rms"),
                         ("Median depth error in ulps of the contact distance", "median_ulps"),
                         ("Largest depth error in ulps of the contact distance", "largest_ulps")):
        parts += ["", f"{title}, double:", ""] + by_family(data, lambda e, f: f"{e[value]:.1e}", COLUMNS)
    parts += ["", "Largest depth error by the longest side, float:", ""]
    parts += by_family(data, lambda e, f: f"{e['largest']:.1e}", IN_BOTH, "float")
    parts += ["", "Nanoseconds per pair, double:", ""] + by_family(data, lambda e, f: f"{e['ns']:.0f}", COLUMNS)
    parts += ["", "Nanoseconds per pair, float:", ""]
    return parts + by_family(data, lambda e, f: f"{e['ns']:.0f}", IN_BOTH, "float")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, help="gapcheck_work_precision; built if not given")
    parser.add_argument("--pairs", type=int, default=2000, help="pairs in each family")
    parser.add_argument("--rounds", type=int, default=25)
    arguments = parser.parse_args()
    program = arguments.program or build()
    text = subprocess.run([program, ROOT / "data", str(arguments.pairs), str(arguments.rounds)], check=True,
                          capture_output=True, text=True).stdout
    data = Data(text)
    folder = ROOT / "docs" / "accuracy"
    folder.mkdir(exist_ok=True)
    (folder / "measured.json").write_text(text, encoding="utf-8")
    for group in sorted({family["group"] for family in data.families}):
        (folder / f"{group}.svg").write_text(against_time(data, data.group(group)), encoding="utf-8")
    (folder / "usual.svg").write_text(against_time(data, [data.by_name["warped 10°"]]), encoding="utf-8")
    (folder / "angle.svg").write_text(against_warp(data), encoding="utf-8")
    page = ROOT / "docs" / "accuracy.md"
    content = page.read_text(encoding="utf-8")
    for name, rows in (("summary", [machine() + ".", "", *summary(data)]), ("warp", warp_table(data)),
                       ("price", price(data)), ("everything", everything(data))):
        content = section(name, content, "\n".join(rows))
    page.write_text(content, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
