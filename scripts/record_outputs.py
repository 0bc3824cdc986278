#!/usr/bin/env python3
"""Writes what the programs print for every available deck and log into a folder, to compare two builds.

    scripts/record_outputs.py BUILD FOLDER [--decks DIR …]
    diff -r before after

BUILD is a build directory (build/release). Per input FOLDER gets audit (text, JSON, --list), fix, messag and check-c, and
for the decks of data/workshop the files of a run of 200 cycles. Times are left out; everything else is byte for byte.
"""
import argparse
import concurrent.futures
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
times = re.compile(r'("(?:read|model|surface|search|total)_s": ?)[-+.eE0-9]+|'
                   r'(after |; |  )[0-9.]+ s\b(?:, [0-9.]+ ms per cycle, [0-9.]+ ns per element and cycle)?')
versions = re.compile(r'gapcheck [0-9][^\n"]*')
dates = re.compile(rb'Date: \d\d/\d\d/\d{4} +Time: \d\d:\d\d:\d\d')


def normal(text, out):
    return versions.sub('gapcheck VERSION', times.sub(r'\1\2T', text.replace(str(out), 'FOLDER').replace(str(root), 'ROOT')))


def call(program, arguments, target, folder, out):
    result = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, errors='replace', cwd=folder,
                            timeout=900)
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(f'exit {result.returncode}\n--- stdout\n{normal(result.stdout, out)}--- stderr\n'
                      f'{normal(result.stderr, out)}')


def record_tree(tree, target):
    """Names and digests of the files that a command wrote."""
    lines = []
    for path in sorted(tree.rglob('*')) if tree.exists() else []:
        if path.is_file():
            data = dates.sub(b'', versions.sub('gapcheck VERSION', path.read_bytes().decode('latin1')).encode('latin1'))
            lines.append(f'{hashlib.sha256(data).hexdigest()}  {path.relative_to(tree)}\n')
    target.write_text(''.join(lines))
    shutil.rmtree(tree, ignore_errors=True)


def deck(build, path, name, out):
    gapcheck = build / 'apps/gapcheck/gapcheck'
    folder, file = path.parent, path.name
    audit = [gapcheck, 'audit', file, '--no-config']
    call(audit[0], audit[1:] + ['--fail-on', 'note', '--stats'], out / name / 'audit.txt', folder, out)
    call(audit[0], audit[1:] + ['--format', 'json', '--list'], out / name / 'audit.json', folder, out)
    if path.stat().st_size < 1_000_000:
        fixed = out / name / 'fixed'
        call(gapcheck, ['fix', file, '-o', fixed], out / name / 'fix.txt', folder, out)
        record_tree(fixed, out / name / 'fixed.sha')
    if 'workshop' in path.parts or (root / 'data') in path.parents:
        run = out / name / 'run'
        call(gapcheck, ['run', file, '-o', run, '--cycles', '200', '--ignore-unsupported'], out / name / 'run.txt', folder, out)
        if (run / 'messag').exists():
            log(build, run / 'messag', name + '/of_run', out)
            call(gapcheck, ['compare', path, run / 'messag'], out / name / 'compare.txt', run, out)
        record_tree(run, out / name / 'run.sha')


def log(build, path, name, out):
    gapcheck, check_c = build / 'apps/gapcheck/gapcheck', build / 'apps/check-c/check-c'
    call(gapcheck, ['messag', path.name], out / name / 'messag.txt', path.parent, out)
    call(gapcheck, ['messag', path.name, '--format', 'json'], out / name / 'messag.json', path.parent, out)
    call(check_c, ['-all', '-list', '-title', '-typ', '-typkey', '-timestep', '-psum', path.name], out / name / 'check_c.txt',
         path.parent, out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('build', type=pathlib.Path)
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('--decks', type=pathlib.Path, nargs='*', default=[root / 'data', root.parent / 'shared/decks'])
    parser.add_argument('--only', default='', help='inputs whose path holds this')
    given = parser.parse_args()
    out = given.folder.resolve()
    build = given.build.resolve()
    jobs = []
    for place in given.decks:
        for path in sorted(place.resolve().rglob('*')):
            if not path.is_file() or given.only not in str(path):
                continue
            name = f'{place.name}/{path.relative_to(place.resolve())}'
            if path.suffix in ('.k', '.key', '.dyn'):
                jobs.append((deck, path, name))
            elif path.name in ('messag', 'd3hsp'):
                jobs.append((log, path, name))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        done = [pool.submit(work, build, path, name, out) for work, path, name in jobs]
        for future in done:
            future.result()
    print(f'{len(jobs)} inputs recorded in {given.folder}', file=sys.stderr)


if __name__ == '__main__':
    main()
