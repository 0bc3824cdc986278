#!/usr/bin/env python3
"""Tests the VS Code extension of apps/vscode as far as a run without VS Code goes, and packs it.

    scripts/vscode_extension.py build/release/apps/gapcheck/gapcheck [--output FOLDER]

Node and npm are needed, and the npm registry: for vscode-languageclient, which the package holds, and for vsce and the library
that reads grammars. Nothing is installed outside a temporary folder. The package can be installed with
`code --install-extension gapcheck-0.1.0.vsix`.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TESTS = os.path.join(ROOT, "tests", "apps", "lsp")
sys.path.insert(0, TESTS)
import deck  # noqa: E402


def npm(folder, *packages):
    subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--silent", *packages], check=True, cwd=folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck")
    parser.add_argument("--output", default=".", help="folder for the package")
    options = parser.parse_args()
    output = os.path.abspath(options.output)
    with tempfile.TemporaryDirectory() as folder:
        extension, tools, decks = (os.path.join(folder, name) for name in ("gapcheck", "tools", "decks"))
        shutil.copytree(os.path.join(ROOT, "apps", "vscode"), extension)
        shutil.copy(os.path.join(ROOT, "LICENSE"), extension)
        os.mkdir(tools)
        os.mkdir(decks)
        deck.write(decks)
        npm(extension)
        npm(tools, "@vscode/vsce", "vscode-textmate", "vscode-oniguruma")
        subprocess.run(["node", os.path.join(TESTS, "vscode_extension.js"), os.path.abspath(options.gapcheck), extension,
                        decks, tools], check=True)
        subprocess.run([os.path.join(tools, "node_modules", ".bin", "vsce"), "package", "--allow-missing-repository",
                        "--out", output], check=True, cwd=extension)


if __name__ == "__main__":
    main()
