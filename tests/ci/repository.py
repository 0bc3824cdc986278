"""A scratch git repository with decks, as projects keep them, for the tests of docs/ci."""

import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def body(name):
    """An example deck without the frame of a main file: what an include holds."""
    lines = (ROOT / f"data/{name}.k").read_text().splitlines(keepends=True)
    start = lines.index("*CONTROL_TERMINATION\n")
    return "".join(line for line in lines[:start] + lines[start + 2:] if line not in ("*KEYWORD\n", "*END\n"))


def main_deck(*includes):
    return "*KEYWORD\n*CONTROL_TERMINATION\n0.001\n" + "".join(f"*INCLUDE\n{name}\n" for name in includes) + "*END\n"


class Repository:
    """Calls of git and of what git starts, in a folder, with GAPCHECK on the path and no settings of the user."""

    def __init__(self, folder, gapcheck):
        self.folder = folder
        folder.mkdir(parents=True)
        home = folder.parent / f"home of {folder.name}"
        home.mkdir()
        self.environment = {
            "PATH": f"{pathlib.Path(gapcheck).parent}:/usr/bin:/bin", "HOME": str(home), "LANG": "C.UTF-8",
            "PRE_COMMIT_HOME": str(home / "pre-commit"), "GIT_CONFIG_NOSYSTEM": "1", "TMPDIR": os.environ.get("TMPDIR", "/tmp"),
            **{f"GIT_{who}_{what}": value for who in ("AUTHOR", "COMMITTER")
               for what, value in (("NAME", "tester"), ("EMAIL", "tester@example.com"))}}
        self.git("init", "-q", "-b", "main")

    def call(self, *command, **more):
        """What a command prints, and its exit code."""
        done = subprocess.run(command, cwd=self.folder, env={**self.environment, **more}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False)
        return done.stdout, done.returncode

    def git(self, *arguments):
        said, code = self.call("git", *arguments)
        if code != 0:
            raise AssertionError(f"git {' '.join(arguments)}: {said}")
        return said.strip()

    def write(self, name, text):
        """No text: the file is deleted."""
        path = self.folder / name
        if text is None:
            return path.unlink()
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def commit(self, **files):
        """Stages and commits; what is said and the exit code of git commit. `files`: texts by name."""
        for name, text in files.items():
            self.write(name, text)
        self.git("add", "--all")
        return self.call("git", "commit", "-q", "-m", "change")
