"""What the runners of GitHub, GitLab and Jenkins do with the files of docs/ci, as far as these use it: shell steps in their
order, conditions, expressions, outputs, summaries and artifacts. Whatever else a file has is an error. Steps that others
wrote (`uses`) are judged by what they need: a checkout is the repository itself, an upload takes a file that exists."""

import json
import pathlib
import re
import tempfile

import yaml

from repository import ROOT

EXPRESSION = re.compile(r"\$\{\{\s*([\w.-]+)\s*\}\}")


def known(mapping, names, where):
    """Nothing that the runner would leave out."""
    more = set(mapping) - set(names)
    if more:
        raise AssertionError(f"{where}: the runner of the tests does not know {sorted(map(str, more))}")


def read_outputs(path):
    return dict(line.split("=", 1) for line in path.read_text().splitlines()) if path.exists() else {}


class GitHub:
    """Runs a workflow's jobs, and actions/… and your-organisation/gapcheck among the steps. https://docs.github.com/actions"""

    def __init__(self, repository):
        self.repository = repository
        self.temp = pathlib.Path(tempfile.mkdtemp(prefix="runner ", dir=repository.folder.parent))
        self.said, self.uploads, self.count = "", [], 0
        self.summary = self.temp / "summary"

    def value(self, text, context):
        """`text` with its expressions replaced; one that is not known is an error."""
        return EXPRESSION.sub(lambda match: context[match[1]], text)

    def holds(self, condition, context, failed):
        """A condition of a step: NAME != '', always(), and these joined by &&."""
        parts = [part.strip() for part in condition.split("&&")]
        always = "always()" in parts
        for part in parts:
            if part == "always()":
                continue
            name, sign, empty = part.partition(" != ")
            assert sign and empty == "''", f"the runner of the tests does not know the condition {part}"
            if not context.get(name, ""):
                return False
        return always or not failed

    def shell(self, step, context, more):
        """One `run` step: `bash -eo pipefail` in the workspace. Its outputs and exit code."""
        assert step["shell"] == "bash"
        self.count += 1
        script, output = self.temp / f"step{self.count}.sh", self.temp / f"output{self.count}"
        script.write_text(step["run"])
        said, code = self.repository.call(
            "bash", "--noprofile", "--norc", "-eo", "pipefail", str(script), GITHUB_OUTPUT=str(output),
            GITHUB_STEP_SUMMARY=str(self.summary), GITHUB_WORKSPACE=str(self.repository.folder), GITHUB_ACTIONS="true",
            RUNNER_TEMP=str(self.temp), GITHUB_ACTION_PATH=str(ROOT), **more,
            **{name: self.value(str(text), context) for name, text in step.get("env", {}).items()})
        self.said += said
        return read_outputs(output), code

    def steps(self, steps, context, run):
        """Steps in order; the exit code of the first that failed. `run(step)` gives outputs and exit code of one."""
        failed = 0
        for step in steps:
            if not self.holds(step.get("if", ""), context, failed) if "if" in step else failed:
                continue
            outputs, code = run(step)
            failed = failed or code
            for name, text in outputs.items():
                context[f"steps.{step.get('id', '')}.outputs.{name}"] = text
        return failed

    def action(self, given):
        """The action of the project with these inputs: its outputs and exit code."""
        action = yaml.safe_load((ROOT / "action.yml").read_text())
        known(action, ["name", "description", "inputs", "outputs", "runs"], "action.yml")
        known(given, action["inputs"], "with")
        assert action["runs"]["using"] == "composite"
        context = {f"inputs.{name}": str(given.get(name, one["default"])) for name, one in action["inputs"].items()}

        def run(step):
            known(step, ["name", "id", "if", "shell", "env", "run"], "action.yml")
            return self.shell(step, context, {})

        code = self.steps(action["runs"]["steps"], context, run)
        missing = {f"steps.audit.outputs.{name}": "" for name in action["outputs"]} | context
        return {name: self.value(one["value"], missing) for name, one in action["outputs"].items()}, code

    def workflow(self, path, **inputs):
        """The only job of a workflow; `inputs` replace what it gives to the action. The exit code."""
        workflow = yaml.safe_load(path.read_text())
        known(workflow, ["name", True, "jobs"], path.name)  # YAML reads `on` as true
        (job,) = workflow["jobs"].values()
        known(job, ["runs-on", "container", "permissions", "steps"], path.name)
        context = {}

        def run(step):
            known(step, ["name", "id", "if", "uses", "with"], path.name)
            given = {name: self.value(str(text), context) for name, text in step.get("with", {}).items()}
            uses = step["uses"].partition("@")[0]
            if uses == "your-organisation/gapcheck":
                return self.action(given | inputs)
            if uses == "github/codeql-action/upload-sarif":
                self.uploads.append(json.loads((self.repository.folder / given["sarif_file"]).read_text()))
            else:
                assert uses == "actions/checkout", uses
            return {}, 0

        return self.steps(job["steps"], context, run)


def without_installing(repository):
    """Replaces apt-get and curl, which would change the machine, and records their arguments."""
    folder = repository.folder.parent / f"commands of {repository.folder.name}"
    folder.mkdir()
    for name in ("apt-get", "curl"):
        (folder / name).write_text(f'#!/bin/sh\necho "{name} $*" >>"{folder}/calls"\n')
        (folder / name).chmod(0o755)
    repository.environment["PATH"] = f"{folder}:{repository.environment['PATH']}"
    return folder / "calls"


def gitlab(repository, path, **variables):
    """The job of a GitLab file, with other variables: said, exit code, artifacts. https://docs.gitlab.com/ci/yaml"""
    ((_, job),) = yaml.safe_load(path.read_text()).items()
    known(job, ["image", "variables", "before_script", "script", "artifacts"], path.name)
    script = "\n".join(["set -eo pipefail", *job["before_script"], *job["script"]])
    said, code = repository.call("bash", "-c", script, CI="true", CI_PROJECT_DIR=str(repository.folder),
                                 **(job["variables"] | variables))
    artifacts = job["artifacts"]
    known(artifacts, ["when", "paths", "reports"], path.name)
    assert artifacts["when"] == "always"
    return said, code, [*artifacts["paths"], *artifacts["reports"].values()]


def jenkins(repository, path, **variables):
    """The shell steps of a Jenkinsfile, each by `sh -xe`: said, exit code, files that the steps after them take."""
    text = path.read_text()
    steps, environment = re.findall(r"\bsh '''(.*?)'''", text, re.S), dict(re.findall(r"^ +(\w+) = '([^']*)'$", text, re.M))
    assert len(steps) == text.count("sh '") and text.count("{") == text.count("}"), path
    # In ''' … ''' Groovy joins lines at a backslash as the shell does, and knows no $.
    said, code = "", 0
    for step in steps:
        if code == 0:
            more, code = repository.call("sh", "-xe", "-c", step, WORKSPACE=str(repository.folder), JENKINS_URL="http://localhost",
                                         **(environment | variables))
            said += more
    after = text[text.index("post {"):]
    return said, code, [name for quoted in re.findall(r"'([^']*)'", after) for name in quoted.split(", ")]
