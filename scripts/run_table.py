"""What the solver makes of every deck of a folder: for solver_runs.py."""
import pathlib
import re
import subprocess

from state_energy import notes

ENDINGS = (".k", ".key", ".dyn")
CYCLES = 4000
# Values that an optimiser was to fill in.
GIVEN = {"car5.k": ["--param", "tbumper=3", "--param", "thood=1"]}
# What a deck lacks before anything could run it; patterns of messages, and what the table says.
PIECES = (
    (r"the deck has no nodes", "no nodes"),
    (r'include "[^"]*" was not found', "includes are not at hand"),
    (r"the parameter \"[^\"]*\" is not defined", "parameters are not defined"),
    (r"has no part, section or material", "elements without part, section or material"),
    (r"the deck gives no end time", "no end time"),
    (r"the time step at time 0 is inf", "no element that can be deformed"),
    (r"\d numbers in one field", "a field with two numbers"),
)
BEGIN, END = "<!-- decks: begin -->", "<!-- decks: end -->"


def decks_of(folder):
    """Files that no other file of the folder includes; templates of single keywords are left out."""
    files = [p for p in sorted(folder.rglob("*")) if p.suffix.lower() in ENDINGS and "keyword_templates" not in p.parts]
    included = set()
    for path in files:
        lines = path.read_text(encoding="latin-1").splitlines()
        for line, following in zip(lines, lines[1:]):
            if re.match(r"\*INCLUDE(_TRANSFORM)?\s*$", line, re.IGNORECASE):
                included.add((path.parent / following.strip()).resolve())
    return [p for p in files if p.resolve() not in included]


def end_time(path):
    found = re.search(r"^\*CONTROL_TERMINATION[^\n]*\n(?:\$[^\n]*\n)*([^\n]*)", path.read_text(encoding="latin-1"),
                      re.MULTILINE | re.IGNORECASE)
    field = re.match(r"\s*[-+0-9.eE]+", found[1].split(",")[0][:10]) if found else None
    text = re.sub(r"(?<=[0-9.])([-+])", r"e\1", field[0].strip()) if field else ""
    try:
        return float(text)
    except ValueError:
        return None


def eroded(results):
    """Energy of failed elements at the end, as a share of the total, from glstat; text."""
    path = results / "glstat"
    text = path.read_text(encoding="ascii") if path.exists() else ""

    def last(label):
        found = re.findall(rf"^ {label}[ .]*\.\s*(\S+)", text, re.MULTILINE)
        return float(found[-1]) if found else 0.0
    energy = sum(last(f"eroded {kind} energy") for kind in ("kinetic", "internal", "hourglass"))
    return f"{100 * energy / last('total energy'):.1f} %" if energy else "–"


def without_viscosity(program, deck, folder, cycles):
    """The energy ratio of the deck with a bulk viscosity near zero; text."""
    path = pathlib.Path(folder).parent / "without_viscosity.k"
    path.write_text(f"*KEYWORD\n*CONTROL_BULK_VISCOSITY\n    1.0E-9    1.0E-9\n*INCLUDE\n{deck.name}\n*END\n", encoding="ascii")
    done = subprocess.run([program, "run", path, "-o", folder, "--force", "--jobs", "1", "--cycles", str(cycles), "-I", deck.parent,
                           *GIVEN.get(deck.name, ())], capture_output=True, text=True, check=False)
    found = re.search(r"^  energy ratio +(\S+)", done.stdout, re.MULTILINE)
    return found[1] if done.returncode == 0 and found else "–"


def unsupported(messages):
    """Keywords with the reason, each once, in the order of the deck."""
    found = {}
    for name, why in re.findall(r"error: .*?: (\*\S+) is not supported: (.*)", messages):
        why = re.sub(r"^(material|contact|wall|equation of state) \d+:? ?", "", why)
        found.setdefault(name, "" if "does not know" in why or "is of no kind" in why else why)
    return found


def largest_force(results):
    """Of the resultants of rcforc; None: there are none (single surface, or no contact)."""
    path = results / "rcforc"
    text = path.read_text(encoding="ascii") if path.exists() else ""
    forces = [sum(float(c) ** 2 for c in row) ** 0.5
              for row in re.findall(r"^  SURFA.*? x +(\S+) +y +(\S+) +z +(\S+)", text, re.MULTILINE)]
    return max(forces, default=None)


def tried(program, deck, root, folder, cycles):
    """(kind, row) of a deck: kind is runs, refused or piece."""
    name = f"`{deck.relative_to(root)}`"
    done = subprocess.run([program, "run", deck, "-o", folder, "--force", "--jobs", "1", "--cycles", str(cycles),
                           *GIVEN.get(deck.name, ())], capture_output=True, text=True, check=False)
    messages = done.stderr
    if done.returncode == 0:
        time, count = re.search(r"at time (\S+), cycle (\d+)", done.stdout).groups()
        ratio, by_state = (re.search(rf"^  {label} +(\S+)", done.stdout, re.MULTILINE)[1] for label in ("energy ratio", "by the state"))
        end, force, share, parted = end_time(deck), largest_force(folder), eroded(folder), notes(done.stdout)
        # The missing work is looked for where it is more than half a percent.
        other = without_viscosity(program, deck, folder, cycles) if abs(float(ratio) - 1) > 0.005 else "–"
        reached = "its end" if "Normal end" in done.stdout else f"{100 * float(time) / end:.1f} %" if end else "–"
        return "runs", (f"| {name} | {float(time.rstrip(',')):.4g} | {reached} | {int(count):,} | {ratio} | {other} | {by_state} | "
                        f"{parted} | {share} | "
                        f"{'–' if force is None else f'{force:.4g}'} |")
    # A deck that lacks something is a piece, whatever else it has: nothing could run it.
    lacks = [what for pattern, what in PIECES if re.search(rf"error: .*{pattern}", messages)]
    names = unsupported(messages)
    if lacks:
        return "piece", f"| {name} | {', '.join(lacks)} |"
    if names:
        words = "; ".join(f"`{k}`" + (f": {why}" if why else "") for k, why in names.items())
        return "refused", f"| {name} | {words} |"
    first = next((line for line in messages.splitlines() if "error" in line), messages.strip()[:200])
    return "refused", f"| {name} | {first.split(': ', 2)[-1]} |"


def section(program, root, folder, cycles=CYCLES, most=None):
    """Markdown of the section."""
    rows = {"runs": [], "refused": [], "piece": []}
    for deck in decks_of(root)[:most]:
        kind, row = tried(program, deck, root, pathlib.Path(folder) / "all", cycles)
        rows[kind].append(row)
    listed = {kind: "\n".join(lines) for kind, lines in rows.items()}
    return f"""{BEGIN}
## All decks

Every deck at hand that no other deck includes, for at most {cycles:,} cycles; car5 with parameters (bumper 3, hood 1).
"Reached" is the share of the deck's end time. The force is the largest resultant of a contact with two sides.

The energy ratio leaves out the work of the bulk viscosity, which shocks dissipate, as LS-DYNA's does. Where it is more than 0.5 %
from 1, the deck has run once more with Q1 = Q2 = 10⁻⁹: a ratio of 1 there says that the balance lacks nothing else. With
HGEN = 1, the default, it lacks the work against hourglassing too, as that of `00run2.key` does. "By the state"
counts both ([energy of the state](theory/state-energy.md)), and shows what elements and contacts create. "Eroded" is the energy
of failed elements as a share of the total, which contains it, as in LS-DYNA: failing does not change the ratio.

| deck | time | reached | cycles | energy ratio | without bulk viscosity | by the state | who parts from the works | eroded | contact force |
|---|---:|---:|---:|---:|---:|---:|---|---:|---:|
{listed["runs"]}

These {len(rows["refused"])} decks need what LS-DYNA has and the solver does not: it names the keywords, with file and line, before the first
cycle. Some of them are pieces as well.

| deck | refused for |
|---|---|
{listed["refused"]}

These {len(rows["piece"])} are pieces or tests of readers, which no solver could run as they are.

| deck | lacks |
|---|---|
{listed["piece"]}
{END}
"""
