#!/usr/bin/env python3
"""Adds up test results: scripts/count_tests.py FOLDER…, where each folder holds ctest.xml (ctest --output-junit) and
results/*.xml (Google Test, pytest). A test that also ran with sanitizers counts once: as failed if it failed in one of them, as
passed if it passed in one. Failed ones are named with the beginning of what they say. The last line is "N passed, N failed,
N skipped"; exit code 1 if any failed or none ran."""
import pathlib
import sys
import xml.etree.ElementTree as xml

order = {'skipped': 0, 'passed': 1, 'failed': 2}
most_lines = 30


def plain_name(name):
    """That of the program without sanitizers."""
    return name.removesuffix('_sanitized').removesuffix('_threads')


def gtest_results(folder):
    for file in sorted(folder.glob('*.xml')):
        # A program that ended badly leaves no file or half a one; ctest knows that it failed.
        try:
            cases = xml.parse(file).getroot().iter('testcase')
        except xml.ParseError:
            continue
        program = plain_name(file.stem.split('.')[0].removeprefix('gapcheck_test_'))
        for case in cases:
            result, said = 'passed', ''
            fault = next(filter(lambda element: element is not None, map(case.find, ('failure', 'error'))), None)
            if fault is not None:
                result, said = 'failed', fault.get('message') or fault.text or ''
            elif (case.get('status') == 'notrun' or case.get('result') in ('skipped', 'suppressed')
                  or case.find('skipped') is not None):
                result = 'skipped'
            yield f'{program}: {case.get("classname")}.{case.get("name")}', result, program, said


def ctest_results(file):
    for case in xml.parse(file).getroot().iter('testcase'):
        status = case.get('status')
        yield plain_name(case.get('name')), {'run': 'passed', 'fail': 'failed'}.get(status, 'skipped')


def main():
    worst, words = {}, {}

    def take(name, result):
        if order[result] >= order.get(worst.get(name), -1):
            worst[name] = result

    for build in map(pathlib.Path, sys.argv[1:]):
        programs, failed_programs = set(), set()
        for name, result, program, said in gtest_results(build / 'results'):
            take(name, result)
            if result == 'failed':
                words[name] = said.splitlines()[:most_lines]
            programs.add(program)
            if result == 'failed':
                failed_programs.add(program)
        for name, result in ctest_results(build / 'ctest.xml'):
            program = name.split('.')[0]
            # Programs of many tests count by these; crashes and time-outs leave no failed test to show.
            if program not in programs or (result == 'failed' and program not in failed_programs):
                take(name, result)
    count = {result: sum(1 for one in worst.values() if one == result) for result in order}
    for name in sorted(name for name, result in worst.items() if result == 'failed'):
        print('\n    '.join([f'failed: {name}', *words.get(name, [])]))
    print(f'{count["passed"]} passed, {count["failed"]} failed, {count["skipped"]} skipped')
    return 1 if count['failed'] or not count['passed'] else 0


if __name__ == '__main__':
    sys.exit(main())
