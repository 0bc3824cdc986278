#!/usr/bin/env python3
"""Rewrites the marked tables of docs/fix.md: fix_tables.py GAPCHECK [DECKS] [--small]

GAPCHECK is the program, DECKS a folder with decks by others; without it their table stays. Every corrected deck is
audited again before its row is written.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import page

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import make_fix_scenes

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "fix.md"

REAL = [
    ("car6", "car6/car6_crash.k", []),
    ("car6, `--free-welds`", "car6/car6_crash.k", ["--free-welds"]),
    ("car6, finer", "car6_refined/lsopt_car6/main_v22.k", []),
    ("car6, finer, `--free-welds`", "car6_refined/lsopt_car6/main_v22.k", ["--free-welds"]),
    ("car6, finest", "car6_refined/lsopt_car6/main_v222.k", []),
    ("car6, finest, `--free-welds`", "car6_refined/lsopt_car6/main_v222.k", ["--free-welds"]),
    ("ball_plate", "ball_plate/ball_plate.k", []),
    ("projectile", "small_decks/tests/testfiles/run/case-keywords/projectile.k", []),
    ("bird strike on a composite", "bird_strike_composite/input.k", []),
]
EXAMPLE = ["data/two_plates.k", "-o", "fixed", "--dry-run", "--top", "3"]
VERIFY = ["data/snlog_1.k", "--dry-run", "--verify", "--top", "0"]
PLAN = ["data/include_parameter.k", "--plan"]
REASONS = {"constrained": "boundary conditions, welds or other joints hold the nodes", "crossing": "elements would cross",
           "none": "no way out was found", "conflict": "what frees it from one segment pushes it into another",
           "shape": "an element would lose its shape"}
# The shoes come without the body whose contacts they take part in: here in a contact of their own.
SHOES = ["50F-standing/vivaplus-82-Shoes-50F_standing_nodes.k", "common/vivaplus-80-Shoes.k"]


def found(gapcheck, deck):
    """Nodes, corners of segments and edges that penetrate, and nodes in rigid walls, by an audit of the deck."""
    out = subprocess.run([gapcheck, "audit", deck, "--select", "GC101,GC102,GC107,GC108,GC109,GC110", "--format", "json"],
                         capture_output=True, text=True).stdout
    report = json.loads(out)
    kinds = ("penetrations", "released", "segment_penetrations", "mortar_penetrations", "edge_penetrations")
    walls = (f for f in report["findings"] if f["id"] == "GC110")
    return sum(c.get(kind, 0) for c in report["contacts"] for kind in kinds) + sum(f.get("count", 1) for f in walls)


def corrected(gapcheck, deck, options=()):
    """The report of a correction, and the findings of audits before and after."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([gapcheck, "fix", deck, "-o", folder, "--format", "json", *options],
                             capture_output=True, text=True)
        if run.returncode == 2:
            raise SystemExit(f"{deck}: {run.stderr}")
        report = json.loads(run.stdout)
        whole = pathlib.Path(folder) / "whole"
        shutil.copytree(pathlib.Path(deck).parent, whole)
        for file in report["files"]:
            target = whole / pathlib.Path(file["written"]).relative_to(folder)
            target.chmod(0o644)
            shutil.copyfile(file["written"], target)
        return report, found(gapcheck, deck), found(gapcheck, whole / pathlib.Path(deck).name)


def row(name, result):
    report, before, after = result
    s = report["summary"]
    mean = f"{s['mean_move']:.4g}" if report["moved"] else "–"
    largest = f"{s['largest_move']:.4g}" if report["moved"] else "–"
    crossings = f"{s['crossings_before']} / {s['crossings_after']}"
    return (f"| {name} | {before} | {after} | {len(report['moved'])} | {largest} | {mean} | {s['elements_worsened']} | "
            f"{crossings} |")


def table(rows):
    head = ("| deck | nodes before | after | moved | largest move | mean | elements worse | crossings before / after |\n"
            "|---|---:|---:|---:|---:|---:|---:|---:|")
    return "\n".join([head, *rows])


def scenes(gapcheck, small):
    """The decks of data/fix: what is left, and why."""
    rows = ["| scene | nodes before | after | crossings before / after | largest move | mean | left, because |",
            "|---|---:|---:|---:|---:|---:|---|"]
    with tempfile.TemporaryDirectory() as folder:
        decks = sorted((ROOT / "data" / "fix").glob("*.k"))[:3 if small else None]
        for name, make in ({} if small else make_fix_scenes.LARGE).items():
            decks.append(pathlib.Path(folder) / f"{name}.k")
            decks[-1].write_text(make().text())
        results = [(deck, deck.read_text().splitlines()[2], *corrected(gapcheck, deck))
                   for deck in sorted(decks, key=lambda deck: deck.stem)]
    for deck, title, report, before, after in results:
        s = report["summary"]
        reasons = sorted({c["why"] for c in report["crossings"]})
        if report["unfixed"]:
            reasons += sorted({REASONS[node["reason"]] for node in report["unfixed"]} - set(reasons))
        moves = [f"{s['largest_move']:.4g}", f"{s['mean_move']:.4g}"] if report["moved"] else ["–", "–"]
        rows.append(f"| {title} (`{deck.stem}`) | {before} | {after} | "
                    f"{s['crossings_before']} / {s['crossings_after']} | {' | '.join(moves)} | {'; '.join(reasons)} |")
    return "\n".join(rows)


def shoes(gapcheck, decks):
    with tempfile.TemporaryDirectory() as folder:
        model = pathlib.Path(decks) / "shoes" / "model"
        text = "*KEYWORD\n"
        for name in SHOES:
            copy = pathlib.Path(folder) / pathlib.Path(name).name
            shutil.copyfile(model / name, copy)
            text += f"*INCLUDE\n{copy.name}\n"
        text += "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         1\n         0         0         5\n\n\n*END\n"
        main = pathlib.Path(folder) / "shoes.k"
        main.write_text(text)
        return row("shoes", corrected(gapcheck, main))


def example(gapcheck, options):
    out = subprocess.run([gapcheck, "fix", *options], capture_output=True, text=True, cwd=ROOT).stdout
    return "```\n$ gapcheck fix " + " ".join(options) + "\n" + out + "```"


def effect(pair, kind):
    """What is left between two parts, and what it costs; in brackets what is worse elsewhere."""
    repair = next((r for r in pair["repairs"] if r["kind"] == kind), None)
    if repair is None or "refused" in repair:
        return "–"
    worse = sum(repair["elsewhere"].values())
    return f"{repair['left']}{f' (+{worse})' if worse else ''} at {repair['cost']:.2f}"


def plans(gapcheck, decks):
    """The repairs of the real decks, and what the best of them leave."""
    rows = ["| deck | parts | penetrations | `move` | `optt` | `ignore` | `exclude` | best |", "|---|---|---:|---:|---:|---:|---:|---|"]
    for name, path, options in REAL:
        if options:
            continue
        run = subprocess.run([gapcheck, "fix", decks / path, "--plan", "--format", "json"], capture_output=True, text=True)
        plan = json.loads(run.stdout)
        for pair in plan["pairs"]:
            best = next((b for b in plan["best"] if b.startswith(f"{pair['number']}-")), None)
            effects = " | ".join(effect(pair, kind) for kind in ("move", "optt", "ignore", "exclude"))
            rows.append(f"| {name} | {pair['part']}, {pair['other_part']} | {pair['penetrations']} | {effects} | "
                        f"{f'`{best}`' if best else '–'} |")
    return "\n".join(rows)


def sheets(path, shells):
    """A tenth of the shells in two plates that penetrate with almost all of their nodes; the others in two far away."""
    near, far = round((shells / 20) ** 0.5), round((9 * shells / 20) ** 0.5)
    with open(path, "w") as out:
        out.write("*KEYWORD\n*MAT_ELASTIC\n         1   7.85e-9   210000.       0.3\n")
        for part, z, n in ((1, 0, near), (2, 0.7, near), (3, 50, far), (4, 100, far)):
            first = part * 10_000_000 + 1
            out.write(f"*PART\nplate\n{part:10}{part:10}         1\n*SECTION_SHELL\n{part:10}         2\n        1.\n*NODE\n")
            for j in range(n + 1):
                for i in range(n + 1):
                    out.write(f"{first + j * (n + 1) + i:8}{5 * i:16}{5 * j:16}{z:16}\n")
            out.write("*ELEMENT_SHELL\n")
            for j in range(n):
                for i in range(n):
                    a = first + j * (n + 1) + i
                    out.write(f"{first + j * n + i:8}{part:8}{a:8}{a + 1:8}{a + n + 2:8}{a + n + 1:8}\n")
        out.write("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n\n\n*END\n")
    return 2 * (near * near + far * far)


def speed(gapcheck, small):
    rows = ["| shells | nodes before | after | time | memory | time per node |", "|---:|---:|---:|---:|---:|---:|"]
    with tempfile.TemporaryDirectory() as folder:
        deck = pathlib.Path(folder) / "sheets.k"
        for shells in (10_000,) if small else (100_000, 300_000, 1_000_000):
            shells = sheets(deck, shells)
            before = found(gapcheck, deck)
            fixed = pathlib.Path(folder) / "fixed"
            seconds, _, memory = page.measure([gapcheck, "fix", str(deck), "-o", str(fixed), "--quiet"], 1 if small else 3)
            after = found(gapcheck, fixed / deck.name)
            rows.append(f"| {shells:,} | {before:,} | {after} | {seconds:.1f} s | {memory:.0f} MB | "
                        f"{1e6 * seconds / before:.0f} µs |")
    return "\n".join([*rows, "", page.machine() + "."])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("decks", type=pathlib.Path, nargs="?")
    parser.add_argument("--small", action="store_true", help="a few small decks, to test this script")
    arguments = parser.parse_args()
    gapcheck, small = arguments.gapcheck, arguments.small
    text = PAGE.read_text()
    text = page.section("example", text, example(gapcheck, EXAMPLE))
    text = page.section("verify", text, example(gapcheck, VERIFY))
    text = page.section("plan", text, example(gapcheck, PLAN))
    text = page.section("speed", text, speed(gapcheck, small))
    rows = []
    for deck in sorted((ROOT / "data").glob("*.k"))[:20 if small else None]:
        result = corrected(gapcheck, deck)
        if result[0]["moved"]:
            rows.append(row(f"`{deck.stem}`", result))
    text = page.section("data", text, table(rows))
    text = page.section("scenes", text, scenes(gapcheck, small))
    if arguments.decks:
        decks = arguments.decks
        rows = [row(name, corrected(gapcheck, decks / path, options)) for name, path, options in REAL]
        rows.append(shoes(gapcheck, decks))
        text = page.section("real", text, table(rows))
        text = page.section("plans", text, plans(gapcheck, decks))
    PAGE.write_text(text)


if __name__ == "__main__":
    main()
