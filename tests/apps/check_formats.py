#!/usr/bin/env python3
"""Holds every format of gapcheck audit against readers that are not ours: jsonschema with the published schema of
gapcheck/1 (and gapcheck fix and start with theirs), the classes that were generated from the public schema of
SARIF 2.1.0, junitparser and xmllint, the csv module.

usage: check_formats.py GAPCHECK ROOT
With GAPCHECK_SARIF_SCHEMA set to a file with the public schema itself, SARIF is held against that, too, and JUnit against
the schema in GAPCHECK_JUNIT_SCHEMA (the one of Jenkins is public).
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
import junitparser
import sarif_om

CLASSES = {"tool": sarif_om.Tool, "driver": sarif_om.ToolComponent, "rules": sarif_om.ReportingDescriptor,
           "results": sarif_om.Result, "runs": sarif_om.Run, "locations": sarif_om.Location,
           "physicalLocation": sarif_om.PhysicalLocation, "artifactLocation": sarif_om.ArtifactLocation,
           "region": sarif_om.Region, "logicalLocations": sarif_om.LogicalLocation, "message": sarif_om.Message,
           "shortDescription": sarif_om.MultiformatMessageString, "help": sarif_om.MultiformatMessageString,
           "defaultConfiguration": sarif_om.ReportingConfiguration, "suppressions": sarif_om.Suppression,
           "location": sarif_om.Location, "relatedLocations": sarif_om.Location, "fixes": sarif_om.Fix,
           "description": sarif_om.Message, "artifactChanges": sarif_om.ArtifactChange,
           "replacements": sarif_om.Replacement, "deletedRegion": sarif_om.Region,
           "insertedContent": sarif_om.ArtifactContent, "artifacts": sarif_om.Artifact, "analysisTarget": sarif_om.ArtifactLocation,
           "invocations": sarif_om.Invocation, "toolExecutionNotifications": sarif_om.Notification,
           ("Artifact", "location"): sarif_om.ArtifactLocation}


def read_sarif(value, cls):
    """An object of the public model; a member that the model does not have, or one that it misses, raises."""
    names = {field.metadata.get("schema_property_name", field.name): field.name for field in attr.fields(cls)}
    arguments = {}
    for key, member in value.items():
        if key not in names:
            raise ValueError(f"{cls.__name__} has no {key}")
        of_member = CLASSES.get((cls.__name__, key), CLASSES.get(key))
        if of_member and isinstance(member, list):
            member = [read_sarif(item, of_member) for item in member]
        elif of_member:
            member = read_sarif(member, of_member)
        arguments[names[key]] = member
    return cls(**arguments)


class Checker:
    def __init__(self, gapcheck, root):
        self.gapcheck, self.root, self.related = gapcheck, root, 0
        schema = json.loads((root / "docs/schema/gapcheck-1.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        self.schema = jsonschema.Draft7Validator(schema)
        public = os.environ.get("GAPCHECK_SARIF_SCHEMA")
        self.junit = [root / "tests/apps/junit.xsd", *filter(None, [os.environ.get("GAPCHECK_JUNIT_SCHEMA")])]
        self.public = jsonschema.Draft7Validator(json.loads(pathlib.Path(public).read_text())) if public else None

    def write(self, arguments, name):
        run = subprocess.run([self.gapcheck, *arguments, "--format", name, "--fail-on", "warning"],
                             capture_output=True, cwd=self.root)
        if run.returncode not in (0, 1):
            raise SystemExit(f"{arguments} --format {name}: exit {run.returncode}: {run.stderr.decode()}")
        return run.stdout.decode(), run.returncode

    def read_junit(self, text):
        """The suites; their counts are those of their cases."""
        for schema in self.junit:
            subprocess.run(["xmllint", "--noout", "--schema", schema, "-"], check=True, input=text,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        suites = junitparser.JUnitXml.fromstring(text)
        cases = [case for suite in suites for case in suite]
        results = [result for case in cases for result in case.result]
        for said, kind in ((suites.failures, junitparser.Failure), (suites.errors, junitparser.Error)):
            assert said == sum(isinstance(result, kind) for result in results), "JUnit counts otherwise"
        assert suites.tests == len(cases)
        return suites

    def check(self, arguments, ignored=0):
        findings, status = self.write(arguments, "json")
        report = json.loads(findings)
        self.schema.validate(report)
        count = len(report["findings"])
        assert report["summary"].get("ignored", 0) == ignored
        assert sum(len(place["findings"]) for place in report.get("ignored", [])) == ignored

        log = json.loads(self.write(arguments, "sarif")[0])
        read = read_sarif(log, sarif_om.SarifLog)
        assert len(read.runs[0].results) == count + ignored, "SARIF has other findings"
        assert sum(bool(result.suppressions) for result in read.runs[0].results) == ignored
        known = [rule.id for rule in read.runs[0].tool.driver.rules]
        for result in read.runs[0].results:
            assert known[result.rule_index] == result.rule_id, "SARIF names another rule by its index"
        self.check_related(report, log["runs"][0]["results"])
        if self.public:
            self.public.validate(log)

        rows = list(csv.reader(io.StringIO(self.write(arguments, "csv")[0], newline=""), strict=True))
        assert len(rows) == 1 + count and all(len(row) == len(rows[0]) for row in rows), "CSV has other lines"

        entries = json.loads(self.write(arguments, "gitlab")[0])
        assert len({entry["fingerprint"] for entry in entries}) == count, "GitLab has other findings"

        suites = self.read_junit(self.write(arguments, "junit")[0].encode())
        assert (suites.failures > 0) == (status == 1), "JUnit fails where the exit code does not"
        assert sum(suite.skipped for suite in suites) > 0 if ignored else True, "JUnit skips what is ignored"

        for line in self.write(arguments, "github")[0].splitlines():
            assert line.startswith(("::error file=", "::warning file=", "::notice file=")), line
            assert ",title=GC" in line or ",title=ignored::" in line, line
        return count


    def check_related(self, report, results):
        """Every finding of a contact leads to the contact's card, and one that follows from another leads to that."""
        cards = {contact["id"]: contact.get("line") for contact in report["contacts"]}
        places = {finding["fingerprint"]: finding.get("line") for finding in report["findings"]}
        for finding, result in zip(report["findings"], results):
            related = result.get("relatedLocations", [])
            lines = [place["physicalLocation"]["region"]["startLine"] for place in related]
            assert all(place["message"]["text"] for place in related)
            card = cards.get(finding.get("contact"))
            assert card is None or card in lines or card == finding["line"], f"the contact's card is not in {result}"
            cause = places.get(finding.get("cause"))
            assert cause is None or cause in lines, f"what it follows from is not in {result}"
            self.related += len(related)


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
    """The report of a correction of every deck: written, verified by runs, and as a dry run with everything locked."""
    schema = json.loads((root / "docs/schema/gapcheck-fix-1.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(strict(schema))
    seen = set()
    with tempfile.TemporaryDirectory() as folder:
        for deck in sorted((root / "data").glob("*.k")):
            for more in (["-o", folder], ["--dry-run", "--lock", "1", "--verify", "--cycles", "3"],
                         ["--dry-run", "--lock", "node:1-1000000000"]):
                run = subprocess.run([gapcheck, "fix", deck, "--format", "json", *more], capture_output=True, text=True)
                assert run.returncode in (0, 1), f"{deck}: {run.stderr}"
                report = json.loads(run.stdout)
                validator.validate(report)
                proven = report.get("proof", {"holds": True})["holds"]
                assert (report["summary"]["complete"] and proven) == (run.returncode == 0), deck
                seen |= {key for key in ("moved", "unfixed", "proposals", "files", "proof") if report.get(key)}
    assert seen == {"moved", "unfixed", "proposals", "files", "proof"}, seen


def check_repairs(gapcheck, root):
    """The repairs of every deck: listed, and the best of them applied."""
    schemas = root / "docs/schema"
    seen, kinds = set(), set()
    for name, options in (("plan", ["--plan"]), ("applied", ["--best", "--dry-run", "--verify", "--cycles", "3"])):
        schema = json.loads((schemas / f"gapcheck-fix-{name}-1.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        resolver = jsonschema.RefResolver(schemas.as_uri() + "/", schema)
        validator = jsonschema.Draft7Validator(strict(schema), resolver=resolver)
        for deck in sorted((root / "data").glob("*.k")):
            run = subprocess.run([gapcheck, "fix", deck, "--format", "json", *options], capture_output=True, text=True)
            assert run.returncode in (0, 1), f"{deck}: {run.stderr}"
            report = json.loads(run.stdout)
            validator.validate(report)
            seen |= {key for key in ("pairs", "best", "lines", "files", "proof") if report.get(key)}
            kinds |= {repair["kind"] for pair in report.get("pairs", []) for repair in pair["repairs"]}
    assert seen == {"pairs", "best", "lines", "files", "proof"}, seen
    assert kinds == {"move", "optt", "sst", "sections", "ignore", "tie", "exclude", "swap"}, kinds


def with_fix(text, file, fix):
    """A deck's text after the replacements of a SARIF fix, which are whole lines."""
    lines = text.split("\n")
    for change in fix.artifact_changes:
        assert change.artifact_location.uri == file, "a repair of another file"
        for replacement in sorted(change.replacements, key=lambda one: -one.deleted_region.start_line):
            region = replacement.deleted_region
            assert (region.start_column, region.end_line, region.end_column) == (None, None, None)
            lines[region.start_line - 1] = replacement.inserted_content.text
    return "\n".join(lines)


def check_fixes(checker):
    """The repairs as SARIF: a reader that others wrote applies each, and gets the file that gapcheck writes."""
    fixes = 0
    with tempfile.TemporaryDirectory() as folder:
        for deck in sorted((checker.root / "data").glob("*.k")):
            name = str(deck.relative_to(checker.root))
            run = subprocess.run([checker.gapcheck, "fix", name, "--plan", "--format", "sarif"], capture_output=True,
                                 text=True, cwd=checker.root)
            assert run.returncode in (0, 1), run.stderr
            log = json.loads(run.stdout)
            if checker.public:
                checker.public.validate(log)
            (read,) = read_sarif(log, sarif_om.SarifLog).runs
            for fix in [fix for result in read.results for fix in result.fixes]:
                repair = fix.description.text.split(":")[0]
                run = subprocess.run([checker.gapcheck, "fix", name, "--apply", repair, "-o", folder, "--quiet"],
                                     capture_output=True, text=True, cwd=checker.root)
                assert run.returncode in (0, 1), run.stderr
                written = (pathlib.Path(folder) / deck.name).read_text()
                assert with_fix(deck.read_text(), name, fix) == written != deck.read_text(), f"{name}: {repair}"
                fixes += 1
    assert fixes > 50, fixes
    return fixes


def check_fixes_of_findings(checker):
    """audit --fixes: the results are those without it, and their fixes those of the plan, each with the first finding of
    its rule and pair of parts."""
    fixes, rules = 0, set()
    for deck in sorted((checker.root / "data").glob("*.k")):
        name = str(deck.relative_to(checker.root))
        plain = json.loads(checker.write(["audit", name], "sarif")[0])
        log = json.loads(checker.write(["audit", name, "--fixes"], "sarif")[0])
        if checker.public:
            checker.public.validate(log)
        read_sarif(log, sarif_om.SarifLog)
        of_plan = json.loads(subprocess.run([checker.gapcheck, "fix", name, "--plan", "--format", "sarif"],
                                            capture_output=True, cwd=checker.root, check=False).stdout or "{}")
        planned = [fix for result in of_plan["runs"][0]["results"] for fix in result["fixes"]] if of_plan else []
        seen = set()
        for result in log["runs"][0]["results"]:
            for fix in result.pop("fixes", []):
                key = (result["ruleId"], fix["description"]["text"])
                assert fix in planned and key not in seen, f"{name}: {key}"
                seen.add(key)
                rules.add(result["ruleId"])
                fixes += 1
        assert log == plain, f"{name}: --fixes adds nothing but fixes"
    assert fixes > 100 and {"GC101", "GC308"} <= rules, (fixes, rules)
    run = subprocess.run([checker.gapcheck, "audit", "data/two_plates.k", "--fixes"], capture_output=True,
                         cwd=checker.root, text=True)
    assert run.returncode == 2 and "--format sarif" in run.stderr, run.stderr
    decks = ["data/two_plates.k", "data/t_joint.k"]
    several = json.loads(checker.write(["audit", *decks, "--fixes"], "sarif")[0])
    of_decks = {result["analysisTarget"]["uri"] for result in several["runs"][0]["results"] if "fixes" in result}
    assert of_decks == {"data/two_plates.k"}, of_decks


def check_start(gapcheck, root):
    """The start of every deck, as it runs and as it is written."""
    schema = json.loads((root / "docs/schema/gapcheck-start-1.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(strict(schema))
    lists, seen = {"contacts", "pairs", "moves", "moved_again", "elements", "files"}, set()
    with tempfile.TemporaryDirectory() as folder:
        for deck in sorted((root / "data").glob("*.k")):
            run = subprocess.run([gapcheck, "start", deck, "--format", "json", "--write-deck", folder],
                                 capture_output=True, text=True)
            assert run.returncode in (0, 1), f"{deck}: {run.stderr}"
            report = json.loads(run.stdout)
            validator.validate(report)
            assert report["summary"]["clean"] == (run.returncode == 0), deck
            assert all(contact["score"] == "starts clean" or not report["summary"]["clean"] or "not_known" in contact
                       for contact in report["contacts"]), deck
            seen |= {key for key in lists if report[key]}
    assert seen == lists, lists - seen


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


def check_portability(checker):
    """What other programs do not read is a list as the schema has it, with no other keys."""
    report = json.loads(checker.write(["audit", "data/mortar_not_checked.k", "--portability"], "json")[0])
    jsonschema.Draft7Validator(strict(checker.schema.schema["properties"]["portability"])).validate(report["portability"])
    assert "MORTAR" in [note["name"] for note in report["portability"]]


def check_several(checker):
    """Several decks in one call, one of which cannot be read: every format holds the findings of each."""
    decks = ["data/two_plates.k", "data/missing.k", "data/two_plates_crossing.k"]
    alone = [json.loads(checker.write(["audit", deck], "json")[0]) for deck in (decks[0], decks[2])]
    written = {name: subprocess.run([checker.gapcheck, "audit", *decks, "--format", name], cwd=checker.root,
                                    capture_output=True) for name in ("json", "sarif", "csv", "gitlab", "junit", "github")}
    assert all(run.returncode == 2 for run in written.values())
    report = json.loads(written["json"].stdout)
    checker.schema.validate(report)
    assert [deck["findings"] for deck in report["decks"]] == [deck["findings"] for deck in alone]
    counts = [len(deck["findings"]) for deck in alone]
    total = {key: sum(deck["summary"][key] for deck in alone) for key in ("errors", "warnings", "notes")}
    assert report["summary"] == {"decks": 2, "unread": 1} | total and report["unread"] == ["data/missing.k"]
    rules = {rule["id"]: rule for rule in report["rules"]}
    for rule in rules.values():
        of_rule = [[finding for finding in deck["findings"] if finding["id"] == rule["id"]] for deck in alone]
        assert (rule["decks"], rule["findings"]) == (sum(map(bool, of_rule)), sum(map(len, of_rule))), rule
    assert set(rules) == {finding["id"] for deck in alone for finding in deck["findings"]} and len(rules) > 2
    log = json.loads(written["sarif"].stdout)
    if checker.public:
        checker.public.validate(log)
    (run,) = read_sarif(log, sarif_om.SarifLog).runs
    assert [artifact.location.uri for artifact in run.artifacts] == [decks[0], decks[2]]
    assert [sum(result.analysis_target.index == deck for result in run.results) for deck in (0, 1)] == counts
    (missing,) = run.invocations[0].tool_execution_notifications
    assert missing.message.text.startswith("data/missing.k: "), missing
    rows = list(csv.DictReader(io.StringIO(written["csv"].stdout.decode(), newline="")))
    assert [sum(row["deck"] == deck for row in rows) for deck in (decks[0], decks[2])] == counts
    entries = json.loads(written["gitlab"].stdout)
    assert len({entry["fingerprint"] for entry in entries}) == sum(counts)
    suites = checker.read_junit(written["junit"].stdout)
    assert suites.errors == 1 and [suite.name for suite in suites][-1] == "data/missing.k"
    assert all(line.startswith(b"::") for line in written["github"].stdout.splitlines())


def check_ignores(checker):
    """A deck with comments that leave findings out, together with a baseline: every format agrees."""
    deck = (checker.root / "data/two_plates.k").read_text()
    comments = ("$ gapcheck: ignore GC101 node=1000-1999 because it is \"agreed\" & <done>\n"
                "$ gapcheck: ignore GC101 node=2001\n$ gapcheck: ignore GC102 contact=9\n"
                "$ gapcheck: ignore GC101 until=2020-12-31\n$ gapcheck: ignore everything\n")
    with tempfile.TemporaryDirectory() as folder:
        path, baseline = pathlib.Path(folder) / "deck.k", pathlib.Path(folder) / "baseline"
        path.write_text(comments + deck)
        arguments = ["audit", str(path), "--select", "GC1,GC513,GC514,GC515"]
        count = checker.check(arguments, ignored=10)
        report = json.loads(checker.write(arguments, "json")[0])
        assert count == 8 + 3, "unused, expired, bad, and what is left"
        assert [(place["line"], place["count"]) for place in report["ignored"]] == [(1, 9), (2, 1)]
        assert {finding["id"] for finding in report["findings"]} == {"GC101", "GC513", "GC514", "GC515"}
        run = subprocess.run([checker.gapcheck, *arguments, "--format", "csv"], capture_output=True, check=True)
        assert b"10 ignored" in run.stderr, run.stderr
        path.write_text(deck)
        subprocess.run([checker.gapcheck, *arguments, "--quiet", "--write-baseline", baseline], check=True,
                       stdout=subprocess.DEVNULL)
        path.write_text(comments + deck)
        report = json.loads(checker.write([*arguments, "--baseline", str(baseline)], "json")[0])
        checker.schema.validate(report)
        assert report["summary"]["baseline"] == {"new": 3, "worse": 0, "unchanged": 8, "gone": 0}, report["summary"]
        subprocess.run([checker.gapcheck, *arguments, "--quiet", "--write-baseline", baseline], check=True,
                       stdout=subprocess.DEVNULL)
        assert len(baseline.read_text().splitlines()) == 1 + count, "a baseline has nothing that is left out"


def check_settings(checker):
    """A settings file that leaves findings out and makes others graver: every format agrees."""
    with tempfile.TemporaryDirectory() as folder:
        settings = pathlib.Path(folder) / "gapcheck.toml"
        settings.write_text('[severity]\nGC101 = "error"\n[[exception]]\nignore = "GC101"\nnode = "1000-1999"\n'
                            'because = "agreed"\n')
        arguments = ["audit", "data/two_plates.k", "--config", str(settings)]
        checker.check(arguments, ignored=9)
        report = json.loads(checker.write(arguments, "json")[0])
        assert report["settings"] == str(settings)
        assert report["summary"]["errors"] == 9
        results = read_sarif(json.loads(checker.write(arguments, "sarif")[0]), sarif_om.SarifLog).runs[0].results
        suppressions = [entry for result in results for entry in result.suppressions or []]
        assert [entry.kind for entry in suppressions] == ["external"] * 9, suppressions
        assert sum(result.level == "error" for result in results) == 18


def can_fail(checker):
    """The readers notice what is wrong."""
    report = json.loads(checker.write(["audit", "data/two_plates.k"], "json")[0])
    report["findings"][0]["severity"] = "grave"
    assert not checker.schema.is_valid(report)
    assert not checker.schema.is_valid({"schema": "gapcheck/1", "source": "deck", "summary": report["summary"]})
    assert not checker.schema.is_valid({"schema": "gapcheck/1", "source": "decks", "decks": [report], "unread": [],
                                        "summary": report["summary"]})
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
    check_several(checker)
    check_portability(checker)
    check_ignores(checker)
    check_settings(checker)
    check_fix(checker.gapcheck, checker.root)
    check_repairs(checker.gapcheck, checker.root)
    check_start(checker.gapcheck, checker.root)
    fixes = check_fixes(checker)
    check_fixes_of_findings(checker)
    decks = sorted(checker.root.glob("data/*.k"))
    findings = sum(checker.check(["audit", str(deck.relative_to(checker.root))]) for deck in decks)
    assert len(decks) > 30 and findings > 300
    logs = [f"tests/apps/fixtures/{name}" for name in ("smp/messag", "mpp/mes0000", "clean/messag", "soft2/messag")]
    findings += sum(checker.check(["messag", log]) for log in logs)
    assert checker.related > 300, checker.related
    print(f"{len(decks)} decks, {len(logs)} logs, {findings} findings, {fixes} fixes, every format as its readers want it")


if __name__ == "__main__":
    main()
