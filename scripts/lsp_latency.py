#!/usr/bin/env python3
"""Measures how long gapcheck lsp takes with a large include: from opening it, and from each key, to the diagnostics.

    scripts/lsp_latency.py build/release/apps/gapcheck/gapcheck [--megabytes 100] [--keys 50] [--rounds 5]
                           [--most-open S] [--most-key MS]

A deck with an include of shells is written to a temporary folder. The times are those of the client: the message that is
written until the diagnostics of the file have been read. With limits the exit code is 1 if a time is above them.
"""
import argparse
import os
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "apps", "lsp"))
from client import Client, frame, uri_of  # noqa: E402


def mesh(megabytes):
    """A square plate of shells; about 57 + 49 bytes for each node and its element."""
    across = max(4, int((megabytes * 1e6 / 106) ** 0.5))
    rows = range(across + 1)
    lines = ["*NODE"]
    lines += [f"{i * (across + 1) + j + 1:8d}{0.1 * i:16.4f}{0.1 * j:16.4f}{0:16.4f}" for i in rows for j in rows]
    lines.append("*ELEMENT_SHELL")
    for i in range(across):
        for j in range(across):
            n = i * (across + 1) + j + 1
            lines.append(f"{i * across + j + 1:8d}{1:8d}{n:8d}{n + across + 1:8d}{n + across + 2:8d}{n + 1:8d}")
    return "\n".join(lines) + "\n*END\n"


MAIN = """*KEYWORD
*INCLUDE
mesh.k
*PART
plate
         1         1         1
*SECTION_SHELL
         1         2
       0.1       0.1       0.1       0.1
*MAT_ELASTIC
         1   7.8E-6     210.0       0.3
*CONTACT_AUTOMATIC_SINGLE_SURFACE
         1         0         3
       0.1

*END
"""


def published(client, uri, version, sent, timeout=120):
    """Seconds until the diagnostics of this version of the file came, and what they are."""
    while True:
        came, message = client.receive(timeout)
        assert message is not None, client.error_text.decode()
        params = message.get("params", {})
        if message.get("method") == "textDocument/publishDiagnostics" and (params["uri"], params.get("version")) == (
                uri, version):
            return came - sent, message["params"]["diagnostics"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck")
    parser.add_argument("--megabytes", type=float, default=100)
    parser.add_argument("--keys", type=int, default=50)
    parser.add_argument("--rounds", type=int, default=5, help="how often the file is opened")
    parser.add_argument("--most-open", type=float, help="seconds")
    parser.add_argument("--most-key", type=float, help="milliseconds")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        text = mesh(options.megabytes)
        with open(os.path.join(folder, "mesh.k"), "w") as file:
            file.write(text)
        with open(os.path.join(folder, "main.k"), "w") as file:
            file.write(MAIN)
        client = Client(os.path.abspath(options.gapcheck), folder)
        client.start()
        uri = uri_of(os.path.join(folder, "mesh.k"))
        opened = []
        for version in range(1, options.rounds + 1):
            opening = frame({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument": {
                "uri": uri, "languageId": "lsdyna", "version": version, "text": text}}})
            sent = time.perf_counter()
            client.send_bytes(opening)
            seconds, found = published(client, uri, version, sent)
            assert not [each for each in found if each["severity"] == 1], found[:3]
            opened.append(seconds)
            # The next one is not to wait for the audit of this one.
            said = client.audited(600)
            if version < options.rounds:
                client.notify("textDocument/didClose", {"textDocument": {"uri": uri}})
        opened.sort()
        lines = text.count("\n")
        # A letter into a number and out again: an error, and none. Near the start, in the middle, near the end; the
        # last third makes and joins lines, which moves all that follow.
        keys, version = [], options.rounds
        for k in range(options.keys):
            line = 2 + (lines - 8) * (k // 2 % 10) // 9
            new_line = k >= options.keys * 2 // 3
            typed = "\n" if new_line else "x"
            for text_in, end in ((typed, (line, 5)), ("", (line + 1, 0) if new_line else (line, 6))):
                version += 1
                change = frame({"jsonrpc": "2.0", "method": "textDocument/didChange", "params": {
                    "textDocument": {"uri": uri, "version": version}, "contentChanges": [
                        {"range": {"start": {"line": line, "character": 5},
                                   "end": {"line": end[0], "character": end[1]}}, "text": text_in}]}})
                sent = time.perf_counter()
                client.send_bytes(change)
                seconds, found = published(client, uri, version, sent)
                keys.append(1000 * seconds)
                wrong = [each for each in found if "is not a" in each["message"]]
                assert bool(wrong) == (text_in == "x"), (text_in, line, found[:3])
        keys.sort()
        print(said.replace(folder + "/", ""))
        print(f"opening {len(text) / 1e6:.0f} MB, {lines} lines: median {opened[len(opened) // 2]:.2f} s, largest "
              f"{opened[-1]:.2f} s of {len(opened)}")
        print(f"per key, {len(keys)} keys: median {keys[len(keys) // 2]:.1f} ms, largest {keys[-1]:.1f} ms")
        position = {"textDocument": {"uri": uri}, "position": {"line": lines // 2, "character": 3}}
        for method in ("hover", "definition", "documentSymbol", "foldingRange"):
            sent = time.perf_counter()
            client.request("textDocument/" + method, position)
            print(f"{method}: {1000 * (time.perf_counter() - sent):.1f} ms")
        assert client.stop() == 0
        slow = (options.most_open is not None and opened[-1] > options.most_open) or (
            options.most_key is not None and keys[-1] > options.most_key)
        return 1 if slow else 0


if __name__ == "__main__":
    sys.exit(main())
