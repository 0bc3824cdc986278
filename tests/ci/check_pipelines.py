#!/usr/bin/env python3
"""Runs the files of docs/ci for GitHub, GitLab and Jenkins, and action.yml, in scratch repositories of decks, step by step as
the runners do (runners.py), and reads what they leave: exit codes, annotations, summaries, SARIF, JUnit, code quality.

usage: check_pipelines.py GAPCHECK
"""

import json
import pathlib
import sys
import tempfile

import junitparser

from repository import ROOT, Repository, body, main_deck
from runners import GitHub, gitlab, jenkins, without_installing

CI = ROOT / "docs/ci"


class Pipelines:
    def __init__(self, folder, gapcheck):
        self.folder, self.gapcheck, self.count = folder, gapcheck, 0

    def repository(self, **decks):
        """A repository with decks in models/, each of the example that it names."""
        self.count += 1
        repository = Repository(self.folder / f"repository{self.count}", self.gapcheck)
        for name, example in decks.items():
            repository.write(f"models/{name}.inc", body(example))
            repository.write(f"models/{name}.k", main_deck(f"{name}.inc"))
        repository.commit()
        self.calls = without_installing(repository)
        return repository

    def findings(self, repository):
        """How many findings the decks of a repository have, as gapcheck alone says."""
        said, _ = repository.call("gapcheck", "audit", "models/*.k", "--format", "csv")
        return len([line for line in said.splitlines() if "GC" in line])

    def check_github(self):
        repository = self.repository(clean="clean", plates="two_plates")
        runner = GitHub(repository)
        assert runner.workflow(CI / "github.yml") == 1, runner.said
        assert "curl -fsSL -o" in self.calls.read_text() and "gapcheck_0.1.0_amd64.deb" in self.calls.read_text()
        assert "::warning file=models/plates.inc,line=" in runner.said, runner.said
        assert "| GC101 initial-penetration | warning | 1 | 18 |" in runner.summary.read_text(), runner.summary.read_text()
        (log,) = runner.uploads
        (run,) = log["runs"]
        assert len(run["results"]) == self.findings(repository) > 18

        runner = GitHub(self.repository(clean="clean"))
        assert runner.workflow(CI / "github.yml", **{"fail-on": "warning"}) == 0, runner.said
        assert len(runner.uploads) == 1, "findings that are gone have to disappear there, too"

        broken = self.repository(clean="clean")
        broken.write("models/broken.k", main_deck("lost.inc"))
        runner = GitHub(broken)
        outputs, code = runner.action({"decks": "models/*.k\n", "fail-on": "never"})
        assert (code, outputs["exit-code"]) == (2, "2") and "lost.inc" in runner.said, runner.said
        outputs, code = GitHub(self.repository()).action({"decks": "models/*.k"})
        assert (code, outputs) == (2, {"exit-code": "2", "sarif": ""}), "no deck is an error"

    def check_changed_since(self):
        """A pull request that changes one include: only its deck is audited."""
        repository = self.repository(plates="two_plates", deep="deep_node_released")
        repository.git("checkout", "-q", "-b", "change")
        repository.commit(**{"models/plates.inc": "$ new\n" + body("two_plates")})
        options = {"decks": "models/*.k", "changed-since": "main", "options": "--select\nGC101,GC102\n"}
        outputs, code = GitHub(repository).action(options)
        log = json.loads((repository.folder / outputs["sarif"]).read_text())
        assert code == 0 and len(log["runs"]) == 1, "the errors are in the other deck"
        assert {result["ruleId"] for result in log["runs"][0]["results"]} == {"GC101"}
        repository.commit(**{"models/plates.inc": None})
        runner = GitHub(repository)
        outputs, code = runner.action(options)
        assert code == 2 and "plates.inc" in runner.said, "the deck still includes what was deleted"
        repository.commit(**{"models/plates.k": main_deck("deep.inc")})
        outputs, code = GitHub(repository).action({**options, "fail-on": "never"})
        assert code == 0, "a deck that does not any more"
        assert GitHub(repository_without_changes(repository)).action(options) == ({"exit-code": "0", "sarif": ""}, 0)

    def check_gitlab(self):
        for decks, variables, code in (({"clean": "clean"}, {}, 0), ({"clean": "clean", "plates": "two_plates"}, {}, 1),
                                       ({"plates": "two_plates"}, {"FAIL_ON": "error"}, 0)):
            repository = self.repository(**decks)
            said, ended, artifacts = gitlab(repository, CI / "gitlab.yml", **variables)
            assert ended == code, said
            assert all((repository.folder / name).stat().st_size > 0 for name in artifacts), artifacts
            quality = json.loads((repository.folder / "gl-code-quality-report.json").read_text())
            assert len(quality) == self.findings(repository), said
            self.check_junit(repository.folder / "gapcheck.xml", code)
        self.check_broken(gitlab, "gitlab.yml")

    def check_jenkins(self):
        for decks, code in (({"clean": "clean"}, 0), ({"clean": "clean", "plates": "two_plates"}, 1)):
            repository = self.repository(**decks)
            said, ended, files = jenkins(repository, CI / "Jenkinsfile")
            assert ended == code, said
            assert len(files) == 4 and all((repository.folder / name).stat().st_size > 0 for name in files), files
            log = json.loads((repository.folder / "gapcheck/findings.sarif").read_text())
            assert sum(len(run["results"]) for run in log["runs"]) == self.findings(repository)
            self.check_junit(repository.folder / "gapcheck/findings.xml", code)
        self.check_broken(jenkins, "Jenkinsfile")

    def check_broken(self, run, file):
        """A deck that cannot be read in full fails the job, and there are reports all the same."""
        repository = self.repository(clean="clean")
        repository.write("models/broken.k", main_deck("lost.inc"))
        said, ended, files = run(repository, CI / file, FAIL_ON="never")
        assert ended == 2 and "lost.inc" in said, said
        assert all((repository.folder / name).stat().st_size > 0 for name in files), files

    def check_junit(self, path, code):
        suites = junitparser.JUnitXml.fromstring(path.read_bytes())
        assert (suites.failures > 0) == (code == 1), path.read_text()

    def check_runner(self):
        """The runner notices what it does not know, and a step that fails."""
        runner = GitHub(self.repository(clean="clean"))
        for wrong in ({"decks": "*.k", "deks": "*.k"},):
            try:
                runner.action(wrong)
            except AssertionError as error:
                assert "deks" in str(error)
            else:
                raise AssertionError("an input that the action does not have is not noticed")
        ran = []
        steps = [{"id": "a"}, {"id": "b"}, {"id": "c", "if": "always()"}, {"id": "d", "if": "steps.a.outputs.x != ''"}]
        code = runner.steps(steps, {}, lambda step: ran.append(step["id"]) or ({"x": "1"}, 3))
        assert (code, ran) == (3, ["a", "c"]), ran


def repository_without_changes(repository):
    repository.git("checkout", "-q", "-f", "main")
    return repository


def main():
    gapcheck = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        pipelines = Pipelines(pathlib.Path(folder), gapcheck)
        for check in (pipelines.check_runner, pipelines.check_github, pipelines.check_changed_since, pipelines.check_gitlab,
                      pipelines.check_jenkins):
            check()
            print(f"{check.__name__}: as expected")


if __name__ == "__main__":
    main()
