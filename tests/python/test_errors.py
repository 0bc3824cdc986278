"""Whatever is given, there is an exception that names it, and the interpreter lives."""
import datetime
import os
import pathlib
import pickle

import numpy
import pytest
from conftest import DATA

import gapcheck

PLATES = DATA / "two_plates.k"


def test_an_error_says_where(tmp_path):
    with pytest.raises(gapcheck.Error, match="cannot be opened") as caught:
        gapcheck.audit(tmp_path / "none.k")
    error = caught.value
    assert error.file == str(tmp_path / "none.k") and error.line == 0 and error.diagnostics == ()
    assert str(error) == f"{error.file}: {error.message}" and isinstance(error, Exception)
    deck = tmp_path / "deck.k"
    deck.write_text("*KEYWORD\n*NODE\n1,what,0.,0.\n*END\n")
    with pytest.raises(gapcheck.Error) as caught:
        gapcheck.fix(deck)
    error = caught.value
    assert error.line > 0 and str(error).startswith(f"{deck}:{error.line}: ")


def test_diagnostics_of_an_error(tmp_path):
    deck = tmp_path / "deck.k"
    deck.write_text("*KEYWORD\n*INCLUDE\nmissing.k\n*NODE\n1,what,0.,0.\n*END\n")
    with pytest.raises(gapcheck.Error) as caught:
        gapcheck.fix(deck)
    assert caught.value.diagnostics and caught.value.diagnostics[0].severity in ("error", "warning")
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and type(again) is gapcheck.Error


def test_faults_of_the_text_leave_a_report():
    report = gapcheck.audit_text("*KEYWORD\n*NODE\n1,what,0.,0.\n*END\n", "faulty.k")
    assert not report.complete and report.diagnostics[0].severity == "error"
    assert report.diagnostics[0].line == 3 and "what" in report.diagnostics[0].message
    assert "not complete" in repr(report) and "not read in full" in report._repr_html_()


@pytest.mark.parametrize("name, value, error, words", [
    ("select", ["GC7"], gapcheck.Error, "select: 'GC7' is not a rule on decks"),
    ("select", 5, TypeError, "select: a list of str is needed, not 5 (int)"),
    ("ignore", [None], TypeError, "ignore: a list of str"),
    ("contacts", [99], gapcheck.Error, "contact 99: the deck has no such contact"),
    ("contacts", ["1"], TypeError, "contacts: a list of whole numbers is needed, not '1' (str)"),
    ("contacts", [1.5], TypeError, "contacts"),
    ("contacts", 10**30, TypeError, "contacts"),
    ("contacts", numpy.array(5.5), TypeError, "contacts: a list of whole numbers"),
    ("contacts", [numpy.float32(1)], TypeError, "contacts: a list of whole numbers"),
    ("jobs", 1.0, TypeError, "jobs: a whole number"),
    ("parts", [7], gapcheck.Error, "part 7: the deck has no such part"),
    ("ptol", -1, gapcheck.Error, "ptol: -1 is not a number of 0 or more"),
    ("ptol", float("nan"), gapcheck.Error, "ptol: nan"),
    ("ptol", "0.1", TypeError, "ptol: a number is needed, not '0.1' (str)"),
    ("ratio", [0.1], TypeError, "ratio: a number"),
    ("rtol", 1j, TypeError, "rtol: a number"),
    ("severities", {"GC1": "note"}, gapcheck.Error, "severities: 'GC1' is not a rule"),
    ("severities", {"GC101": "grave"}, TypeError, "severities"),
    ("severities", {"GC101": 2}, TypeError, "severities"),
    ("severities", ["GC101"], TypeError, "severities"),
    ("millimetre", 0, gapcheck.Error, "millimetre: 0 is not a length"),
    ("today", "2026-01-01", TypeError, "today: a datetime.date is needed, not str"),
    ("jobs", -1, TypeError, "jobs: a whole number of 0 or more is needed, not -1"),
    ("jobs", 10**6, ValueError, "jobs: at most 4096"),
    ("jobs", "many", TypeError, "jobs"),
    ("exact", "yes", TypeError, "exact: True or False is needed, not 'yes' (str)"),
    ("progress", 5, TypeError, "progress: a function is needed, not 5 (int)"),
    ("includes", 5, TypeError, "."),
    ("includes", ["a\0b"], ValueError, "null byte"),
    ("parameters", [5], TypeError, "parameters: a list of str"),
    ("surprise", 1, TypeError, "surprise"),
])
def test_options_that_cannot_be_meant(name, value, error, words):
    import re
    with pytest.raises(error, match=re.escape(words) if words != "." else words):
        gapcheck.audit(PLATES, **{name: value})


def test_options_that_can_be_meant():
    assert len(gapcheck.audit(PLATES, select="GC1", contacts=1, parts=numpy.array([1])).penetrations) == 18
    assert len(gapcheck.audit(PLATES, select={"GC101"}, contacts=numpy.int32(1), ptol=numpy.float32(0.31)).penetrations) == 0
    assert gapcheck.audit(PLATES, severities={"initial-penetration": "error"}).totals.errors == 18
    assert gapcheck.audit(PLATES, today=datetime.date(1950, 1, 1), exact=numpy.True_, jobs=1).totals.warnings == 18
    assert len(gapcheck.audit(PLATES, select=(rule for rule in ["GC2"])).penetrations) == 0
    text = PLATES.read_text().replace("*KEYWORD\n", "*KEYWORD\n*PARAMETER\nR thick, 1.0\n").replace(
        "       1.0", "    &thick", 1)
    assert len(gapcheck.audit_text(text).penetrations) == 18
    assert len(gapcheck.audit_text(text, parameters={"thick": 0.2}).penetrations) in (0, 18)


@pytest.mark.parametrize("deck", [None, 5, 1.5, object(), [None], numpy.arange(3), {}])
def test_what_is_no_path(deck, tmp_path):
    for function in (gapcheck.audit, gapcheck.fix, gapcheck.read_curves, lambda path: gapcheck.run(path, tmp_path / "out"),
                     lambda path: gapcheck.compare(path, PLATES), lambda path: gapcheck.read_run(path)):
        with pytest.raises((TypeError, gapcheck.Error)):
            function(deck)


@pytest.mark.parametrize("deck", ["", b"", "a\0b.k", "no such\nfile", "x" * 10000, "/", ".", "\udcff.k"])
def test_paths_of_nothing(deck):
    for function in (gapcheck.audit, gapcheck.fix, gapcheck.read_curves, gapcheck.read_run):
        try:
            function(deck)
        except (gapcheck.Error, ValueError) as error:
            assert str(error).encode("utf-8", "surrogateescape")
        else:
            assert deck in ("/", ".") and function is gapcheck.read_curves


@pytest.mark.parametrize("name", ["mit Leerzeichen.k", "Größe ü.k", b"latin \xfc.k", "日本.k", "-x.k", "a'b\"c$(d).k"])
def test_any_path_works(name, tmp_path):
    path = os.path.join(os.fsencode(tmp_path), os.fsencode(name))
    pathlib.Path(os.fsdecode(path)).write_bytes(PLATES.read_bytes())
    for given in (path, os.fsdecode(path), pathlib.Path(os.fsdecode(path))):
        report = gapcheck.audit(given)
        assert len(report.penetrations) == 18 and report.input == os.fsdecode(path) and report.files == (os.fsdecode(path),)
        assert set(report.penetrations.to_frame()["path"]) == {os.fsdecode(path)}
        assert report.to_json() and report._repr_html_() and repr(report)
    written = gapcheck.fix(path).write(os.path.join(path + b" out", b"a"))
    assert len(gapcheck.audit(written[0]).penetrations) == 0


def test_words_that_are_not_utf_8(tmp_path):
    deck = tmp_path / "deck.k"
    deck.write_bytes(PLATES.read_bytes().replace(b"all parts", b"T\xfcr"))
    report = gapcheck.audit(deck)
    assert report.contacts[0].title == "T\ufffdr" and "T\ufffdr" in report._repr_html_()
    assert report.to_text() and report.to_json() and report.to_sarif()


@pytest.mark.parametrize("text", [None, 5, [], object()])
def test_what_is_no_text(text):
    with pytest.raises(TypeError, match="text: a str or bytes is needed"):
        gapcheck.audit_text(text)


def test_texts_of_all_types():
    content = PLATES.read_bytes()
    for text in (content, content.decode(), bytearray(content), memoryview(content)):
        assert len(gapcheck.audit_text(text).penetrations) == 18
    for text in ("", "nonsense", "\0" * 1000, b"\xff" * 1000, "*KEYWORD\n", "*END"):
        try:
            assert gapcheck.audit_text(text).penetrations is not None
        except gapcheck.Error as error:
            assert error.message


def test_several_decks():
    reports = gapcheck.audit([PLATES, str(DATA / "clean.k")])
    assert [len(report.penetrations) for report in reports] == [18, 0] and gapcheck.audit([]) == []
    with pytest.raises(gapcheck.Error, match="none.k"):
        gapcheck.audit([PLATES, "none.k"])


def test_the_module_itself_refuses_strange_things():
    core = gapcheck._core
    report = gapcheck.audit(PLATES)._core
    for call in (lambda: core.audit_deck(), lambda: core.audit_deck(str(PLATES), None), lambda: core.write(None, "json", {}),
                 lambda: core.write(report, None, {}), lambda: core.audit_text("x", "y", {}), lambda: core.Report(),
                 lambda: core.audit_arrays(None, None, None, {}, {}), lambda: core.rules(1),
                 lambda: core.penetration_columns(None), lambda: core.tie_columns(5), lambda: core.mesh_columns("x")):
        with pytest.raises(TypeError):
            call()
    with pytest.raises((TypeError, RuntimeError)):
        type(report).contacts.fget(5)
    with pytest.raises(ValueError, match="no format"):
        core.write(report, "pdf", {})
    with pytest.raises(ValueError, match="fail_on"):
        gapcheck.audit(PLATES).to_junit(fail_on="sometimes")
    with pytest.raises(TypeError):
        gapcheck.audit(PLATES).to_text(top=-1)
    with pytest.raises(AttributeError):
        report.contacts = ()
