#!/usr/bin/env python3
"""Runs the decks of data/workshop/ with `PROGRAM run` and draws what their result files say, as the SVG files of
docs/workshop/."""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

from chart import TOP, svg

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIRST_UPPER_NODE = 2001  # of what is thrown or pushed
TIP = 2009  # a corner of the loaded edge of joined plates

# Result files -------------------------------------------------------------------------------------------------------


class Results:
    """Curves of one deck, as lists of (x, y)."""

    def __init__(self, program, name, folder):
        self.folder = pathlib.Path(folder) / name
        deck = ROOT / "data" / "workshop" / f"{name}.k"
        subprocess.run([program, "run", deck, "-o", self.folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)

    def text(self, file):
        return (self.folder / file).read_text(encoding="ascii")

    def height(self, node=None):
        """z of a node, of the first thrown one if none is given, over time, from nodout."""
        curve, time = [], None
        for line in self.text("nodout").splitlines():
            if found := re.search(r"at time\s*(\S+)\s*\)", line):
                time = float(found[1])
            elif line.startswith(f"{node or FIRST_UPPER_NODE:>9}") and len(line) > 150:
                curve.append((time, float(line[-12:])))
        return curve

    def tip(self, rest=0.0):
        """Deflection of the loaded edge, which lies `rest` high at the start."""
        return [(time, z - rest) for time, z in self.height(TIP)]

    def transducer(self, number):
        """z force on side A of a force transducer over time, from rcforc."""
        rows = re.findall(rf"^  SURFA +{number} time +(\S+) .* z +(\S+) mass", self.text("rcforc"), re.MULTILINE)
        return [(float(time), float(force)) for time, force in rows]

    def sliding_energy(self):
        """Over time, from glstat."""
        text = self.text("glstat")
        times = re.findall(r"^ time\.+\s*(\S+)", text, re.MULTILINE)
        energies = re.findall(r"^ sliding interface energy\.+\s*(\S+)", text, re.MULTILINE)
        return [(float(t), float(e)) for t, e in zip(times, energies, strict=True)]

    def force(self, speed):
        """Force on the upper body over its way: the sum of ncforc on its nodes."""
        curve = {}
        for block in self.text("ncforc").split("\n forces (t=")[1:]:
            time = float(block.split(")")[0])
            rows = [line for line in block.splitlines()[4:] if line.strip()]
            force = sum(float(line[44:58]) for line in rows[::2] if int(line[:10]) >= FIRST_UPPER_NODE)
            curve[time] = curve.get(time, 0) + force
        return [(speed * time, force) for time, force in curve.items()]


# The figures --------------------------------------------------------------------------------------------------------

def push_force(results):
    return results.force(speed=10.0)


# What is drawn, and the words at its axes.
HEIGHT_PLOT = (Results.height, "time [ms]", "height over the plate's mid-surface [mm]")
ENERGY_PLOT = (Results.sliding_energy, "time [ms]", "sliding energy [J]")
FORCE_PLOT = (push_force, "way of the upper body [mm]", "contact force [kN]")

STARTS = {"penetration_snlog_0": "IGNORE = 0, SNLOG = 0", "penetration_snlog_1": "IGNORE = 0, SNLOG = 1",
          "penetration_ignore_1": "IGNORE = 1"}

TIP_PLOT = (Results.tip, "time [ms]", "deflection of the loaded edge [mm]")
OFFSET_PLOT = (lambda results: results.tip(1.0), "time [ms]", "deflection of the loaded edge [mm]")

# Name of the file, what is drawn, decks with their labels, further arguments of svg().
FIGURES = [
    ("rebound_thickness", HEIGHT_PLOT,
     {"rebound_double": "SST = 2", "rebound_reference": "as it is: 1", "rebound_half": "SST = 0.5",
      "rebound_thin": "SST = 0.15: released"}, {}),
    ("rebound_stiffness", HEIGHT_PLOT,
     {"rebound_reference": "E ratio 1, SOFT = 0", "rebound_soft_plate": "E ratio 0.01, SOFT = 0: released",
      "rebound_soft_plate_soft_1": "E ratio 0.01, SOFT = 1"}, {}),
    ("push_curves", FORCE_PLOT,
     {"push_shell_shell": "A shell into shell", "push_shell_solid": "B shell into solid",
      "push_solid_solid": "C solid into solid", "push_shell_solid_sldthk": "D shell into solid, SLDTHK = 1"},
     {"legend": (400, TOP + 12)}),
    ("push_coat", FORCE_PLOT,
     {"push_shell_shell": "shells", "push_solid_solid": "solids", "push_solid_solid_sldthk": "solids, SLDTHK = 1"}, {}),
    ("push_mesh", FORCE_PLOT,
     {"push_shell_shell": "elements of 5: 13 nodes in contact",
      "push_shell_shell_fine": "elements of 2.5: 41 nodes in contact"}, {}),
    ("penetration_height", HEIGHT_PLOT, STARTS, {}),
    ("penetration_energy", ENERGY_PLOT, STARTS, {"legend": (300, 180)}),
    ("penetration_mid_face", HEIGHT_PLOT, {"penetration_mid_face": "starts 0.85 deep"},
     {"bands": ((-1.0, 1.0, "contact zone of the plate"), (-5.0, -3.0, "contact zone of the second plate"))}),
    ("ties_rotations", TIP_PLOT,
     {"joint_rotations": "type 7: with rotations", "joint_translations": "type 6: without"}, {}),
    ("ties_offset", OFFSET_PLOT,
     {"joint_offset": "type o7 (OFFSET)", "joint_beam_offset": "type b7 (BEAM_OFFSET)"}, {"legend": (400, 180)}),
    ("push_general", FORCE_PLOT,
     {"push_shell_shell": "type 13: released at 0.8", "push_general": "type 26"}, {}),
]


def transducer_figure(program, folder):
    """One run, three curves."""
    results = Results(program, "transducer_sum", folder)
    names = {2: "all on the upper plate", 3: "upper and left", 4: "upper and right"}
    return svg({label: results.transducer(number) for number, label in names.items()}, "time [ms]",
               "force along z [kN]")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="path of gapcheck")
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=ROOT / "docs" / "workshop")
    parser.add_argument("--small", action="store_true", help="one figure only, to test this script")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for name, (draw, x_label, y_label), decks, more in FIGURES[:1] if arguments.small else FIGURES:
            curves = {label: draw(Results(arguments.program, deck, folder)) for deck, label in decks.items()}
            (arguments.output / f"{name}.svg").write_text(svg(curves, x_label, y_label, **more), encoding="ascii")
        if arguments.small:
            return 0
        (arguments.output / "transducer_sum.svg").write_text(transducer_figure(arguments.program, folder),
                                                             encoding="ascii")
    return 0


if __name__ == "__main__":
    sys.exit(main())
