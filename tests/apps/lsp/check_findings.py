#!/usr/bin/env python3
"""Findings in an editor, as gapcheck lsp has them: the repairs that are offered with them, and those of a baseline.

    check_findings.py GAPCHECK PROJECT
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile

from client import Client, uri_of
from deck import MAIN, mesh, write as write_deck

GAPCHECK, PROJECT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])


def applied(text, edits):
    """A text after edits of whole lines; an end behind the line's is its end."""
    lines = text.split("\n")
    for edit in edits:
        start, end = edit["range"]["start"], edit["range"]["end"]
        line = lines[start["line"]]
        body = line.rstrip("\r")
        assert start["character"] == 0 and end["line"] == start["line"] and end["character"] >= len(body), edit
        lines[start["line"]] = edit["newText"] + line[len(body):]
    return "\n".join(lines)


def check_repairs(folder):
    """Repairs of cards are offered with the findings, and each is what gapcheck fix --apply writes, byte for byte: in a
    file that is open and in one that is not, with either line end."""
    write_deck(folder)
    texts = {"main deck.k": MAIN.replace("\n", "\r\n"), "mesh türen.k": mesh()}
    with open(os.path.join(folder, "main deck.k"), "w", encoding="utf-8", newline="") as file:
        file.write(texts["main deck.k"])
    run = subprocess.run([GAPCHECK, "fix", "main deck.k", "--plan", "--format", "json"], cwd=folder,
                         capture_output=True, text=True)
    (pair,) = json.loads(run.stdout)["pairs"]
    plan = [repair for repair in pair["repairs"] if repair.get("lines")]
    client = Client(GAPCHECK, folder)
    client.start()
    client.open("mesh türen.k")
    client.audited()

    def offered(expected_log=None):
        """The repairs for the first penetration of the open file, by title."""
        if expected_log:
            client.wait(lambda m: m.get("method") == "window/logMessage" and expected_log in m["params"]["message"])
        (first, *_) = [each for each in client.found("mesh türen.k") if each.get("code") == "GC101"]
        actions = client.request("textDocument/codeAction", {
            "textDocument": client.document("mesh türen.k"), "range": first["range"],
            "context": {"diagnostics": [first]}})
        return {each["title"]: each["edit"]["changes"] for each in actions
                if "edit" in each and not each["title"].startswith("Ignore this")}

    actions = offered("repairs of cards")
    assert len(actions) == len(plan) >= 5, (list(actions), [repair["text"] for repair in plan])
    with open(os.path.join(PROJECT, "docs", "lsp.md"), encoding="utf-8") as page:
        shown = page.read().split("<!-- repairs: begin -->\n")[1].split("<!-- repairs: end -->")[0]
    listed = "".join(f"    {title}\n" for title in actions)
    assert shown == listed, listed
    for repair in plan:
        (changes,) = [edits for title, edits in actions.items() if title.startswith(repair["text"] + ": ")]
        out = os.path.join(folder, "out " + repair["id"])
        subprocess.run([GAPCHECK, "fix", "main deck.k", "--apply", repair["id"], "-o", out, "--quiet"], cwd=folder,
                       check=False, capture_output=True)
        written = sorted(os.listdir(out))
        assert sorted(changes) == sorted(uri_of(client.path(name)) for name in written), (repair["id"], changes)
        for name in written:
            with open(os.path.join(out, name), encoding="utf-8", newline="") as file:
                after = applied(texts[name], changes[uri_of(client.path(name))])
                assert after == file.read() != texts[name], repair["id"]
    files = {tuple(sorted(changes)) for changes in actions.values()}
    assert len(files) == 2, files  # *PART_CONTACT is in the open file, all else in the other one
    # In a file that is changed nothing is offered, whoever has changed it; with the next save it is audited anew.
    client.open("main deck.k")
    client.audited()
    assert len(offered("repairs of cards")) == len(plan)
    client.change("main deck.k", 2, (12, 0, 12, 0, " "))
    assert [title.split(" ")[0] for title in offered()] == ["OPTT"], list(offered())
    client.change("mesh türen.k", 2, (0, 0, 0, 0, "$ newer\n"))
    client.diagnostics("mesh türen.k", 2)
    assert offered() == {}
    client.notify("textDocument/didClose", {"textDocument": client.document("main deck.k")})
    with open(client.path("mesh türen.k"), "w", encoding="utf-8") as file:
        file.write("$ newer\n" + texts["mesh türen.k"])
    client.notify("textDocument/didSave", {"textDocument": client.document("mesh türen.k")})
    client.audited()
    assert len(offered("repairs of cards")) == len(plan)
    with open(client.path("main deck.k"), "a", encoding="utf-8") as file:
        file.write("$ another program\n")
    assert [title.split(" ")[0] for title in offered()] == ["OPTT"], list(offered())
    assert client.stop() == 0
    assert client.error_text == b"", client.error_text


def check_baseline(folder):
    """What the baseline of the settings has is known, and only a hint; what is worse is as before."""
    subprocess.run([GAPCHECK, "audit", "two_plates.k", "--quiet", "--write-baseline", "known.baseline"], cwd=folder,
                   check=True, capture_output=True)
    with open(os.path.join(folder, "gapcheck.toml"), "w") as file:
        file.write('baseline = "known.baseline"\n')
    client = Client(GAPCHECK, folder)
    client.start()
    client.open("two_plates.k")

    def published():
        client.audited()
        client.request("textDocument/hover", client.at("two_plates.k", 0, 0))
        found = [each for each in client.found("two_plates.k") if each.get("code") == "GC101"]
        assert len(found) == 18, found
        return {(each["severity"], each["message"].startswith("known: node ")) for each in found}

    assert published() == {(4, True)}
    said = [message["params"]["message"] for message in client.said if message["method"] == "window/logMessage"]
    assert any("against the baseline: 0 new, 0 worse, 20 unchanged, 0 gone" in each for each in said), said
    with open(client.path("two_plates.k"), encoding="utf-8") as file:
        deeper = file.read().replace("             0.7\n", "             0.6\n")
    with open(client.path("two_plates.k"), "w", encoding="utf-8") as file:
        file.write(deeper)
    client.notify("textDocument/didSave", {"textDocument": client.document("two_plates.k")})
    assert published() == {(2, False)}
    # Without its file the settings are marked, and the deck is audited as without them.
    os.remove(client.path("known.baseline"))
    client.notify("textDocument/didSave", {"textDocument": client.document("two_plates.k")})
    assert published() == {(2, False)}
    (fault,) = client.found("gapcheck.toml")
    assert fault["severity"] == 1 and "known.baseline cannot be opened" in fault["message"], fault
    with open(client.path("known.baseline"), "w") as file:
        file.write("no baseline\n")
    client.notify("textDocument/didSave", {"textDocument": client.document("two_plates.k")})
    assert published() == {(2, False)}
    (fault,) = client.found("known.baseline")
    assert client.found("gapcheck.toml") == [] and fault["range"]["start"]["line"] == 0, fault
    assert client.stop() == 0
    assert client.error_text == b"", client.error_text


def main():
    for check in (check_repairs, check_baseline):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(os.path.join(PROJECT, "data", "two_plates.k"), folder)
            check(folder)


if __name__ == "__main__":
    main()
