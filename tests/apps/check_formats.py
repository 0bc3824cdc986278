#!/usr/bin/env python3
"""Holds every format of gapcheck audit against readers that are not ours: jsonschema with the published schema of
gapcheck/1 (and gapcheck fix with that of gapcheck-fix/1), the classes that were generated from the public schema of SARIF 2.1.0, xmllint, the csv module.

usage: check_formats.py GAPCHECK ROOT
With GAPCHECK_SARIF_SCHEMA set to a file with the public schema itself, SARIF is held against that, too.
"""

import csv
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import attr
import jsonschema
import sarif_om

CLASSES = {"tool": sarif_om.Tool, "driver": sarif_om.ToolComponent, "rules": sarif_om.ReportingDescriptor,
           "results": sarif_om.Result, "runs": sarif_om.Run, "locations": sarif_om.Location,
           "physicalLocation": sarif_om.PhysicalLocation, "artifactLocation": sarif_om.ArtifactLocation,
           "region": sarif_om.Region, "logicalLocations": sarif_om.LogicalLocation, "message": sarif_om.Message,
           "shortDescription": sarif_om.MultiformatMessageString, "help": sarif_om.MultiformatMessageString,
           "defaultConfiguration": sarif_om.ReportingConfiguration}


def read_sarif(value, cls):
    """An object of the public model; a member that the model does not have, or one that it misses, raises."""
    names = {field.metadata.get("schema_property_name", field.name): field.name for field in attr.fields(cls)}
    arguments = {}
    for key, member in value.items():
        if key not in names:
            raise ValueError(f"{cls.__name__} has no {key}")
        if key in CLASSES and isinstance(member, list):
            member = [read_sarif(item, CLASSES[key]) for item in member]
        elif key in CLASSES:
            member = read_sarif(member, CLASSES[key])
        arguments[names[key]] = member
    return cls(**arguments)


class Checker:
    def __init__(self, gapcheck, root):
        self.gapcheck, self.root = gapcheck, root
        schema = json.loads((root / "docs/schema/gapcheck-1.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        self.schema = jsonschema.Draft7Validator(schema)
        public = os.environ.get("GAPCHECK_SARIF_SCHEMA")
        self.public = jsonschema.Draft7Validator(json.loads(pathlib.Path(public).read_text())) if public else None

    def write(self, arguments, name):
        run = subprocess.run([self.gapcheck, *arguments, "--format", name, "--fail-on", "warning"],
                             capture_output=True, cwd=self.root)
        if run.returncode not in (0, 1):
            raise SystemExit(f"{arguments} --format {name}: exit {run.returncode}: {run.stderr.decode()}")
        return run.stdout.decode(), run.returncode

    def check(self, arguments):
        findings, status = self.write(arguments, "json")
        report = json.loads(findings)
        self.schema.validate(report)
        count = len(report["findings"])

        log = json.loads(self.write(arguments, "sarif")[0])
        read = read_sarif(log, sarif_om.SarifLog)
        assert len(read.runs[0].results) == count, "SARIF has other findings"
        known = [rule.id for rule in read.runs[0].tool.driver.rules]
        for result in read.runs[0].results:
            assert known[result.rule_index] == result.rule_id, "SARIF names another rule by its index"
        if self.public:
            self.public.validate(log)

        rows = list(csv.reader(io.StringIO(self.write(arguments, "csv")[0], newline=""), strict=True))
        assert len(rows) == 1 + count and all(len(row) == len(rows[0]) for row in rows), "CSV has other lines"

        entries = json.loads(self.write(arguments, "gitlab")[0])
        assert len({entry["fingerprint"] for entry in entries}) == count, "GitLab has other findings"

        junit = self.write(arguments, "junit")[0]
        with tempfile.NamedTemporaryFile(suffix=".xml") as file:
            file.write(junit.encode())
            file.flush()
            subprocess.run(["xmllint", "--noout", "--schema", self.root / "tests/apps/junit.xsd", file.name], check=True,
                           stderr=subprocess.DEVNULL)
        assert ("<failure " in junit) == (status == 1), "JUnit fails where the exit code does not"

        for line in self.write(arguments, "github")[0].splitlines():
            assert line.startswith(("::error file=", "::warning file=", "::notice file=")) and ",title=GC" in line, line
        return count


def strict(schema):
    """The schema without leave to have other keys than it names."""
    if isinstance(schema, list):
        return [strict(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    copy = {key: strict(member) for key, member in schema.items()}
    if "properties" in copy and copy.get("type") == "object":
        copy["additionalProperties"] = False
    return copy


def check_fix(gapcheck, root):
    """The report of a correction of every deck: written, and as a dry run with something locked."""
    schema = json.loads((root / "docs/schema/gapcheck-fix-1.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(strict(schema))
    seen = set()
    with tempfile.TemporaryDirectory() as folder:
        for deck in sorted((root / "data").glob("*.k")):
            for more in (["-o", folder], ["--dry-run", "--lock", "1"]):
                run = subprocess.run([gapcheck, "fix", deck, "--format", "json", *more], capture_output=True, text=True)
                assert run.returncode in (0, 1), f"{deck}: {run.stderr}"
                report = json.loads(run.stdout)
                validator.validate(report)
                assert report["summary"]["complete"] == (run.returncode == 0), deck
                seen |= {key for key in ("moved", "unfixed", "proposals", "files") if report[key]}
    assert seen == {"moved", "unfixed", "proposals", "files"}, seen


def check_baseline(checker):
    """One deck against the baseline of a shallower one, with a finding that is gone: every format agrees."""
    deck = (checker.root / "data/two_plates.k").read_text()
    with tempfile.TemporaryDirectory() as folder:
        path, baseline = pathlib.Path(folder) / "deck.k", pathlib.Path(folder) / "baseline"
        path.write_text(deck)
        subprocess.run([checker.gapcheck, "audit", path, "--quiet", "--write-baseline", baseline], check=True,
                       stdout=subprocess.DEVNULL)
        with baseline.open("a") as file:
            file.write('{"id":"GC101","rule":"initial-penetration","severity":"warning","position":[900,0,0]}\n')
        path.write_text(deck.replace("             0.7\n", "             0.6\n"))
        arguments = ["audit", str(path), "--baseline", str(baseline)]
        report = json.loads(checker.write(arguments, "json")[0])
        checker.schema.validate(report)
        states = [finding["baseline"] for finding in report["findings"]]
        counts = report["summary"]["baseline"]
        assert {state: states.count(state) for state in ("new", "worse", "unchanged")} | {"gone": 1} == counts, counts
        assert counts["worse"] >= 18 and len(report["gone"]) == 1
        results = read_sarif(json.loads(checker.write(arguments, "sarif")[0]), sarif_om.SarifLog).runs[0].results
        words = {"new": "new", "worse": "updated", "unchanged": "unchanged"}
        assert [result.baseline_state for result in results] == [words[state] for state in states] + ["absent"]
        rows = list(csv.DictReader(io.StringIO(checker.write(arguments, "csv")[0], newline="")))
        assert [row["baseline"] for row in rows] == states
        counting = sum(state != "unchanged" for state in states)
        assert len(json.loads(checker.write(arguments, "gitlab")[0])) == counting


def can_fail(checker):
    """The readers notice what is wrong."""
    report = json.loads(checker.write(["audit", "data/two_plates.k"], "json")[0])
    report["findings"][0]["severity"] = "grave"
    assert not checker.schema.is_valid(report)
    for broken in ({"runs": [{"results": []}], "version": "2.1.0"}, {"runs": [], "version": "2.1.0", "more": 1}):
        try:
            read_sarif(broken, sarif_om.SarifLog)
        except (TypeError, ValueError):
            continue
        raise AssertionError(f"taken for SARIF: {broken}")


def main():
    checker = Checker(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
    can_fail(checker)
    check_baseline(checker)
    check_fix(checker.gapcheck, checker.root)
    decks = sorted(checker.root.glob("data/*.k"))
    findings = sum(checker.check(["audit", str(deck.relative_to(checker.root))]) for deck in decks)
    assert len(decks) > 30 and findings > 300
    logs = [f"tests/apps/fixtures/{name}" for name in ("smp/messag", "mpp/mes0000", "clean/messag", "soft2/messag")]
    findings += sum(checker.check(["messag", log]) for log in logs)
    print(f"{len(decks)} decks, {len(logs)} logs, {findings} findings, every format as its readers want it")


if __name__ == "__main__":
    main()
