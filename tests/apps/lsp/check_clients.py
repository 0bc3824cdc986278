#!/usr/bin/env python3
"""Lets clients that others wrote speak with gapcheck lsp.

    check_clients.py GAPCHECK neovim            Neovim, as Debian has it
    check_clients.py GAPCHECK npm [--install]   vscode-languageserver-protocol, where Node finds it; --install: from the
                                                npm registry into a temporary folder

Without the client: exit code 77, and the reason.
"""
import os
import shutil
import subprocess
import sys
import tempfile

import deck

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = "vscode-languageserver-protocol"


def skip(reason):
    print("skipped: " + reason)
    sys.exit(77)


def neovim(gapcheck, folder):
    if shutil.which("nvim") is None:
        skip("nvim is not installed (Debian: neovim)")
    environment = {**os.environ, "GAPCHECK": gapcheck, "FOLDER": folder, "LC_ALL": "C.UTF-8",
                   "XDG_STATE_HOME": folder + "/.state", "XDG_CACHE_HOME": folder + "/.cache"}
    subprocess.run(["nvim", "--headless", "-u", "NONE", "-n", "-c", "luafile " + HERE + "/neovim.lua"], check=True,
                   env=environment, cwd=folder, timeout=120, stdin=subprocess.DEVNULL)
    # The lines for init.lua in docs/lsp.md start the server for a deck, and it marks what is wrong.
    with open(os.path.join(HERE, "../../../docs/lsp.md"), encoding="utf-8") as page:
        settings = page.read().split("```lua\n")[1].split("```")[0]
    with open(folder + "/init.lua", "w") as file:
        file.write(settings)
    environment["PATH"] = os.path.dirname(gapcheck) + ":" + environment["PATH"]
    marked = "vim.wait(20000, function() return #vim.diagnostic.get(0) > 0 end)"
    subprocess.run(["nvim", "--headless", "-u", "init.lua", "-n", "mesh türen.k", "-c",
                    f"lua vim.cmd({marked} and 'qall!' or 'cquit 1')"], check=True, env=environment, cwd=folder,
                   timeout=120, stdin=subprocess.DEVNULL)
    print("Neovim: as expected")


def npm(gapcheck, folder, install):
    if shutil.which("node") is None:
        skip("node is not installed")
    environment = dict(os.environ)
    if install:
        modules = tempfile.mkdtemp()
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", modules, PACKAGE], check=True)
        environment["NODE_PATH"] = modules + "/node_modules"
    try:
        if subprocess.run(["node", "-e", f"require('{PACKAGE}/node')"], env=environment, cwd=folder,
                          stderr=subprocess.DEVNULL).returncode != 0:
            skip(f"Node does not find {PACKAGE}; call tests/apps/lsp/check_clients.py GAPCHECK npm --install")
        subprocess.run(["node", HERE + "/npm_client.js", gapcheck, folder], check=True, env=environment, timeout=120)
    finally:
        if install:
            shutil.rmtree(modules)


def main():
    gapcheck, client = os.path.abspath(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:
        deck.write(folder)
        if client == "neovim":
            neovim(gapcheck, folder)
        else:
            npm(gapcheck, folder, "--install" in sys.argv[3:])


if __name__ == "__main__":
    main()
