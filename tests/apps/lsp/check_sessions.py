#!/usr/bin/env python3
"""Sessions of an editor at random: texts of several files of a deck are opened, changed, saved and closed, files are
deleted and written by others, includes come and go, and requests fall in between. The server has to answer each, to have the
texts that the editor has, to come to rest, and to end in the orderly way without a word on standard error.

    check_sessions.py GAPCHECK [--seed FIRST] [--count SESSIONS]
"""
import argparse
import json
import os
import random
import tempfile
import time

import deck
from client import Client

NAMES = ["main deck.k", "mesh türen.k", "other.k", "new.k", "sub/inc.k"]
TYPED = ["ä", "😀", "x", "*PART\n", "\n", "\r\n", "1,2", "&t", "*INCLUDE\nmesh türen.k\n", "*INCLUDE\nother.k\n",
         "*INCLUDE\nsub/inc.k\n", "*INCLUDE_TRANSFORM\nother.k\n1,2,3\n\n\n\n", "*END\n", "$ c\n",
         "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n", "*PARAMETER\nR t 2.\n", "*SET_PART_LIST\n1\n1,2\n", "*CONTACT",
         "\ud800", "\udc00x"]
WRITTEN = ["*NODE\n1,0,0,0\n", "*INCLUDE\nmain deck.k\n", "*PART\na\n1,1,1\n", ""]
SETTINGS = ['ignore = ["GC1"]\n', "broken", "unknown = 1\n"]
REQUESTS = ["hover", "completion", "definition", "references", "prepareRename", "rename", "documentSymbol",
            "foldingRange", "rangeFormatting", "codeAction"]


def units(text):
    return len(text.encode("utf-16-le", "surrogatepass")) // 2


class Session:
    def __init__(self, gapcheck, folder, seed):
        self.random, self.folder = random.Random(seed), folder
        deck.write(folder)
        os.mkdir(os.path.join(folder, "sub"))
        for name in ("other.k", "sub/inc.k"):
            self.write(name, self.random.choice(WRITTEN))
        self.client = Client(gapcheck, folder)
        self.client.start()
        self.texts, self.version = {}, 0

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8", errors="replace", newline="") as file:
            file.write(text)

    def delete(self, name):
        if os.path.isfile(self.client.path(name)):
            os.remove(self.client.path(name))

    def notify(self, method, name, text=None, **more):
        """Halves of characters are escapes in JSON."""
        self.version += 1
        document = {**self.client.document(name), "version": self.version} | ({} if text is None else {"text": text})
        body = {"method": "textDocument/" + method, "params": {"textDocument": document, **more}}
        self.client.send(json.dumps(body).encode())

    def place(self, text, index):
        """A position of the protocol, and its index; inside a CR LF the end of the line."""
        start = text.rfind("\n", 0, index) + 1
        line = (text[start:] + "\n").split("\n", 1)[0].rstrip("\r")
        index = min(index, start + len(line))
        return index, {"line": text.count("\n", 0, index), "character": units(text[start:index])}

    def change(self, name):
        text, changes = self.texts[name], []
        for _ in range(self.random.randint(1, 3)):
            begin = self.random.randint(0, len(text))
            end = min(len(text), begin + self.random.choice([0, 0, 0, 3, 40]))
            (begin, start), (end, stop) = self.place(text, begin), self.place(text, end)
            typed = "".join(self.random.choices(TYPED, k=self.random.randint(0, 2)))
            text = text[:begin] + typed + text[end:]
            changes.append({"range": {"start": start, "end": stop}, "text": typed})
        self.texts[name] = text
        self.notify("didChange", name, contentChanges=changes)

    def ask(self, name):
        line = self.random.randint(0, self.texts[name].count("\n"))
        method = self.random.choice(REQUESTS)
        wanted = {"start": {"line": max(0, line - 3), "character": 0}, "end": {"line": line, "character": 5}}
        answer = self.client.ask("textDocument/" + method, self.client.at(
            name, line, self.random.randint(0, 30), newName=self.random.choice(["5", "77", "t2"]), range=wanted))
        assert "result" in answer or answer["error"]["code"] in (-32803, -32602), answer
        for action in answer.get("result") or [] if method == "codeAction" else []:
            if "command" in action:
                self.client.ask("workspace/executeCommand", action["command"])

    def step(self):
        name, what = self.random.choice(NAMES), self.random.random()
        if what < 0.05:
            self.delete(name)
        elif what < 0.1:
            self.write(name, "".join(self.random.choices(TYPED, k=5)))
        elif what < 0.15:
            self.write("gapcheck.toml", self.random.choice(SETTINGS))
            self.client.notify("workspace/didChangeWatchedFiles", {"changes": []})
        elif name not in self.texts:
            text = self.random.choice(WRITTEN)
            if os.path.isfile(self.client.path(name)) and what < 0.8:
                with open(self.client.path(name), encoding="utf-8", newline="") as file:
                    text = file.read()
            self.texts[name] = text
            self.notify("didOpen", name, text)
        elif what < 0.5:
            self.change(name)
        elif what < 0.65:
            self.write(name, self.texts[name])
            self.notify("didSave", name)
        elif what < 0.7:
            self.notify("didClose", name)
            del self.texts[name]
        else:
            self.ask(name)

    def check_texts(self):
        """A text that is opened as it is now has the same keywords at the same places."""
        for name, text in self.texts.items():
            outlines = []
            for each in (name, "fresh.k"):
                if each != name:
                    self.notify("didOpen", each, text)
                document = {"textDocument": self.client.document(each)}
                symbols = self.client.request("textDocument/documentSymbol", document)
                outlines.append(([(symbol["name"], symbol["range"]) for symbol in symbols],
                                 self.client.request("textDocument/foldingRange", document)))
            self.notify("didClose", "fresh.k")
            assert outlines[0] == outlines[1], (name, text, outlines)

    def come_to_rest(self):
        """No deck is waited for without end."""
        deadline = time.monotonic() + 60
        for name in self.texts:
            rename = self.client.at(name, 0, 0, newName="5")
            while "still being read" in str(self.client.ask("textDocument/rename", rename)):
                assert time.monotonic() < deadline, name
                time.sleep(0.02)

    def run(self, steps=120):
        for _ in range(steps):
            self.step()
        self.check_texts()
        self.come_to_rest()
        assert self.client.stop() == 0, self.client.error_text
        assert self.client.error_text == b"", self.client.error_text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gapcheck")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=15)
    options = parser.parse_args()
    for seed in range(options.seed, options.seed + options.count):
        with tempfile.TemporaryDirectory() as folder:
            try:
                Session(os.path.abspath(options.gapcheck), folder, seed).run()
            except BaseException:
                print(f"session {seed}")
                raise
    print(f"{options.count} sessions")


if __name__ == "__main__":
    main()
