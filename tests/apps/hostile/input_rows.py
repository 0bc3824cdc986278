"""Makes the inputs of the table in inputs.py: which files, which call, and what the answer must be."""

import pathlib
import random
import re
from typing import NamedTuple

import changes
import inputs
import programs

# What is done with a changed deck: each input takes the next one. O is the folder to write into.
JOBS = ["--jobs", "2"]
WRITERS = [word for option in ("html", "key", "ani", "a4sel", "medina", "vtu", "sets", "write-baseline")
           for word in (f"--{option}", f"{option}.out")]
DECK_CALLS = [
    ["gapcheck", "audit", "DECK", "--format", "json"],
    ["gapcheck", "run", "DECK", "-o", "run", "--cycles", "3", "--ignore-unsupported", "--vtu"],
    ["gapcheck", "audit", "DECK", "--format", "json", *WRITERS],
    ["gapcheck", "fix", "DECK", "-o", "fixed", "--format", "json"],
    ["gapcheck", "audit", "DECK", "--format", "junit", "--list"],
    ["gapcheck", "run", "DECK", "-o", "run", "--cycles", "2"],
    ["gapcheck", "compare", "DECK", "GOOD", "--format", "json"],
    ["gapcheck", "audit", "DECK", "--format", "sarif", "--exact"],
    ["gapcheck", "fix", "DECK", "--dry-run", "--free-welds", "--verify", "--cycles", "2", "--ignore-unsupported"],
    ["gapcheck", "messag", "LOG", "--deck", "DECK", "--format", "json", "--html", "page.html", "--vtu", "grid.vtu"],
    ["check-c", "--deck", "DECK", "-pid", "-psum", "-key", "-medina", "LOG"],
    ["gapcheck", "audit", "DECK", "GOOD", "--format", "gitlab"],
]
LOG_CALLS = [
    ["gapcheck", "messag", "FILE", "--format", "json"],
    ["check-c", "-list", "-title", "-timestep", "-all", "-typ", "-key", "-medina", "-ani", "FILE"],
    ["gapcheck", "messag", "FOLDER", "--format", "json", "--html", "page.html", "--key", "beams.k"],
    ["gapcheck", "compare", "FOLDER", "GOOD RUN", "--format", "json", "--svg", "curves"],
    ["gapcheck", "compare", "FILE", "GOOD", "--format", "json"],
    ["gapcheck", "messag", "FOLDER", "--format", "junit", "--list"],
]
BINARY_CALLS = [
    ["gapcheck", "messag", "LOG", "-g", "FILE", "--format", "json", "--key", "beams.k"],
    ["check-c", "-g", "FILE", "-pid", "-psum", "-key", "LOG"],
    ["gapcheck", "compare", "FOLDER", "GOOD RUN", "--format", "json"],
    ["gapcheck", "messag", "FOLDER", "--format", "json", "--html", "page.html"],
]


class Input(NamedTuple):
    group: str  # deck, log, …
    name: str   # says what was done to which file
    files: object  # function: the files beside each other, by name
    words: list
    named: list = []  # with exit code 2 the message names one of these; empty: there is a message
    answer: str = ""  # of the row
    good: str = ""    # with "same": the deck before it was changed


def lot(*words):
    """The same places in every run of the test."""
    return random.Random("/".join(map(str, words)))


class Sources:
    """The good files that are changed."""

    def __init__(self, root, gapcheck, folder):
        self.root = root
        decks = [*sorted((root / "data").glob("*.k")), *sorted((root / "data/workshop").glob("*.k")),
                 *sorted((root / "tests/fuzz/corpus").glob("*.k")), root / "data/include/plates_mesh.k"]
        self.decks = {str(path.relative_to(root)): path.read_bytes() for path in decks}
        self.mesh = (root / "data/include/plates_mesh.k").read_bytes()
        self.good = (root / "data/two_plates.k").read_bytes()
        self.log = (root / "tests/apps/fixtures/smp/messag").read_bytes()
        kinds = (root / "docs/contact.md").read_text().split("<!-- kinds: begin -->")[1].split("<!-- kinds: end -->")[0]
        self.contacts = sorted(set(re.findall(r"\b[A-Z][A-Z_0-9]{5,}\b", kinds)))
        self.runs = []
        for deck in ("data/workshop/rebound_reference.k", "data/workshop/tie_by_set.k", "data/two_plates.k"):
            out = pathlib.Path(folder) / pathlib.Path(deck).stem
            ended = programs.run([gapcheck, "run", root / deck, "-o", out, "--cycles", "40", "--quiet"], folder,
                                 programs.Limits(memory=None))
            if ended.code != 0:
                raise SystemExit(f"{deck} does not run: {ended.text}")
            self.runs.append({path.name: path.read_bytes() for path in sorted(out.iterdir()) if path.is_file()})
        self.logs = [{path.name: path.read_bytes() for path in sorted(folder.iterdir())}
                     for folder in sorted((root / "tests/apps/fixtures").iterdir())]


def places(row, sources, rounds):
    """Each change with each value on so many files, in turn; the number chooses the place."""
    at = lot(row.name).randrange(1000)
    for number in range(rounds):
        for value in row.values:
            for _ in range(row.files):
                yield value, sources[at % len(sources)], number
                at += 7 if len(sources) % 7 else 1


def shown(value):
    text = str(value)
    return repr(text if len(text) <= 40 else text[:20] + f"… ({len(text)} characters)")


def deck_inputs(sources, rounds):
    count = 0
    rows = [*inputs.DECKS, inputs.Row("every contact is", changes.contact_type, sources.contacts, inputs.CONTACT_TYPES)]
    for row in rows:
        for value, deck, number in places(row, sorted(sources.decks), rounds):
            def files(row=row, value=value, deck=deck, number=number):
                changed = row.change(sources.decks[deck], lot(row.name, value, deck, number), value)
                return {"deck.k": changed, **({"include/plates_mesh.k": sources.mesh} if b"include/" in changed
                    else {})}
            call = DECK_CALLS[0 if row.answer == "same" else count % len(DECK_CALLS)]
            yield Input("decks", f"{deck}: {row.name} {shown(value)} ({number})", files, call, ["deck.k",
                "plates_mesh.k"],
                        row.answer, deck)
            count += 1
    for name, text in inputs.TEXTS.items():
        def files(text=text):
            deck = changes.before_end(sources.good, None, text)
            chain = b"chain" in deck
            return {"deck.k": deck, **{name: data for name, data in inputs.FILES.items()
                                       if chain or not name.startswith("chain")}}
        for call in (DECK_CALLS[0], DECK_CALLS[1], DECK_CALLS[3]):
            yield Input("decks", f"two_plates.k {name}, {call[1]}", files, call, ["deck.k", "b.k", "chain063.k"])


def log_inputs(sources, rounds):
    folders = [*sources.logs, *sources.runs]
    texts = [(i, name) for i, folder in enumerate(folders) for name in sorted(folder)
             if not name.startswith(("d3plot", "state_", "run.pvd"))]
    count = 0
    for row in inputs.LOGS:
        for value, (folder, name), number in places(row, texts, rounds):
            def files(row=row, value=value, folder=folder, name=name, number=number):
                return {**folders[folder], name: row.change(folders[folder][name], lot(row.name, value, name, number),
                    value)}
            yield Input("logs and tables", f"{name} of {folder}: {row.name} {shown(value)} ({number})", files,
                        [f"../in/{name}" if word == "FILE" else word for word in LOG_CALLS[count % len(LOG_CALLS)]],
                            [name, "--svg"])
            count += 1


def binary_inputs(sources, rounds):
    folders = sources.runs
    plots = [(i, name) for i, folder in enumerate(folders) for name in sorted(folder) if name.startswith("d3plot")]
    count = 0
    for row in inputs.BINARIES:
        for value, (folder, name), number in places(row, plots, rounds):
            def files(row=row, value=value, folder=folder, name=name, number=number):
                return {**folders[folder], name: row.change(folders[folder][name], lot(row.name, value, name, number),
                    value)}
            yield Input("d3plot", f"{name} of {folder}: {row.name} {shown(value)} ({number})", files,
                        ["../in/d3plot" if word == "FILE" else word
                            for word in BINARY_CALLS[count % len(BINARY_CALLS)]],
                        ["d3plot"])
            count += 1


def other_inputs(sources):
    for kind, texts, file, call in (
            ("settings", inputs.SETTINGS, "gapcheck.toml", ["gapcheck", "audit", "GOOD", "--format", "json"]),
            ("baseline", inputs.BASELINES, "known", ["gapcheck", "audit", "GOOD", "--format", "json", "--baseline",
                "../in/known"]),
            ("messages", inputs.MESSAGES, "table", ["gapcheck", "messag", "LOG", "--format", "json", "--messages",
                "../in/table"])):
        for text in texts:
            yield Input("settings and tables", f"{kind}: {shown(text)}",
                        lambda file=file, text=text: {file: text.encode("latin-1", "ignore") if text == "\xff\xfe"
                            else text},
                        call, [file])
    for words in inputs.ARGUMENTS:
        names = {"D": "GOOD", "L": "LOG", "O": "run"}
        yield Input("arguments", " ".join(map(shown, words[:6])) + (f" … ({len(words)} words)" if len(words) > 6
            else ""),
                    dict, [words[0], *(names.get(word, word) for word in words[1:])])


def all_inputs(sources, rounds):
    yield from deck_inputs(sources, rounds)
    yield from log_inputs(sources, rounds)
    yield from binary_inputs(sources, rounds)
    yield from other_inputs(sources)
