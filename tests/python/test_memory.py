"""While a call works the module keeps the large blocks that it frees; afterwards it holds none of them."""
import os
import subprocess
import sys

import pytest

import gapcheck

# As the program has it, by settings of the C library.
KEPT = {"MALLOC_MMAP_MAX_": "0", "MALLOC_TRIM_THRESHOLD_": "2000000000"}
SCRIPT = """
import resource, sys, gapcheck
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
report = gapcheck.audit(sys.argv[1], jobs=1)
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


@pytest.fixture(scope="module")
def deck(tmp_path_factory, large):
    path = tmp_path_factory.mktemp("memory") / "large.k"
    path.write_text(large)
    return path


def test_fresh_pages_are_as_few_as_the_program_needs(deck):
    def faults(**settings):
        return int(subprocess.run([sys.executable, "-c", SCRIPT, deck], env={**os.environ, **settings}, check=True,
                                  stdout=subprocess.PIPE, text=True).stdout)
    assert faults() < 1.25 * faults(**KEPT)


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_memory_is_given_back(deck):
    def audit():
        return len(gapcheck.audit(deck).penetrations)
    found = audit()
    held = resident()
    for _ in range(5):
        assert audit() == found
    assert resident() - held < 10e6
