#!/usr/bin/env python3
"""The findings of a deck do not depend on the order of its rows.

    check_order.py GAPCHECK PROJECT [--seeds N] [DECK …]

Writes every deck of data/ (or the decks given) again with the rows of its nodes and elements, its parts and its
contacts in another order, and holds the findings of that deck against the original's: as a baseline, and rule by rule
with the ids that they name.
"""
import argparse
import collections
import json
import os
import random
import subprocess
import sys
import tempfile

# Blocks of which each row stands alone.
ROWS = {"NODE", "ELEMENT_SHELL", "ELEMENT_SOLID", "ELEMENT_BEAM", "ELEMENT_TSHELL", "ELEMENT_DISCRETE", "ELEMENT_MASS"}
# What may change places as a whole.
MOVABLE = ("PART", "SECTION", "MAT", "NODE", "ELEMENT", "SET_", "CONTACT")
# What is read in its place, or holds comments that concern the next lines.
STAYS = ("PARAMETER", "INCLUDE", "DEFINE_TRANSFORMATION")


def blocks_of(text):
    """The lines before the first keyword, and the blocks as lists of lines."""
    head, blocks = [], []
    for line in text.splitlines():
        if line.startswith("*"):
            blocks.append([line])
        elif blocks:
            blocks[-1].append(line)
        else:
            head.append(line)
    return head, blocks


def name_of(block):
    return block[0][1:].split()[0].upper() if len(block[0]) > 1 else ""


def shuffled_rows(block, chance):
    rows = [line for line in block[1:] if not line.startswith("$")]
    chance.shuffle(rows)
    return block[:1] + rows


def shuffled(text, seed, contacts_too):
    """The deck in another order; None if it holds what must stay in its place."""
    chance = random.Random(seed)
    head, blocks = blocks_of(text)
    if any(name_of(block).startswith(STAYS) for block in blocks):
        return None
    if any(line.startswith("$ gapcheck:") or line.startswith("$ gapcheck ") for block in blocks for line in block):
        return None
    named = all(name_of(b).endswith(("_ID", "_ID_MPP")) for b in blocks if name_of(b).startswith("CONTACT_"))
    result, places = [], []
    for block in blocks:
        name = name_of(block)
        if name in ROWS:
            block = shuffled_rows(block, chance)
        may_move = name.startswith(MOVABLE) and (not name.startswith("CONTACT_") or (contacts_too and named))
        if may_move:
            places.append(len(result))
        result.append(block)
    moved = [result[i] for i in places]
    chance.shuffle(moved)
    for place, block in zip(places, moved):
        result[place] = block
    return "\n".join(head + [line for block in result for line in block]) + "\n"


def audit(program, path, *more):
    run = subprocess.run([program, "audit", path, "--format", "json", "--fail-on", "never", *more],
                         capture_output=True, text=True)
    if run.returncode not in (0, 1):
        raise RuntimeError(f"{path}: exit code {run.returncode}: {run.stderr}")
    return json.loads(run.stdout)


def essence(report):
    """How often each rule names which contact, node, element and parts; lines and files differ."""
    keys = ("id", "severity", "contact", "node", "element", "part", "element_part", "segment", "count")
    found = collections.Counter()
    for listed in ("findings", "penetrations", "ties"):
        for one in report.get(listed, []):
            if "segment" in one:
                # A penetration: of equally near segments the solver takes the first.
                one = {k: v for k, v in one.items() if k not in ("segment", "element", "element_part")}
            found[json.dumps({k: sorted(one[k]) if isinstance(one[k], list) else one[k] for k in keys if k in one},
                             sort_keys=True)] += 1
    return found


def moves_nodes(report):
    return any("moved" in json.dumps(one) for one in report.get("findings", []) + report.get("penetrations", []))


def check(program, path, seeds, folder):
    """Differences in words."""
    with open(path, encoding="latin-1") as source:
        text = source.read()
    baseline = os.path.join(folder, "baseline")
    before = audit(program, path, "--write-baseline", baseline)
    wrong, decks = [], 0
    for seed in range(seeds):
        # The solver takes the contacts in turn, each on the nodes as the earlier ones have moved them.
        other = shuffled(text, seed, not moves_nodes(before))
        if other is None:
            return [], 0
        shuffled_path = os.path.join(folder, os.path.basename(path))
        with open(shuffled_path, "w", encoding="latin-1") as out:
            out.write(other)
        after = audit(program, shuffled_path, "--baseline", baseline)
        decks += 1
        for one in after.get("findings", []) + after.get("penetrations", []) + after.get("ties", []):
            if one.get("baseline") in ("new", "worse"):
                wrong.append(f"{path}, seed {seed}: {one['baseline']}: {one['id']} {one.get('message', '')}")
        for one in after.get("gone", []):
            wrong.append(f"{path}, seed {seed}: gone: {one.get('id')} {one.get('message', '')}")
        was, now = essence(before), essence(after)
        wrong += [f"{path}, seed {seed}: only in the original: {one}" for one in (was - now)]
        wrong += [f"{path}, seed {seed}: only in another order: {one}" for one in (now - was)]
    return wrong, decks


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("project")
    parser.add_argument("decks", nargs="*")
    parser.add_argument("--seeds", type=int, default=3)
    options = parser.parse_args()
    data = os.path.join(options.project, "data")
    decks = options.decks or sorted(os.path.join(data, n) for n in os.listdir(data) if n.endswith(".k"))
    decks += [] if options.decks else sorted(
        os.path.join(options.project, "tests/apps/order", n)
        for n in os.listdir(os.path.join(options.project, "tests/apps/order")) if n.endswith(".k"))
    wrong, checked = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for deck in decks:
            found, count = check(options.program, deck, options.seeds, folder)
            wrong += found
            checked += count
    print("\n".join(wrong))
    print(f"{checked} decks in another order, {len(wrong)} differences")
    if not options.decks and checked < 30 * options.seeds:
        print(f"only {checked} decks could be put into another order")
        return 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
