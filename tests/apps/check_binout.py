#!/usr/bin/env python3
"""Holds the binout of gapcheck run --binout against the text files of the same run, with two readers of its own after
the description of the LSDA format: one goes through all records, one knows only the tables of symbols.

usage: check_binout.py GAPCHECK ROOT    exit code 0: good, 1: not
"""

import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

LETTERS = {1: "b", 2: "h", 3: "i", 4: "q", 5: "B", 6: "H", 7: "I", 8: "Q", 9: "f", 10: "d"}
CHANGE_DIRECTORY, DATA, SYMBOL, TABLE, END_OF_TABLE, OFFSET_OF_TABLE = 2, 3, 4, 5, 6, 7


class Lsda:
    """One file. Anything that the format does not allow raises."""

    def __init__(self, path):
        self.bytes = path.read_bytes()
        header, self.length, self.offset, self.command, self.type, little, floats, rest = self.bytes[:8]
        assert (header, floats, rest) == (8, 0, 0), self.bytes[:8]
        self.order = "<" if little else ">"
        self.start = header

    def number(self, at, size):
        return int.from_bytes(self.bytes[at:at + size], "little" if self.order == "<" else "big")

    def record(self, at):
        """Command, first byte of the content, first byte behind the record."""
        end = at + self.number(at, self.length)
        assert at + self.length + self.command <= end <= len(self.bytes), (at, end, len(self.bytes))
        return self.number(at + self.length, self.command), at + self.length + self.command, end

    def data(self, at):
        """Name and values of the data record at this byte."""
        command, at, end = self.record(at)
        assert command == DATA, command
        letter, name_length = LETTERS[self.number(at, self.type)], self.bytes[at + self.type]
        at += self.type + 1
        name = self.bytes[at:at + name_length].decode("ascii")
        values = self.bytes[at + name_length:end]
        count, left = divmod(len(values), struct.calcsize(letter))
        assert left == 0, name
        if letter == "b":
            return name, values.decode("latin-1")
        return name, list(struct.unpack(f"{self.order}{count}{letter}", values))

    def by_records(self):
        found, directory, at = {}, None, self.start
        while at < len(self.bytes):
            command, content, end = self.record(at)
            if command == CHANGE_DIRECTORY:
                directory = self.bytes[content:end].decode("ascii")
                assert directory.startswith("/"), directory
            elif command == DATA:
                name, values = self.data(at)
                assert (directory, name) not in found, "twice"
                found[directory, name] = values
            else:
                assert command in (TABLE, OFFSET_OF_TABLE), command
            at = end
        return found

    def by_symbols(self):
        found = {}
        command, content, _ = self.record(self.start)
        assert command == OFFSET_OF_TABLE
        table = self.number(content, self.offset)
        while table != 0:
            command, at, end = self.record(table)
            assert command == TABLE, command
            directory, order = None, []
            while True:
                command, content, behind = self.record(at)
                if command == END_OF_TABLE:
                    assert behind == end, "the table has another length than its records"
                    table = self.number(content, self.offset)
                    break
                if command == CHANGE_DIRECTORY:
                    directory = self.bytes[content:behind].decode("ascii")
                else:
                    assert command == SYMBOL, command
                    name_end = behind - self.type - 2 * self.offset
                    name = self.bytes[content:name_end].decode("ascii")
                    found_name, values = self.data(self.number(name_end + self.type, self.offset))
                    assert found_name == name and len(values) == self.number(behind - self.offset, self.offset)
                    found[directory, name] = values
                    order.append((directory, name))
                at = behind
            assert order == sorted(order)
        return found


def states(found, branch):
    """The arrays of each state, in order."""
    directories = sorted({d for d, _ in found if re.fullmatch(f"/{branch}/d[0-9]+", d)})
    assert directories == [f"/{branch}/d{i + 1:06}" for i in range(len(directories))], directories
    return [{name: values for (d, name), values in found.items() if d == directory} for directory in directories]


def same(printed, value, digits):
    """`printed` has this many significant digits."""
    text = float(printed)
    unit = 10.0 ** (math.floor(math.log10(abs(text))) - digits + 1) if text else 1e-300
    assert abs(text - value) <= 0.51 * unit or abs(text) == abs(value), (printed, value)
    return 1


GLSTAT = {"kinetic energy": "kinetic_energy", "internal energy": "internal_energy", "external work": "external_work",
          "sliding interface energy": "sliding_interface_energy", "total energy": "total_energy",
          "hourglass energy": "hourglass_energy", "total energy / initial energy": "energy_ratio", "time": "time",
          "time step": "time_step", "global z velocity": "global_z_velocity",
          "energy ratio w/o eroded energy": "energy_ratio_wo_eroded",
          "spring and damper energy": "spring_and_damper_energy"}


def check_glstat(found, text):
    compared = 0
    blocks = text.split(" dt of cycle")[1:]
    rows = states(found, "glstat")
    assert len(rows) == len(blocks), (len(rows), len(blocks))
    for row, block in zip(rows, blocks):
        same(block.split()[0], row["cycle"][0], 9)
        for label, value in re.findall(r"^ (\S.*?) ?\.+\s+(\S+)", block, re.M):
            if label in GLSTAT:
                compared += same(value, row[GLSTAT[label]][0], 6)
    assert compared == len(GLSTAT) * len(rows), compared
    return compared


def check_rcforc(found, text):
    compared, ids, sides = 0, found["/rcforc/metadata", "ids"], found["/rcforc/metadata", "side"]
    lines = [line.split() for line in text.splitlines() if line.startswith("  SURF")]
    rows = states(found, "rcforc")
    assert len(lines) == len(rows) * len(ids) and ids, (len(lines), len(rows), ids)
    for row, block in zip(rows, (lines[i:i + len(ids)] for i in range(0, len(lines), len(ids)))):
        for i, words in enumerate(block):
            assert words[0] == "SURF" + "AB"[sides[i]] and int(words[1]) == ids[i]
            printed = dict(zip(words[2::2], words[3::2]))
            compared += same(printed["time"], row["time"][0], 6)
            for axis in "xyz":
                compared += same(printed[axis], row[axis + "_force"][i], 6)
                compared += same(printed["m" + axis], row[axis + "_moment"][i], 6)
    return compared


def check_sleout(found, text):
    compared, ids = 0, found["/sleout/metadata", "ids"]
    assert found["/sleout/metadata", "single_sided"] == [0] * len(ids)
    blocks = text.split(" contact interface energy file, time=")[1:]
    rows = states(found, "sleout")
    assert len(rows) == len(blocks), (len(rows), len(blocks))
    for row, block in zip(rows, blocks):
        compared += same(block.split()[0], row["time"][0], 7)
        for i, line in enumerate(block.split("\n\n")[1].splitlines()):
            contact, a, b, friction = line.split()
            assert int(contact) == ids[i]
            compared += same(a, row["slave"][i], 4) + same(b, row["master"][i], 4)
            compared += same(friction, row["friction_energy"][i], 4)
        for label, name in (("total surfa side", "total_slave"), ("total surfb side", "total_master"),
                            ("total energy    ", "total_energy"), ("friction energy ", "total_friction")):
            compared += same(re.search(label + r"=\s*(\S+)", block)[1], row[name][0], 7)
    return compared


def check_nodout(found, text):
    compared, ids, rows = 0, found["/nodout/metadata", "ids"], states(found, "nodout")
    blocks = re.split(r" n o d a l   p r i n t.*\( at time", text)[1:]
    assert len(blocks) == 2 * len(rows), (len(blocks), len(rows))
    groups = (("_displacement", "_velocity", "_acceleration", "_coordinate"),
              ("_displacement", "_velocity", "_acceleration"))
    for k, block in enumerate(blocks):
        row, prefix = rows[k // 2], "r" if k % 2 else ""
        lines = block.splitlines()[3:3 + len(ids)]
        for i, line in enumerate(lines):
            assert int(line[:9]) == ids[i]
            names = [prefix + axis + group for group in groups[k % 2] for axis in "xyz"]
            for j, name in enumerate(names):
                compared += same(line[10 + 12 * j:22 + 12 * j], row[name][i], 6)
    return compared


def check_matsum(found, text):
    compared, ids, rows = 0, found["/matsum/metadata", "ids"], states(found, "matsum")
    names = {"inten": "internal_energy", "kinen": "kinetic_energy", "hgeng": "hourglass_energy",
             "eroded_ie": "eroded_internal_energy", "x-mom": "x_momentum", "y-mom": "y_momentum",
             "z-mom": "z_momentum", "x-rbv": "x_rbvelocity", "y-rbv": "y_rbvelocity", "z-rbv": "z_rbvelocity"}
    blocks = re.split(r"\n time =", text)[1:]
    assert len(blocks) == len(rows), (len(blocks), len(rows))
    for row, block in zip(rows, blocks):
        parts = block.split(" mat.#=")[1:]
        assert [int(part.split()[0]) for part in parts] == ids
        for i, part in enumerate(parts):
            printed = dict(re.findall(r"(\S+)=\s*(\S+)", part))
            for label, name in names.items():
                compared += same(printed[label], row[name][i], 5)
    assert found["/matsum/metadata", "legend_ids"] == sorted(ids)
    assert len(found["/matsum/metadata", "legend"]) == 80 * len(ids)
    return compared


CHECKS = {"glstat": check_glstat, "matsum": check_matsum, "nodout": check_nodout, "rcforc": check_rcforc,
          "sleout": check_sleout}
CARDS = "".join(f"*DATABASE_{name.upper()}\n 0.00625,%d\n" for name in CHECKS)


def run(gapcheck, folder, deck, *options):
    done = subprocess.run([gapcheck, "run", deck, "-o", folder, "--quiet", *options], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return {path.name for path in pathlib.Path(folder).iterdir()}


def metadata(found):
    for branch in CHECKS:
        about = {name: values for (d, name), values in found.items() if d == f"/{branch}/metadata"}
        assert len(about["title"]) == 80 and about["title"].startswith("gapcheck workshop rebound_thin")
        assert len(about["version"]) == 12 and len(about["date"]) == 10 and len(about["revision"]) == 10


def main():
    gapcheck, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        example = (root / "data/workshop/rebound_thin.k").read_text()
        # Two surfaces: those of a single one have no resultants.
        example, changed = re.subn(r"SINGLE_SURFACE_ID(\n.*\n) +0 +0 +5 +0",
                                   r"SURFACE_TO_SURFACE_ID\1         2         1         3         3", example)
        assert changed == 1
        example = re.sub(r"\*DATABASE_(GLSTAT|SLEOUT|NCFORC|NODOUT)\n.*\n", "", example)

        def deck(binary):
            path = folder / f"binary_{binary}.k"
            path.write_text(example.replace("*TITLE", CARDS % ((binary,) * len(CHECKS)) + "*TITLE"))
            return path

        text_only = run(gapcheck, folder / "text", deck(1))
        assert "binout0000" not in text_only
        only = run(gapcheck, folder / "only", deck(2))
        assert "binout0000" in only and not only & set(CHECKS), only
        both = run(gapcheck, folder / "both", deck(3))
        assert both == text_only | {"binout0000"}, both
        option = run(gapcheck, folder / "option", deck(2), "--binout")
        assert option == both, option
        binout = (folder / "both/binout0000").read_bytes()
        for other in ("only", "option"):
            assert (folder / other / "binout0000").read_bytes() == binout, other
        file = Lsda(folder / "both/binout0000")
        found = file.by_records()
        assert found == file.by_symbols(), "the symbols are not the records"
        metadata(found)
        for branch, check in CHECKS.items():
            texts = [(folder / place / branch).read_text() for place in ("text", "both", "option")]
            assert texts[0] == texts[1] == texts[2], branch
            assert check(found, texts[0]) > 40, branch
        # The same curves under the same names, whatever file they come from; times of text are rounded.
        for one, other in (("text", "only"), ("only", "text")):
            done = subprocess.run([gapcheck, "compare", folder / one, folder / other], capture_output=True, text=True)
            assert done.returncode == 0 and "curves: 50 compared, 0 differ" in done.stdout, done.stdout + done.stderr
            assert not re.search(r"(only|no curve) (in|of) [AB]", done.stdout), done.stdout
        # A second run replaces the first one; without a binout it leaves none behind.
        assert run(gapcheck, folder / "both", deck(1)) == text_only
    print("binout and text agree")
    return 0


if __name__ == "__main__":
    sys.exit(main())
