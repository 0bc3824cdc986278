"""Reports: what they say of themselves, and how they are written."""
import json
import os
import subprocess
import xml.etree.ElementTree as xml

import pytest
from conftest import DATA, ROOT

import gapcheck


def test_totals_contacts_and_findings(plates):
    assert (plates.totals.errors, plates.totals.warnings) == (0, 18)
    assert plates.source == "deck" and plates.complete and plates.ignored == 0 and plates.run is None
    assert plates.model.shells == 18 and plates.model.parts == 2
    (contact,) = plates.contacts
    assert (contact.id, contact.penetrations, contact.title) == (1, 18, "all parts")
    assert contact.max_penetration == plates.penetrations.depth.max() == pytest.approx(0.3, abs=1e-12)
    assert {finding.rule for finding in plates.findings} == {"ignore-recommended", "penetration-free-at"}
    assert plates.predicted.contact > 0 and plates.predicted.surfaces[0].side in "AB"
    assert repr(plates).endswith(": 0 errors, 18 warnings, 2 notes; 18 penetrations, 0 ties, 1 contacts>")
    assert "Contact(id=1" in repr(contact)
    with pytest.raises(AttributeError):
        contact.id = 2


def test_frames_of_records(plates):
    frame = plates.contacts.to_frame()
    assert frame["penetrations"].tolist() == [18] and "max_penetration" in frame
    assert set(plates.findings.to_frame()["id"]) == {finding.id for finding in plates.findings}
    assert len(gapcheck.Records().to_frame()) == 0


def test_pairs_of_parts():
    pairs = gapcheck.audit(DATA / "two_plates_tilted.k").part_pairs()
    found = gapcheck.audit(DATA / "two_plates_tilted.k").penetrations
    assert pairs[["part", "other_part"]].values.tolist() == [[1, 2]]
    assert pairs["penetrations"].tolist() == [len(found)]
    assert pairs["deepest"][0] == found.depth.max() and pairs["node"][0] == found.node[found.depth.argmax()]


@pytest.mark.parametrize("form, option", [("text", "text"), ("json", "json"), ("sarif", "sarif"), ("junit", "junit"),
                                          ("csv", "csv")])
def test_formats_are_those_of_the_program(form, option, program, tmp_path, monkeypatch):
    done = subprocess.run([program, "audit", "data/two_plates.k", "--format", option, "--fail-on", "error"], cwd=ROOT,
                          capture_output=True).stdout.decode()
    monkeypatch.chdir(ROOT)
    report = gapcheck.audit("data/two_plates.k")

    def timeless(text):
        if form == "json":
            return {name: value for name, value in json.loads(text).items() if name != "timing"}
        if form == "junit":
            root = xml.fromstring(text)
            for element in root.iter():
                element.attrib.pop("time", None)
            return xml.tostring(root)
        return text

    text = getattr(report, f"to_{form}")()
    assert timeless(text) == timeless(done)
    path = tmp_path / "out put ü"
    assert getattr(report, f"to_{form}")(path) is None
    assert timeless(path.read_bytes().decode()) == timeless(text)
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_page_and_grid(tmp_path):
    report = gapcheck.audit(DATA / "two_plates.k", picture=True, mesh=True)
    assert "<html" in report.to_html() and len(report.to_html()) > len(gapcheck.audit(DATA / "two_plates.k").to_html())
    grid = report.to_vtu()
    assert 'NumberOfCells="18"' in grid and 'NumberOfPoints="32"' in grid
    report.to_vtu(tmp_path / "grid.vtu")
    assert (tmp_path / "grid.vtu").read_text() == grid


def test_no_file_of_the_deck_is_written_over(tmp_path):
    deck = tmp_path / "deck.k"
    content = (DATA / "two_plates.k").read_bytes()
    deck.write_bytes(content)
    (tmp_path / "link.json").symlink_to(deck)
    report = gapcheck.audit(deck)
    for path in (deck, str(deck), os.fsencode(deck), tmp_path / "." / "deck.k", tmp_path / "link.json"):
        with pytest.raises(gapcheck.Error, match="not written over"):
            report.to_json(path)
    assert deck.read_bytes() == content
    with pytest.raises(OSError):
        report.to_json(tmp_path / "none" / "report.json")
    with pytest.raises(OSError):
        report.to_json(tmp_path)
    with pytest.raises(TypeError):
        report.to_json(5.5)
    assert len(list(tmp_path.iterdir())) == 2


def test_notebook(plates):
    text = plates._repr_html_()
    assert "18 warnings" in text and "<td>CONTACT_AUTOMATIC_SINGLE_SURFACE</td>" in text and "iframe" not in text
    picture = gapcheck.audit(DATA / "two_plates.k", picture=True)._repr_html_()
    assert '<iframe sandbox="allow-scripts"' in picture and 'srcdoc="&lt;!' in picture
    xml.fromstring(text)  # well-formed


def test_text_of_decks_is_escaped_in_notebooks():
    deck = (DATA / "two_plates.k").read_text().replace("all parts", "<script>x</script>&")
    text = gapcheck.audit_text(deck, "<b>.k")._repr_html_()
    assert "<script>" not in text and "&lt;script&gt;x&lt;/script&gt;&amp;" in text and "&lt;b&gt;.k" in text


def test_rules():
    rules = gapcheck.rules()
    assert len(rules) > 80 and rules[0].id == "GC101" and rules[0].name == "initial-penetration"
    assert all(rule.page.startswith("# ") and rule.severity in ("note", "warning", "error") for rule in rules)
    assert [rule.of_runs for rule in rules] == [rule.id.startswith("GC6") for rule in rules]


def test_version(program):
    printed = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
    assert printed.startswith(f"gapcheck {gapcheck.__version__} ")
