#!/usr/bin/env python3
"""Writes docs/theory/solver-accuracy.md from what the solver's tests measure.

    scripts/solver_accuracy.py BUILD/tests/solver/gapcheck_test_solver

The tests record their numbers as properties; this runs them and puts the numbers into a table.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "theory" / "solver-accuracy.md"

# Of each row: heading or (what, closed form or order expected, property).
ROWS = [
    "Orders of convergence",
    ("square plate of quads, simply supported, first frequency over h", "2", "plate_of_quads_6_12_24_order"),
    ("the same of fully integrated quads", "2", "plate_of_full_quads_6_12_24_order"),
    ("the same of triangles", "2", "plate_of_triangles_6_12_24_order"),
    ("beam of bricks, simply supported, first frequency over h", "2", "beam_of_bricks_2_4_8_layers_order"),
    ("rod of bricks, first frequency over h", "2", "rod_of_bricks_5_10_20_order"),
    ("positions of a vibrating strip of shells over dt", "2", "positions_over_dt_shells_order"),
    ("the same of bricks", "2", "positions_over_dt_bricks_order"),
    ("energy of the strip of shells, velocities at the time itself, over dt", "2", "energy_over_dt_shells_order"),
    ("the same of bricks", "2", "energy_over_dt_bricks_order"),
    ("time of contact of two rods over h", "1", "rods_contact_time_order"),
    ("deepest penetration over SFS, exponent", "-0.5", "penetration_over_SFS_exponent"),
    ("time of contact over SFS, exponent", "-0.5", "contact_time_over_SFS_exponent"),
    "Relative errors",
    ("plate of 6 x 6 quads, first frequency", "0", "plate_of_quads_6_12_24_error_1"),
    ("plate of 12 x 12", "0", "plate_of_quads_6_12_24_error_2"),
    ("plate of 24 x 24", "0", "plate_of_quads_6_12_24_error_3"),
    ("plate of 6 x 6 fully integrated quads", "0", "plate_of_full_quads_6_12_24_error_1"),
    ("plate of 12 x 12 fully integrated quads", "0", "plate_of_full_quads_6_12_24_error_2"),
    ("plate of 24 x 24 fully integrated quads", "0", "plate_of_full_quads_6_12_24_error_3"),
    ("plate of 2 x 6 x 6 triangles", "0", "plate_of_triangles_6_12_24_error_1"),
    ("plate of 2 x 12 x 12", "0", "plate_of_triangles_6_12_24_error_2"),
    ("plate of 2 x 24 x 24", "0", "plate_of_triangles_6_12_24_error_3"),
    ("beam of 2 layers of bricks, first frequency", "0", "beam_of_bricks_2_4_8_layers_error_1"),
    ("4 layers", "0", "beam_of_bricks_2_4_8_layers_error_2"),
    ("8 layers", "0", "beam_of_bricks_2_4_8_layers_error_3"),
    ("rod of 5 bricks, first frequency", "0", "rod_of_bricks_5_10_20_error_1"),
    ("rod of 10", "0", "rod_of_bricks_5_10_20_error_2"),
    ("rod of 20", "0", "rod_of_bricks_5_10_20_error_3"),
    ("bar of bricks pulled by 15 %, material 024: largest error of the force", "0", "pulled_bar_bricks_024_largest_error"),
    ("the same, material 003", "0", "pulled_bar_bricks_003_largest_error"),
    ("bar of shells, material 024", "0", "pulled_bar_shells_024_largest_error"),
    ("bar of shells, material 003", "0", "pulled_bar_shells_003_largest_error"),
    "Impacts",
    ("two rods of 20 bricks: time of contact against 2 L / c, error", "0", "rods_contact_time_error_20"),
    ("40 bricks", "0", "rods_contact_time_error_40"),
    ("80 bricks", "0", "rods_contact_time_error_80"),
    ("two rods of 80 bricks: stress against ρ c v / 2, error", "0", "rods_stress_error_80"),
    ("rod against a wall: stress against ρ c v, error", "0", "rod_on_wall_stress_error"),
    ("rod against a wall: time of contact, error", "0", "rod_on_wall_contact_time_error"),
    ("ball on a plate (Hertz): exponent of the force over the approach", "1.5", "hertz_exponent"),
    ("ball on a plate: force over 4/3 E* √R δ^1.5, mean", "1", "hertz_constant_ratio"),
    "Block in a box, 100,000 cycles",
]
for kind, name in (("two_way", "two-way"), ("single", "single surface")):
    for start, text in (("shooting", "shooting nodes"), ("snlog", "SNLOG = 1")):
        key = f"long_impact_{kind}_{start}_"
        ROWS += [
            (f"{name}, {text}: least energy ratio", "1", key + "least_energy_ratio"),
            (f"{name}, {text}: largest energy ratio", "1", key + "largest_energy_ratio"),
            (f"{name}, {text}: contact energy left between impacts, in initial energies", "0", key + "contact_energy_error"),
            (f"{name}, {text}: error of the momentum", "0", key + "momentum_error"),
        ]

HEAD = """# What the solver's tests measure

`scripts/solver_accuracy.py` writes this page from a run of `gapcheck_test_solver`; no number is typed manually. The
tests assert orders and bounds; this is what they measure. Errors are relative to the closed form. Sources of the
models: `tests/solver/vibration_test.cpp`, `yield_test.cpp`, `impact_test.cpp`, `hertz_test.cpp`, `penalty_test.cpp`.
"""

TAIL = """
## How to read them

- The closed form of plate and beam is that of Mindlin and Timoshenko, with the rotational inertia of the real section.
- The plate moves by so little that membrane forces do not stiffen it: at 4 % of the thickness they would by 0.15 %.
- Rods touch with their end faces and separate when the wave returns; the contact springs delay that by about two
  elements, so the order is one.
- The ball's mesh is coarse: its zone of contact is a few bricks wide. The exponent is fitted between 40 % and 100 % of
  the approach. A half-space would give 1.5; a mesh whose nodes come into contact one by one gives more.
- The energy ratio includes the work of the contact, so it shows that the sum is conserved. The contact energy left
  between impacts shows whether springs give back what they took.
- The energy over dt uses kinetic energy from the mean of the velocities before and after. The sum that the solver
  reports, with their product, is constant to rounding.
"""

TESTS = "Vibration.*:*TimeStep.*:*PulledBar*:Impact.*:*LongImpacts*:Hertz.*:Penalty.*"
SMALL = "*PulledBar*"


def measured(program, names):
    """All recorded properties of one run."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "tests.json"
        subprocess.run([program, f"--gtest_filter={names}", f"--gtest_output=json:{output}", "--gtest_brief=1"], check=True)
        suites = json.loads(output.read_text())["testsuites"]
    found = {}
    for suite in suites:
        for test in suite["testsuite"]:
            found.update({key: value for key, value in test.items() if re.search(r"_(order|exponent|ratio|error)", key)})
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="TEST_SOLVER")
    parser.add_argument("--small", action="store_true", help="a few of the numbers only, to test this script")
    arguments = parser.parse_args()
    values = measured(arguments.program, SMALL if arguments.small else TESTS)
    if not values:
        sys.exit(f"{arguments.program}: no test has recorded anything")
    lines = [HEAD]
    unused = set(values)
    for row in ROWS:
        if isinstance(row, str):
            lines.append(f"\n## {row}\n\n| what | closed form | measured |\n|---|---|---|")
            continue
        what, wanted, key = row
        if key not in values:
            if arguments.small:
                continue
            sys.exit(f"no test has recorded {key}")
        unused.discard(key)
        lines.append(f"| {what} | {wanted} | {values[key]} |")
    if unused:
        sys.exit("not in the table: " + ", ".join(sorted(unused)))
    PAGE.write_text("\n".join(lines) + "\n" + TAIL)


if __name__ == "__main__":
    main()
