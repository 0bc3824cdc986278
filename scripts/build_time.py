#!/usr/bin/env python3
"""Measures how long the programs take to compile, and which files take longest.

    scripts/build_time.py [--update] [--jobs N] [--plain]

Builds gapcheck and check-c of the release preset from nothing in a temporary directory, without a compiler cache, and
prints a table: processor time of all compilers together, elapsed time, and the ten heaviest steps. --plain compiles file
by file instead of a room at a time. --update writes the table into docs/benchmarks.md.
"""
import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

root = pathlib.Path(__file__).resolve().parent.parent
page = root / 'docs/benchmarks.md'
begin, end = '<!-- build: begin -->\n', '<!-- build: end -->'


def build(folder, jobs, plain):
    environment = dict(os.environ, CCACHE_DISABLE='1')
    unity = '-DGAPCHECK_UNITY=' + ('OFF' if plain else 'ON')
    subprocess.run(['cmake', '--preset', 'release', '-B', folder, unity], cwd=root, env=environment, check=True,
                   stdout=subprocess.DEVNULL)
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(['ninja', '-C', folder, '-j', str(jobs), 'gapcheck', 'check-c'], env=environment, check=True,
                   stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, time.monotonic() - start


def heaviest(folder, count):
    steps = {}
    for line in (pathlib.Path(folder) / '.ninja_log').read_text().splitlines()[1:]:
        first, last, _, output, _ = line.split('\t')
        steps[output] = (int(last) - int(first)) / 1000
    return sorted(steps.items(), key=lambda step: -step[1])[:count]


def name(output):
    """lib/contact/CMakeFiles/…/Unity/unity_0_cxx.cxx.o is all of lib/contact."""
    short = re.sub(r'/CMakeFiles/[^/]+\.dir/', '/', output).removesuffix('.o')
    return re.sub(r'/Unity/unity_(\d+)_cxx\.cxx', ' (all)', short)


def processor():
    for line in pathlib.Path('/proc/cpuinfo').read_text().splitlines():
        if line.startswith('model name'):
            return line.split(':', 1)[1].strip()
    return 'unknown processor'


def table(jobs, plain):
    with tempfile.TemporaryDirectory() as folder:
        processor_s, elapsed_s = build(folder, jobs, plain)
        steps = heaviest(folder, 10)
    compiler = subprocess.run(['c++', '-dumpfullversion'], capture_output=True, text=True, check=True).stdout.strip()
    lines = ['| gapcheck and check-c | seconds |', '|---|---:|',
             f'| processor time of all compilers | {processor_s:.0f} |', f'| elapsed, {jobs} jobs | {elapsed_s:.0f} |']
    lines += [f'| {name(output)} | {seconds:.1f} |' for output, seconds in steps]
    return '\n'.join(lines) + f'\n\ng++ {compiler}, {processor()}; the ten longest steps by elapsed time.\n'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--update', action='store_true', help='write the table into docs/benchmarks.md')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--plain', action='store_true', help='file by file')
    given = parser.parse_args()
    text = table(given.jobs, given.plain)
    sys.stdout.write(text)
    if given.update:
        content = page.read_text()
        first, last = content.index(begin) + len(begin), content.index(end)
        page.write_text(content[:first] + text + content[last:])


if __name__ == '__main__':
    main()
