#!/usr/bin/env python3
"""Rewrites the marked tables of docs/fix.md: fix_tables.py GAPCHECK [DECKS]

GAPCHECK is the program, DECKS a folder with decks by others; without it their table stays. Every corrected deck is
audited again before its row is written.
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import page

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
]
# The shoes come without the body whose contacts they take part in: here in a contact of their own.
SHOES = ["50F-standing/vivaplus-82-Shoes-50F_standing_nodes.k", "common/vivaplus-80-Shoes.k"]


def found(gapcheck, deck):
    """Nodes of GC101 and GC102 by an audit of the deck."""
    out = subprocess.run([gapcheck, "audit", deck, "--select", "GC101,GC102", "--format", "json"],
                         capture_output=True, text=True).stdout
    return sum(c["penetrations"] + c["released"] for c in json.loads(out)["contacts"])


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


def example(gapcheck):
    out = subprocess.run([gapcheck, "fix", "data/two_plates.k", "-o", "fixed", "--dry-run", "--top", "3"],
                         capture_output=True, text=True, cwd=ROOT).stdout
    return "```\n$ gapcheck fix data/two_plates.k -o fixed --dry-run --top 3\n" + out + "```"


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    gapcheck = str(pathlib.Path(sys.argv[1]).resolve())
    text = PAGE.read_text()
    text = page.section("example", text, example(gapcheck))
    rows = []
    for deck in sorted((ROOT / "data").glob("*.k")):
        result = corrected(gapcheck, deck)
        if result[0]["moved"]:
            rows.append(row(f"`{deck.stem}`", result))
    text = page.section("data", text, table(rows))
    if len(sys.argv) == 3:
        decks = pathlib.Path(sys.argv[2])
        rows = [row(name, corrected(gapcheck, decks / path, options)) for name, path, options in REAL]
        rows.append(shoes(gapcheck, decks))
        text = page.section("real", text, table(rows))
    PAGE.write_text(text)


if __name__ == "__main__":
    main()
