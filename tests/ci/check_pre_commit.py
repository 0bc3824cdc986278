#!/usr/bin/env python3
"""Commits decks in a scratch repository whose hook is the project's: with pre-commit, which clones the hook from a
repository and calls it as on a user's machine, and as a hook of git itself.

usage: check_pre_commit.py GAPCHECK
"""

import pathlib
import shutil
import sys
import tempfile

from repository import ROOT, Repository, body, main_deck

CONFIGURATION = "repos:\n- repo: {}\n  rev: v1\n  hooks:\n  - id: gapcheck\n"


def hook_repository(folder, gapcheck):
    """The files of the project that pre-commit needs, with a tag."""
    hooks = Repository(folder / "hooks", gapcheck)
    for name in (".pre-commit-hooks.yaml", "docs/ci/pre-commit"):
        (hooks.folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, hooks.folder / name)
    hooks.commit()
    hooks.git("tag", "v1")
    return hooks.folder


class Commits:
    """One repository after the other, each with one way to call the hook."""

    def __init__(self, repository, name):
        self.repository, self.name, self.count = repository, name, 0
        _, code = repository.commit(**{"mesh.inc": body("clean"), "front.k": main_deck("mesh.inc"),
                                       "rear.k": main_deck("parts/rear.inc"), "parts/rear.inc": body("clean"),
                                       "notes.md": "first\n"})
        assert code == 0, "two decks without findings"

    def expect(self, what, code, *words, without=(), **files):
        """A commit ends with the code and says these words, and not those; one that was refused is taken back."""
        said, ended = self.repository.commit(**files)
        self.judge(what, code, words, without, said, ended)

    def judge(self, what, code, words, without, said, ended):
        wrong = [word for word in words if word not in said] + [word for word in without if word in said]
        if (ended != 0) != (code != 0) or wrong:
            raise AssertionError(f"{self.name}: {what}: exit {ended}, {wrong or ''} in\n{said}")
        if code:
            self.repository.git("reset", "-q", "--hard")
            self.repository.git("clean", "-q", "-f", "-d")
        self.count += 1

    def run(self):
        bad = body("deep_node_released")
        self.expect("an include stops the decks that it belongs to", 1, "front.k: ", "18 errors", "(exit 1)",
                    without=["rear.k"], **{"mesh.inc": bad})
        self.expect("an include that no deck has", 0, **{"parts/spare.k": bad, "parts/other.inc": bad})
        self.expect("a change that leaves the decks clean", 0, **{"parts/rear.inc": "$ new\n" + body("clean")})
        self.expect("a file that no deck has", 0, **{"notes.md": "second\n", "server.key": "-----BEGIN KEY-----\n"})
        self.expect("a new deck with findings", 1, "side.k: ", without=["front.k"], **{"side.k": main_deck("parts/spare.k")})
        self.expect("a deck whose include is missing", 2, "lost.inc", "(exit 2)", **{"side.k": main_deck("lost.inc")})
        self.expect("a deleted include that a deck still has", 2, "parts/rear.inc", "(exit 2)", without=["front.k"],
                    **{"parts/rear.inc": None})
        self.expect("a renamed include that a deck has by its old name", 2, "parts/rear.inc", "(exit 2)",
                    **{"parts/rear.inc": None, "parts/tail.inc": "$ new\n" + body("clean")})
        self.expect("a deleted include that no deck has any more", 0, **{"parts/other.inc": None})
        self.expect("warnings do not stop", 0, **{"mesh.inc": body("two_plates")})
        self.staged_alone(bad)

    def staged_alone(self, bad):
        """The staged text counts, not that of the folder."""
        repository = self.repository
        repository.write("mesh.inc", bad)
        repository.git("add", "mesh.inc")
        repository.write("mesh.inc", body("clean"))
        said, ended = repository.call("git", "commit", "-q", "-m", "staged")
        self.judge("what is staged has errors, what is in the folder has none", 1, ["18 errors"], [], said, ended)


def with_pre_commit(folder, gapcheck):
    repository = Repository(folder / "decks", gapcheck)
    configuration = CONFIGURATION.format(hook_repository(folder, gapcheck))
    repository.write(".pre-commit-config.yaml", configuration)
    said, code = repository.call("pre-commit", "install")
    assert code == 0, said
    commits = Commits(repository, "pre-commit")
    commits.run()
    repository.write(".pre-commit-config.yaml", configuration + "    args: [--fail-on=warning, --quiet]\n")
    commits.expect("options", 1, "18 warnings", **{"mesh.inc": body("two_plates") + "$ more\n"})
    said, code = repository.call("pre-commit", "run", "--all-files")
    commits.judge("all files", 0, ["Passed"], [], said, code)
    return commits.count


def with_git(folder, gapcheck):
    repository = Repository(folder / "own", gapcheck)
    shutil.copy(ROOT / "docs/ci/pre-commit", repository.folder / ".git/hooks/pre-commit")
    commits = Commits(repository, "git")
    commits.run()
    repository.environment |= {"GAPCHECK_FAIL_ON": "warning", "GAPCHECK_DECKS": "f*.k"}
    commits.expect("other decks and severity", 1, "18 warnings", without=["rear.k"],
                   **{"mesh.inc": body("two_plates") + "$ more\n", "parts/rear.inc": body("two_plates")})
    # Where git fails, there is no verdict.
    outside = folder / "outside"
    outside.mkdir()
    said, code = repository.call("env", "-C", str(outside), "GIT_CEILING_DIRECTORIES=" + str(folder), "GAPCHECK_DECKS=",
                                 str(ROOT / "docs/ci/pre-commit"))
    commits.judge("outside of a repository", 2, [], [], said, code)
    return commits.count


def main():
    gapcheck = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        print(f"pre-commit: {with_pre_commit(root / 'a', gapcheck)} commits as expected")
        print(f"git: {with_git(root / 'b', gapcheck)} commits as expected")


if __name__ == "__main__":
    main()
