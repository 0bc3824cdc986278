"""What the tests of the Python package share. PYTHONPATH names the package, GAPCHECK_BUILD the build folder that it is in,
GAPCHECK_PROGRAM the program of the same build."""
import os
import pathlib

import pytest

import gapcheck

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "data"


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config):
    """Where Google Test writes its results, there go these too."""
    kind, _, folder = os.environ.get("GTEST_OUTPUT", "").partition(":")
    if kind == "xml" and folder.endswith("/") and not config.option.xmlpath:
        config.option.xmlpath = folder + "python.xml"


@pytest.fixture(scope="session")
def program():
    return str(pathlib.Path(os.environ["GAPCHECK_PROGRAM"]).resolve())


@pytest.fixture(scope="session")
def build():
    return pathlib.Path(os.environ["GAPCHECK_BUILD"]).resolve()


@pytest.fixture
def plates():
    """The report of two plates with 18 penetrations of 0.3."""
    return gapcheck.audit(DATA / "two_plates.k")


@pytest.fixture(scope="session")
def large():
    """A deck of 320,000 shells in two plates, as text: an audit of it takes some tenths of a second."""
    import numpy
    n = 400
    x, y = numpy.meshgrid(numpy.arange(n + 1.0), numpy.arange(n + 1.0))
    plate = numpy.stack([x.ravel(), y.ravel(), numpy.zeros(x.size)], axis=1)
    corner = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n)).ravel()
    quads = numpy.stack([corner, corner + 1, corner + n + 2, corner + n + 1], axis=1)
    points = numpy.concatenate([plate, plate + (0.5, 0.5, 0.3)])
    shells = numpy.concatenate([quads, quads + len(plate)])
    return gapcheck.shell_deck(points, shells, 1.0, numpy.repeat([1, 2], len(quads)))
