#!/usr/bin/env python3
"""Runs the fuzz targets of tests/fuzz one after the other and rewrites the table of docs/reliability.md.

    cmake --preset fuzz && ninja -C build/fuzz gapcheck_fuzz      # clang 14
    scripts/fuzz.py build/fuzz --seconds 300                      # all targets, 300 s of processor time each
    scripts/fuzz.py build/fuzz deck audit --seconds 60
    scripts/fuzz.py build/fuzz deck --minimise                    # what was found becomes tests/fuzz/corpus/deck
    scripts/fuzz.py build/fuzz --dictionary                       # tests/fuzz/keywords.dict from the known keywords

BUILD/corpus/TARGET holds what a target has found so far, and the next run goes on from there; BUILD/finds/TARGET holds
the inputs that crashed, hung or took too much memory. tests/fuzz/executions.json adds up executions, processor time and
finds of all runs, target by target, and keeps the most edges that a run reached; --anew begins at zero. Without clang,
which makes the programs, only the table is written again from there. Exit code 1 if something was found.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "reliability.md"
SEEDS = ROOT / "tests" / "fuzz" / "corpus"
DICTIONARY = ROOT / "tests" / "fuzz" / "keywords.dict"
NUMBERS = ROOT / "tests" / "fuzz" / "executions.json"
BEGIN, END = "<!-- fuzz -->", "<!-- /fuzz -->"
PROGRAM = "gapcheck_fuzz_"

# Largest input in bytes, and largest corpus in the repository.
LONGEST = {"audit": 1500, "baseline": 1000, "check_c": 300, "command_line": 300, "compare": 3000, "d3plot": 2000,
           "decisions": 200, "deck": 1500, "fix": 1200, "kinds": 2000, "log": 2000, "results": 2000, "rows": 600,
           "run": 1500, "search": 600, "settings": 1000, "states": 4000, "twins": 1200, "writers": 1500}
KEPT = {"audit": 40_000, "deck": 30_000, "fix": 15_000, "run": 40_000, "twins": 10_000, "writers": 15_000}
KEPT_OTHERS = 8_000
# Seconds for one input, on a machine that has other work too. Exact numbers take long where a distance equals the bound.
TIMEOUT, TIMEOUTS = 10, {"decisions": 60}
# Seconds of a run: each reads the corpus again.
SHORTEST = 15
DECKS = {"audit", "deck", "fix", "run", "twins", "writers"}
# Most of the time went into libFuzzer's entropic schedule and into stacks and quarantine of the address sanitizer.
SANITIZERS = "detect_leaks=1:allocator_may_return_null=1:malloc_context_size=2:quarantine_size_mb=8"
OPTIONS = ["-rss_limit_mb=1500", "-print_final_stats=1", "-reload=0", "-entropic=0"]


def programs(build, wanted):
    folder = build / "tests" / "fuzz"
    found = {path.name.removeprefix(PROGRAM): path for path in sorted(folder.glob(PROGRAM + "*"))
             if path.is_file() and os.access(path, os.X_OK) and "replay" not in path.name}
    for name in wanted:
        if found and name not in found:
            sys.exit(f"there is no target {name}; there are: {' '.join(found)}")
    return {name: path for name, path in found.items() if not wanted or name in wanted}


def call(program, arguments, limit):
    """What the program says. It works in an empty folder in memory, so that no file waits for a disk."""
    memory = "/dev/shm" if os.path.isdir("/dev/shm") else None
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        environment = dict(os.environ, TMPDIR=folder, ASAN_OPTIONS=SANITIZERS,
                           UBSAN_OPTIONS="print_stacktrace=1")
        done = subprocess.run([str(program), *arguments], cwd=folder, env=environment, capture_output=True,
                              timeout=limit)
    return done.returncode, done.stderr.decode("utf-8", "replace")


def options_of(name):
    words = [f"-dict={DICTIONARY}"] if name in DECKS | {"log"} else []
    limits = [f"-timeout={TIMEOUTS.get(name, TIMEOUT)}", f"-max_len={LONGEST.get(name, 1000)}"]
    return OPTIONS + limits + words


def number(pattern, text, default=0):
    found = re.findall(pattern, text)
    return int(found[-1]) if found else default


def processor_time():
    """Of all that was run so far: the rates do not depend on what else the machine does."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def fuzz(name, program, build, seconds):
    """Runs a target, again after each find, until its time is up. On a busy machine the time of the clock is not enough."""
    corpus, finds = build / "corpus" / name, build / "finds" / name
    for folder in (corpus, finds, SEEDS / name):
        folder.mkdir(parents=True, exist_ok=True)
    result = {"executions": 0, "processor": 0, "edges": 0, "of": 0, "finds": 0}
    used = processor_time()
    while (spent := processor_time() - used) < seconds:
        left = max(SHORTEST, round(seconds - spent))
        code, said = call(program, [str(corpus), str(SEEDS / name), *options_of(name), f"-max_total_time={left}",
                                    f"-artifact_prefix={finds}/"], 20 * left + 600)
        result["processor"] = round(processor_time() - used, 1)
        result["executions"] += number(r"stat::number_of_executed_units: (\d+)", said)
        result["edges"] = max(result["edges"], number(r" cov: (\d+)", said))
        result["of"] = max(result["of"], number(r"\((\d+) inline 8-bit counters\)", said))
        if code == 0:
            continue
        result["finds"] += 1
        report = finds / f"{result['finds']}.txt"
        report.write_text(said[-20000:], encoding="utf-8")
        print(f"{name}: a find, see {report}", flush=True)
    return result


def minimise(name, program, build):
    """Of seeds and working corpus the inputs that reach everything, and of these as many as there is room for."""
    seeds, corpus = SEEDS / name, build / "corpus" / name
    seeds.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=build) as folder:
        merged = pathlib.Path(folder)
        code, said = call(program, ["-set_cover_merge=1", "-use_counters=0", str(merged), str(corpus), str(seeds),
                                    *options_of(name)], 3600)
        if code != 0:
            sys.exit(f"{name}: the merge fails\n{said[-3000:]}")
        files = sorted(merged.iterdir(), key=lambda path: (path.stat().st_size, path.name))
        room, kept = KEPT.get(name, KEPT_OTHERS), []
        for path in files:
            room -= path.stat().st_size
            if room >= 0:
                kept.append(path)
        named = [path for path in seeds.iterdir() if not re.fullmatch(r"[0-9a-f]{40}", path.name)]
        for path in seeds.iterdir():
            if path not in named:
                path.unlink()
        texts = {path.read_bytes() for path in named}
        for path in kept:
            if path.read_bytes() not in texts:
                shutil.copyfile(path, seeds / path.name)
    print(f"{name}: {len(kept)} of {len(files)} inputs kept, {len(named)} seeds with names")


def write_dictionary():
    """What decks are made of: all keywords that are read, the kinds of contacts, and odd values."""
    families = re.findall(r'^    \{"([A-Z_]+)", Phase::', (ROOT / "lib/model/read/read_model.cpp").read_text(), re.M)
    kinds = re.findall(r'^      \{"([A-Z_]+)",', (ROOT / "lib/model/contact/contact_kind.cpp").read_text(), re.M)
    words = [f"*{name}\\x0a" for name in families] + [f"*CONTACT_{name}\\x0a" for name in kinds]
    words += [f"*{name}\\x0a" for name in (
        "KEYWORD", "KEYWORD LONG=Y", "END", "PARAMETER", "PARAMETER_EXPRESSION", "PARAMETER_LOCAL", "INCLUDE",
        "INCLUDE_TRANSFORM", "INCLUDE_PATH", "INCLUDE_AUTO_OFFSET", "DEFINE_TRANSFORMATION", "SET_NODE_LIST",
        "SET_NODE_LIST_GENERATE", "SET_NODE_GENERAL", "SET_PART_LIST", "SET_PART_LIST_GENERATE", "SET_SEGMENT_GENERAL",
        "SET_SHELL_LIST", "MAT_ELASTIC", "MAT_RIGID", "MAT_NULL", "MAT_PIECEWISE_LINEAR_PLASTICITY", "MAT_SPOTWELD",
        "MAT_SPRING_ELASTIC", "PART_CONTACT", "ELEMENT_SHELL_THICKNESS", "RIGIDWALL_PLANAR_FINITE_ID",
        "ELEMENT_SOLID_ORTHO", "SECTION_SHELL_TITLE", "CONTROL_CONTACT", "CONTACT_FORCE_TRANSDUCER_PENALTY",
        "CONTACT_INTERIOR", "CONTACT_ENTITY", "CONTACT_RIGID_BODY_TWO_WAY_TO_RIGID_BODY")]
    words += ["_ID", "_TITLE", "_MPP", "_MORTAR", "_SMOOTH", "_OFFSET", "_SET", "_THERMAL", "\\x0a=====\\x0a", "\\x0a\\x0a",
              "\\x0a$\\x0a", "$ gapcheck: ignore GC101 reason", "&p", "<1+1>", "1e30", "-1", "nan", "inf", "1e-30",
              "99999999", "9223372036854775807", "-9223372036854775808", "0.5", "+", "%", ",,,,,", "          ",
              "-----BEGIN PGP MESSAGE-----\\x0a", "-----END PGP MESSAGE-----\\x0a", "1.k\\x0a", "TRANSL", "ROTATE", "SCALE",
              "*** Warning 40565 (SOL+565)\\x0a", " contact interface # = ", "node # = "]
    lines = ["# Written by scripts/fuzz.py --dictionary."]
    lines += ['"' + word.replace('"', '\\"') + '"' for word in dict.fromkeys(words)]
    DICTIONARY.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"{len(lines) - 1} words in {DICTIONARY}")


def added(before, now):
    """Of all runs together; the edges of the programs as they are now."""
    sums = {name: round(before.get(name, 0) + now[name], 1) for name in ("executions", "processor", "finds")}
    same = before.get("of") == now["of"]
    return {**now, **sums, "edges": max(now["edges"], before["edges"] if same else 0)}


def table(numbers):
    lines = ["| target | executions | minutes | per second | edges reached | of all | finds |",
             "|---|---:|---:|---:|---:|---:|---:|"]
    for name, row in sorted(numbers.items()):
        rate, share = row["executions"] / max(1, row["processor"]), 100 * row["edges"] / max(1, row["of"])
        lines.append(f"| {name} | {row['executions']:,} | {row['processor'] / 60:.1f} | {rate:,.0f} | {row['edges']:,} | "
                     f"{share:.0f} % | {row['finds']} |")
    total = {key: sum(row[key] for row in numbers.values()) for key in ("executions", "processor", "finds")}
    lines.append(f"| all | {total['executions']:,} | {total['processor'] / 60:.0f} | | | | {total['finds']} |")
    return "\n".join(lines)


def write_page(numbers):
    head, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    PAGE.write_text(f"{head}{BEGIN}\n{table(numbers)}\n{END}{rest.split(END)[1]}", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", metavar="BUILD", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("targets", metavar="TARGET", nargs="*")
    parser.add_argument("--seconds", type=int, default=60, help="processor time for each target (default: 60)")
    parser.add_argument("--anew", action="store_true", help="forget the sums of earlier runs")
    parser.add_argument("--minimise", action="store_true", help="do not fuzz: renew tests/fuzz/corpus")
    parser.add_argument("--dictionary", action="store_true", help="do not fuzz: renew tests/fuzz/keywords.dict")
    arguments = parser.parse_args()
    if arguments.dictionary:
        write_dictionary()
        return 0
    found = programs(arguments.build, arguments.targets)
    if arguments.minimise:
        for name, program in found.items():
            minimise(name, program, arguments.build)
        return 0
    numbers = json.loads(NUMBERS.read_text(encoding="utf-8")) if NUMBERS.exists() and not arguments.anew else {}
    if not found:
        print(f"nothing is fuzzed: {arguments.build} has no fuzz targets, which clang makes: cmake --preset fuzz && ninja -C "
              "build/fuzz gapcheck_fuzz; the table is written again from the last run", flush=True)
    finds = 0
    for name, program in found.items():
        now = fuzz(name, program, arguments.build, arguments.seconds)
        finds += now["finds"]
        print(f"{name}: {now}", flush=True)
        numbers[name] = added(numbers.get(name, {}), now)
        NUMBERS.write_text(json.dumps(numbers, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    write_page(numbers)
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main())
