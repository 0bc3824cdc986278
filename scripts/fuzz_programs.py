#!/usr/bin/env python3
"""Runs the programs on decks with mistakes and accepts no crash.

    scripts/fuzz_programs.py GAPCHECK CHECK_C [--count N] [--seed S] [--decks FOLDER] [--results FILE]

Each execution takes a deck of FOLDER (default: data), changes it (swaps and replaces fields, drops, repeats and moves
cards, puts in extremes, renames keywords, changes options), and calls `gapcheck audit`, `run`, `fix`, `messag` or
`check-c` on it, with options that are drawn as well. A find is an exit code other than 0, 1 and 2, a report of a sanitizer,
an error without words, or more than 20 s or 4 GB. The changed deck of a find is kept beside FILE (default:
build/fuzz_programs/results.json), which counts what has been done: a broken run goes on from there, and the same seed
draws the same decks. Exit code 1 if there are finds.

Twenty thousand executions, a night:   scripts/fuzz_programs.py build/release/apps/gapcheck/gapcheck \\
                                           build/release/apps/check-c/check-c --count 20000
Programs of the preset asan or fuzz find more and take ten times as long.
"""
import argparse
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SECONDS, BYTES = 20, 4 << 30
EXTREMES = ["1e30", "-1e30", "1e-30", "1e20", "-1", "0", "0.", "1", "2", "3", "-2", "-3", "13", "99999999", "1.5", "-0.0", "1e10",
            "0.001", "1000.", "4294967296"]
NO_NUMBERS = ["", "nan", "inf", "9223372036854775807", "-9223372036854775808", "1e400", "x", "&no", "<1/0>", "0x10"]
SANITIZER = re.compile(rb"AddressSanitizer|LeakSanitizer|ThreadSanitizer|runtime error:")


# Decks ------------------------------------------------------------------------------------------------------------------

def is_data(line):
    return line and line[0] not in "*$"


def fields_of(line):
    """The fields of a line: values between commas, or words with the blanks before them."""
    if "," in line:
        return line.split(","), ","
    return re.findall(r" *[^ ]+", line), ""


def with_field(line, place, value):
    """Columns stay where they are if the value fits."""
    fields, between = fields_of(line)
    if not fields:
        return value
    place %= len(fields)
    fields[place] = value if between else value.rjust(len(fields[place]))
    return between.join(fields)


def any_value(lines, data, draw):
    """An extreme, or a field from elsewhere."""
    kind = draw.random()
    if kind < 0.1:
        return draw.choice(NO_NUMBERS)
    if kind < 0.6:
        return draw.choice(EXTREMES)
    fields, _ = fields_of(lines[draw.choice(data)])
    return draw.choice(fields).strip() if fields else "0"


def swapped(line, draw):
    fields, between = fields_of(line)
    if len(fields) < 2:
        return line
    a, b = draw.sample(range(len(fields)), 2)
    first, second = fields[a].strip(), fields[b].strip()
    return with_field(with_field(line, a, second), b, first)


def change(lines, keywords, draw):
    """One mistake, in place."""
    data = [i for i, line in enumerate(lines) if is_data(line)] or [0]
    heads = [i for i, line in enumerate(lines) if line.startswith("*")] or [0]
    # Most lines are nodes and elements; the cards of the others are as often wanted.
    at = draw.choice(data)
    if draw.random() < 0.6:
        head = draw.choice(heads)
        behind = [i for i in data if i > head][:4]
        at = draw.choice(behind) if behind else at
    kind = draw.choice([0] * 8 + list(range(4, 11)))
    if kind == 0:
        lines[at] = with_field(lines[at], draw.randrange(12), any_value(lines, data, draw))
    elif kind == 4:
        lines[at] = swapped(lines[at], draw)
    elif kind == 5:
        del lines[at]
    elif kind == 6:
        lines.insert(at, lines[draw.choice(data)])
    elif kind == 7:
        head = draw.choice(heads)
        lines[head] += draw.choice(["_ID", "_TITLE", "_MORTAR", "_MPP", "_SET", "_OFFSET", "_THERMAL", " %", " +", "_X"])
    elif kind == 8:
        lines[draw.choice(heads)] = draw.choice(keywords)
    elif kind == 9:
        begin = draw.choice(heads)
        end = next((i for i in heads if i > begin), len(lines))
        block = lines[begin:end]
        if draw.random() < 0.5:
            del lines[begin:end]
        place = draw.randrange(len(lines) + 1)
        lines[place:place] = block
    else:
        text = lines[at]
        cut = draw.randrange(len(text) + 1)
        lines[at] = text[:cut] + draw.choice(["", ",", "\t", "1", "-", "\u00fc", "&", " " * 30]) + text[cut + 1:]
    if not lines:
        lines.append("*KEYWORD")


def changed(text, keywords, draw):
    lines = text.split("\n")
    for _ in range(draw.choice([1, 1, 1, 2, 3, 6])):
        change(lines, keywords, draw)
    return "\n".join(lines)


# Programs ---------------------------------------------------------------------------------------------------------------

def command(programs, deck, folder, draw):
    """A program, its arguments, and nothing that is written elsewhere than in `folder`."""
    gapcheck, check_c = programs
    kind = draw.choice(["audit"] * 5 + ["run"] * 3 + ["fix"] * 2 + ["messag", "check-c"])
    jobs = ["--jobs", "1"]
    if kind == "audit":
        form = draw.choice(["text", "json", "sarif", "junit", "github", "gitlab", "csv"])
        words = ["audit", deck, *jobs, "--format", form]
        words += draw.choice([[], ["--html", f"{folder}/page.html"], ["--vtu", f"{folder}/grid.vtu"],
                              ["--sets", f"{folder}/sets.k"], ["--exact"], ["--as-if", "thickness", "--units", "mm-ms-kg"],
                              ["--as-if", "SST=0.5"], ["--list"], ["--portability"], ["--fail-on", "never"]])
        return [gapcheck, *words]
    if kind == "run":
        return [gapcheck, "run", deck, *jobs, "-o", f"{folder}/out", "--cycles", str(draw.choice([1, 20, 50])),
                *draw.choice([[], ["--ignore-unsupported"], ["--vtu"]])]
    if kind == "fix":
        return [gapcheck, "fix", deck, *jobs, *draw.choice([["--dry-run"], ["-o", f"{folder}/fixed.k"], ["--recommended",
                                                            "--dry-run"], ["--free-welds", "--dry-run"]])]
    if kind == "messag":
        return [gapcheck, "messag", deck, *draw.choice([[], ["--list"], ["--format", "json"]])]
    return [check_c, *draw.choice([[], ["-list"], ["-pid"], ["-all"], ["-key"], ["-rsort"]]), deck]


def limited():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 28, 1 << 28))


def fault_of(words, folder, sanitized, codes):
    """What is wrong with an execution; empty: nothing. `codes` counts the exit codes."""
    def prepare():
        limited()
        if not sanitized:  # a sanitizer takes terabytes of addresses
            resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    environment = dict(os.environ, ASAN_OPTIONS=f"hard_rss_limit_mb={BYTES >> 20}", UBSAN_OPTIONS="print_stacktrace=1")
    try:
        done = subprocess.run(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=SECONDS, preexec_fn=prepare)
    except subprocess.TimeoutExpired:
        return f"takes more than {SECONDS} s"
    codes[str(done.returncode)] = codes.get(str(done.returncode), 0) + 1
    if SANITIZER.search(done.stderr):
        return done.stderr.decode("utf-8", "replace")[-4000:]
    if done.returncode not in (0, 1, 2):
        return f"exit code {done.returncode}: {done.stderr[-1000:].decode('utf-8', 'replace')}"
    if done.returncode == 2 and not done.stderr.strip():
        return "exit code 2 without a word"
    if b"bad_alloc" in done.stderr or b"not enough memory" in done.stderr:
        return "not enough memory"
    return ""


def log_of(gapcheck, deck, folder):
    """messag of a short run, for the readers of logs."""
    out = pathlib.Path(folder) / "log"
    subprocess.run([gapcheck, "run", deck, "-o", out, "--cycles", "2", "--ignore-unsupported", "--quiet"],
                   capture_output=True, check=False, timeout=120)
    messag = out / "messag"
    text = messag.read_text(errors="replace") if messag.exists() else "*** Warning 40565\n node # = 1\n"
    shutil.rmtree(out, ignore_errors=True)
    return text


def execute(number, seed, decks, keywords, programs, sanitized, logs, codes):
    """Execution `number`; (words, text of the deck, fault)."""
    draw = random.Random(f"{seed} {number}")
    name = draw.choice(sorted(decks))
    memory = "/dev/shm" if os.path.isdir("/dev/shm") else None
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        words = command(programs, f"{folder}/deck.k", folder, draw)
        of_log = words[1] == "messag" or words[0] == programs[1]
        if of_log and name not in logs:
            logs[name] = log_of(programs[0], decks[name][0], folder)
        text = changed(logs[name] if of_log else decks[name][1], keywords, draw)
        file = pathlib.Path(folder) / ("messag" if of_log else "deck.k")
        file.write_text(text, encoding="utf-8")
        words = [word.replace("deck.k", file.name) if word == f"{folder}/deck.k" else word for word in words]
        return [word.replace(folder, "FOLDER") for word in words], text, fault_of(words, folder, sanitized, codes)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck", metavar="GAPCHECK", type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("check_c", metavar="CHECK_C", type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("--count", type=int, default=200, help="executions (default: 200)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--decks", type=pathlib.Path, default=ROOT / "data")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "build" / "fuzz_programs" / "results.json")
    arguments = parser.parse_args()
    decks = {path.name: (str(path), path.read_text(errors="replace")) for path in sorted(arguments.decks.glob("*.k"))
             if path.stat().st_size < 20_000}
    keywords = sorted({line for _, text in decks.values() for line in text.split("\n") if line.startswith("*")})
    if not decks:
        sys.exit(f"{arguments.decks} has no decks below 20 kB")
    sanitized = b"AddressSanitizer" in pathlib.Path(arguments.gapcheck).read_bytes()
    arguments.results.parent.mkdir(parents=True, exist_ok=True)
    key, all_results = f"seed {arguments.seed}", {}
    if arguments.results.exists():
        all_results = json.loads(arguments.results.read_text())
    results = all_results.setdefault(key, {"executions": 0, "codes": {}, "finds": []})
    logs = {}
    while results["executions"] < arguments.count:
        number = results["executions"]
        words, text, fault = execute(number, arguments.seed, decks, keywords, (arguments.gapcheck, arguments.check_c),
                                     sanitized, logs, results["codes"])
        results["executions"] += 1
        if fault:
            kept = arguments.results.parent / f"find_{arguments.seed}_{number}"
            kept.write_text(text, encoding="utf-8")
            results["finds"].append({"number": number, "words": words, "fault": fault, "deck": str(kept)})
            print(f"{number}: {' '.join(words)}\n  {fault}\n  {kept}", flush=True)
        if fault or results["executions"] % 100 == 0 or results["executions"] == arguments.count:
            arguments.results.write_text(json.dumps(all_results, indent=1) + "\n", encoding="utf-8")
    codes = ", ".join(f"{code}: {times}" for code, times in sorted(results["codes"].items()))
    print(f"{results['executions']} executions, exit codes {codes}; {len(results['finds'])} finds")
    return 1 if results["finds"] else 0


if __name__ == "__main__":
    sys.exit(main())
