#!/usr/bin/env python3
"""Checks that .clang-format holds for every C++ file and that no line is longer than its column limit.

    check_format.py ROOT
    check_format.py --self-test

Prints FILE:LINE of each place that deviates; exit code 1 if there is any. Needs clang-format 14: other versions lay out
some lines differently. To repair: git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 -i
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FOLDERS = ("apps", "examples", "lib", "python", "tests")
LEAST_FILES = 500  # fewer mean that the files are no longer found
WARNING = re.compile(r"^(.*?):(\d+):\d+: (?:warning|error): code should be clang-formatted", re.M)


def program():
    for name in ("clang-format-14", "clang-format"):
        path = shutil.which(name)
        if path and " 14." in subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout:
            return path
    sys.exit("clang-format 14 is missing; install the packages of scripts/test_packages.txt")


def deviations(formatter, files):
    checked = subprocess.run([formatter, "--dry-run", *map(str, files)], capture_output=True, text=True)
    if checked.returncode != 0:
        sys.exit(checked.stderr)
    return sorted({(path, int(line)) for path, line in WARNING.findall(checked.stderr)})


def self_test(formatter):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / ".clang-format").write_text("BasedOnStyle: Google\nColumnLimit: 120\n")
        (folder / "good.cpp").write_text("int f() { return 1; }\n")
        (folder / "bad.cpp").write_text("int a;\nint  b;\n")
        found = deviations(formatter, sorted(folder.glob("*.cpp")))
    if found != [(str(folder / "bad.cpp"), 2)]:
        sys.exit(f"found {found} instead of line 2 of bad.cpp")
    print("1 passed, 0 failed")


def main():
    formatter = program()
    if sys.argv[1:] == ["--self-test"]:
        return self_test(formatter)
    root = pathlib.Path(sys.argv[1])
    files = sorted(path for folder in FOLDERS for path in (root / folder).rglob("*.[ch]pp"))
    if len(files) < LEAST_FILES:
        sys.exit(f"only {len(files)} files found below {root}")
    groups = [files[first : first + 100] for first in range(0, len(files), 100)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [place for group in pool.map(lambda group: deviations(formatter, group), groups) for place in group]
    for path, line in found:
        print(f"{pathlib.Path(path).relative_to(root)}:{line}: not as .clang-format has it")
    print(f"{len(files)} files, {len(found)} deviations")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
