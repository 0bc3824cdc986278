#!/usr/bin/env python3
"""Speaks with gapcheck lsp as an editor does, and as no editor should.

    check_lsp.py GAPCHECK PROJECT
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

from client import Client, frame, uri_of
from deck import MAIN, mesh, write as write_deck

GAPCHECK, PROJECT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])


def codes(diagnostics):
    return sorted({each.get("code", "") for each in diagnostics})


def check_editing(folder):
    """The include alone is opened: the deck that it belongs to is found and audited."""
    write_deck(folder)
    client = Client(GAPCHECK, folder)
    capabilities = client.start()["capabilities"]
    assert capabilities["positionEncoding"] == "utf-16", capabilities
    client.open("mesh türen.k")
    assert client.diagnostics("mesh türen.k") == []
    said = client.audited()
    assert "main deck.k: 0 errors" in said, said
    client.request("textDocument/hover", client.at("mesh türen.k", 0, 0))  # what was published before it is in `said`
    found = client.found("mesh türen.k")
    assert "GC101" in codes(found), found
    first = [each for each in found if each.get("code") == "GC101"][0]
    assert first["source"] == "gapcheck" and first["severity"] == 2, first
    assert "node" in first["message"], first
    # The values of parameters come from the main file.
    client.open("main deck.k")
    value = client.request("textDocument/hover", client.at("main deck.k", 7, 9))["contents"]["value"]
    assert "`&t` = 1\n" in value, value
    # Typing: a letter in a number is an error in that field at once, and none when it is gone.
    lines = mesh().split("\n")
    line = lines.index("*NODE") + 1
    client.change("mesh türen.k", 2, (line, 22, line, 23, "x"))
    wrong = [each for each in client.diagnostics("mesh türen.k", 2) if each["severity"] == 1]
    assert len(wrong) == 1 and wrong[0]["range"]["start"]["line"] == line, wrong
    assert wrong[0]["range"]["end"]["character"] == 24 and "field x" in wrong[0]["message"], wrong
    client.change("mesh türen.k", 3, (line, 22, line, 23, lines[line][22]))
    assert not [each for each in client.diagnostics("mesh türen.k", 3) if each["severity"] == 1]
    # A parameter that is not yet saved counts.
    client.change("main deck.k", 2, (2, 15, 2, 18, "0.5"))
    deadline = time.monotonic() + 20
    while "`&t` = 0.5" not in client.request("textDocument/hover", client.at("main deck.k", 7, 9))["contents"]["value"]:
        assert time.monotonic() < deadline, "the new value is not seen"
        time.sleep(0.05)
    # Saved with thinner plates nothing penetrates any more.
    with open(client.path("main deck.k"), "w", encoding="utf-8") as file:
        file.write(MAIN.replace("1.0\n*INCLUDE", "0.5\n*INCLUDE"))
    client.notify("textDocument/didSave", {"textDocument": client.document("main deck.k")})
    client.audited()
    # That may have been an audit from before the change was saved; each request also takes what was published meanwhile.
    deadline = time.monotonic() + 20
    while "GC101" in codes(client.found("mesh türen.k")):
        assert time.monotonic() < deadline, client.found("mesh türen.k")
        client.request("textDocument/foldingRange", {"textDocument": client.document("main deck.k")})
        time.sleep(0.05)
    check_references(client)
    check_actions(client)
    assert client.stop() == 0
    assert client.error_text == b"", client.error_text


def check_references(client):
    part = client.at("mesh türen.k", 2, 9)
    assert client.request("textDocument/definition", client.at("main deck.k", 4, 3))["uri"] == uri_of(
        client.path("mesh türen.k"))
    section = client.request("textDocument/definition", client.at("mesh türen.k", 2, 19))
    assert section["uri"] == uri_of(client.path("main deck.k")) and section["range"]["start"]["line"] == 6, section
    both = client.request("textDocument/references",
                          client.at("main deck.k", 6, 9, context={"includeDeclaration": True}))
    assert len(both) == 3, both
    edits = client.request("textDocument/rename", {**part, "newName": "11"})["changes"]
    assert len(edits[uri_of(client.path("mesh türen.k"))]) == 5, edits  # the part and its four elements
    symbols = client.request("textDocument/documentSymbol", {"textDocument": client.document("mesh türen.k")})
    assert [each["name"] for each in symbols] == ["*PART", "*NODE", "*ELEMENT_SHELL"], symbols
    items = client.request("textDocument/completion", client.at("main deck.k", 8, 5))["items"]
    assert any(each["label"] == "*MAT_ELASTIC" for each in items), len(items)


def check_actions(client):
    """gapcheck fix moves the nodes of a deck that penetrates again."""
    with open(client.path("main deck.k"), "w", encoding="utf-8") as file:
        file.write(MAIN)
    client.notify("textDocument/didClose", {"textDocument": client.document("main deck.k")})
    client.open("main deck.k")
    client.audited()
    client.notify("textDocument/didSave", {"textDocument": client.document("mesh türen.k")})
    client.audited()
    client.request("textDocument/foldingRange", {"textDocument": client.document("main deck.k")})
    found = [each for each in client.found("mesh türen.k") if each.get("code") == "GC101"]
    actions = client.request("textDocument/codeAction", {
        "textDocument": client.document("mesh türen.k"), "range": found[0]["range"], "context": {"diagnostics": found}})
    ignores = [each for each in actions if each["title"] == "Ignore this GC101 with a comment"]
    assert ignores, actions
    text = ignores[0]["edit"]["changes"][uri_of(client.path("mesh türen.k"))][0]["newText"]
    assert text.startswith("$ gapcheck: ignore GC101 contact=1 "), text
    command = [each["command"] for each in actions if "command" in each][0]
    client.request("workspace/executeCommand", {"command": command["command"], "arguments": command["arguments"]})
    edit = client.wait(lambda m: m.get("method") == "workspace/applyEdit", 60)
    lines = edit["params"]["edit"]["changes"][uri_of(client.path("mesh türen.k"))]
    assert len(lines) > 3 and all(each["range"]["start"]["character"] == 0 for each in lines), lines
    client.send({"jsonrpc": "2.0", "id": edit["id"], "result": {"applied": True}})


def check_utf8(folder):
    client = Client(GAPCHECK, folder, encodings=["utf-8", "utf-16"])
    assert client.start()["capabilities"]["positionEncoding"] == "utf-8"
    client.open("new.k", "*PART\nTür 😀\n         1\n")
    client.diagnostics("new.k")
    client.change("new.k", 2, (1, 5, 1, 9, "x"))  # 😀 in bytes
    client.diagnostics("new.k", 2)
    symbols = client.request("textDocument/documentSymbol", {"textDocument": client.document("new.k")})
    assert symbols[0]["children"][0]["detail"] == "Tür x", symbols
    assert client.stop() == 0
    client = Client(GAPCHECK, folder)
    client.start()
    client.open("new.k", "*PART\nTür 😀z\n         1\n")
    client.change("new.k", 2, (1, 4, 1, 6, "x"))  # 😀 in two units
    symbols = client.request("textDocument/documentSymbol", {"textDocument": client.document("new.k")})
    assert symbols[0]["children"][0]["detail"] == "Tür xz", symbols
    assert client.stop() == 0


def check_lifecycle(folder):
    client = Client(GAPCHECK, folder)
    assert client.ask("textDocument/hover")["error"]["code"] == -32002
    client.start()
    assert client.ask("initialize")["error"]["code"] == -32600
    assert client.ask("no/such")["error"]["code"] == -32601
    client.notify("$/no/such")
    client.notify("no/such")
    # A request that is cancelled while it waits, here for a large text, has no result.
    opened = {"uri": uri_of(client.path("large.k")), "version": 1, "text": "*NODE\n" + "       1\n" * 2_000_000}
    client.send_bytes(frame({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument": opened}}) +
                      frame({"jsonrpc": "2.0", "id": "later", "method": "textDocument/hover", "params": {}}) +
                      frame({"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": "later"}}))
    assert client.wait(lambda m: m.get("id") == "later")["error"]["code"] == -32800
    client.request("shutdown")
    assert client.ask("textDocument/hover")["error"]["code"] == -32600
    client.notify("exit")
    assert client.process.wait(20) == 0
    # Without shutdown, and when the editor is gone: 1.
    client = Client(GAPCHECK, folder)
    client.start()
    client.notify("exit")
    assert client.process.wait(20) == 1
    client = Client(GAPCHECK, folder)
    client.process.stdin.close()
    assert client.process.wait(20) == 1


def check_settings(folder):
    """A deck's settings file holds as for gapcheck audit."""
    shutil.copy(os.path.join(PROJECT, "data", "two_plates.k"), folder)
    client = Client(GAPCHECK, folder)
    client.start()
    client.open("two_plates.k")
    client.audited()
    client.request("textDocument/hover", client.at("two_plates.k", 0, 0))
    assert "GC101" in codes(client.found("two_plates.k"))
    with open(client.path("gapcheck.toml"), "w") as file:
        file.write('ignore = ["GC1"]\n')
    client.notify("textDocument/didSave", {"textDocument": client.document("two_plates.k")})
    client.audited()
    client.request("textDocument/hover", client.at("two_plates.k", 0, 0))
    assert "GC101" not in codes(client.found("two_plates.k"))
    # A broken one is marked itself, and the deck is audited without it.
    with open(client.path("gapcheck.toml"), "w") as file:
        file.write('ignore = ["GC1"]\n\nignored = 1\n')
    client.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": uri_of(client.path("gapcheck.toml")), "type": 2}]})
    client.audited()
    client.request("textDocument/hover", client.at("two_plates.k", 0, 0))
    (fault,) = client.found("gapcheck.toml")
    assert fault["range"]["start"]["line"] == 2 and fault["message"].startswith('unknown key "ignored"'), fault
    assert "GC101" in codes(client.found("two_plates.k"))
    os.remove(client.path("gapcheck.toml"))
    client.notify("textDocument/didSave", {"textDocument": client.document("two_plates.k")})
    client.audited()
    client.request("textDocument/hover", client.at("two_plates.k", 0, 0))
    assert client.found("gapcheck.toml") == []
    assert client.stop() == 0
    assert client.error_text == b"", client.error_text


def check_same_as_audit(folder):
    """What is published for a deck on disk is what gapcheck audit lists, rule by rule and line by line."""
    name = "two_plates.k"
    os.path.exists(os.path.join(folder, "gapcheck.toml")) and os.remove(os.path.join(folder, "gapcheck.toml"))
    run = subprocess.run([GAPCHECK, "audit", name, "--format", "json"], cwd=folder, capture_output=True, text=True)
    findings = json.loads(run.stdout)["findings"]
    expected = sorted((each["id"], max(each.get("line", 1), 1) - 1) for each in findings)
    client = Client(GAPCHECK, folder)
    client.start()
    client.open(name)
    client.audited()
    client.request("textDocument/hover", client.at(name, 0, 0))
    published = sorted((each["code"], each["range"]["start"]["line"]) for each in client.found(name) if "code" in each)
    assert published == expected, (published, expected)
    assert client.stop() == 0


def check_deleted(folder):
    """Files that are deleted, emptied or made a folder while they are open: an error in the editor, and no crash."""
    write_deck(folder)
    client = Client(GAPCHECK, folder)
    client.start()
    client.open("mesh türen.k")
    client.open("main deck.k")
    client.audited()
    os.remove(client.path("mesh türen.k"))
    client.notify("textDocument/didSave", {"textDocument": client.document("main deck.k")})
    client.audited()
    client.request("textDocument/hover", client.at("main deck.k", 0, 0))
    assert any("was not found" in each["message"] and each["severity"] == 1 for each in client.found("main deck.k")), (
        client.found("main deck.k"))
    os.remove(client.path("main deck.k"))
    client.notify("textDocument/didSave", {"textDocument": client.document("main deck.k")})
    said = client.audited()
    client.request("textDocument/hover", client.at("main deck.k", 7, 9))
    wrong = [each for each in client.found("main deck.k") if each["severity"] == 1]
    assert wrong and wrong[0]["range"]["start"]["line"] == 0, (said, client.found("main deck.k"))
    for method in ("definition", "references", "rename"):
        client.ask("textDocument/" + method, client.at("mesh türen.k", 2, 19, newName="5"))
    os.mkdir(client.path("main deck.k"))
    client.notify("textDocument/didSave", {"textDocument": client.document("main deck.k")})
    client.audited()
    os.rmdir(client.path("main deck.k"))
    open(client.path("main deck.k"), "w").close()
    client.notify("textDocument/didSave", {"textDocument": client.document("main deck.k")})
    client.audited()
    assert client.stop() == 0


def check_newer_audits(folder):
    """Of many saves one after the other only some are audited, the last one among them."""
    sys.path.insert(0, os.path.join(PROJECT, "scripts"))
    import lsp_latency
    with open(os.path.join(folder, "mesh.k"), "w") as file:
        file.write(lsp_latency.mesh(2))
    with open(os.path.join(folder, "main.k"), "w") as file:
        file.write(lsp_latency.MAIN)
    client = Client(GAPCHECK, folder)
    client.start()
    client.open("main.k")
    client.audited()
    client.said.clear()
    saves = 20
    for save in range(saves):
        if save == saves - 1:
            with open(client.path("main.k"), "w") as file:
                file.write("*INCLUDE\nis not there.k\n" + lsp_latency.MAIN)
        client.notify("textDocument/didSave", {"textDocument": client.document("main.k")})
    deadline = time.monotonic() + 60
    while not any("is not there.k" in each["message"] for each in client.found("main.k") or []):
        assert time.monotonic() < deadline, client.found("main.k")
        client.audited()
        client.request("textDocument/foldingRange", {"textDocument": client.document("main.k")})
    audits = sum("gapcheck audit" in message["params"].get("message", "") for message in client.said)
    assert 1 <= audits < saves, audits
    assert client.stop() == 0


def check_broken_streams(folder):
    """Streams that cannot go on: an error, then the end."""
    for data in (b"Content-Length: 5", b"Content-Length: -5\r\n\r\n{}", b"Content-Length: 99999999999999999999\r\n\r\n{}",
                 b"Content-Length: 500\r\n\r\n{}", b"\r\n\r\nX: 1\r\n\r\n{}", b"{}\n" * 3000, b"\xff\xfe" * 5000,
                 b"Content-Length: 1e3\r\n\r\n", b""):
        client = Client(GAPCHECK, folder)
        try:
            client.send_bytes(data)
            client.process.stdin.close()
        except BrokenPipeError:
            pass
        code = client.process.wait(20)
        _, message = client.receive()
        assert code == 1, (data[:40], code, client.error_text)
        assert message is None if data == b"" else message["error"]["code"] == -32700, (data[:40], message)


def check_exit_with_id(folder):
    """A request `exit` is answered with an error and ends nothing; the notification does."""
    client = Client(GAPCHECK, folder)
    client.start()
    assert "error" in client.ask("exit")
    client.notify("exit")
    assert client.process.wait(20) == 1


def check_unsaved_text(folder):
    """A text that is not that of the file counts as unsaved from the beginning: fix would write over its lines."""
    client = Client(GAPCHECK, folder)
    client.start()
    with open(client.path("two_plates.k"), encoding="utf-8") as file:
        client.open("two_plates.k", "$ not saved\n" + file.read())
    reply = client.ask("workspace/executeCommand", {"command": "gapcheck.fix",
                                                    "arguments": [client.document("two_plates.k")["uri"]]})
    assert "has changed; save it first" in reply.get("error", {}).get("message", ""), reply
    assert client.stop() == 0


def check_hostile_messages(folder):
    """Messages that mean nothing: an error each, and the next one is answered."""
    client = Client(GAPCHECK, folder)
    client.start()
    client.open("new.k", "*NODE\n1,0,0,0\n")
    bad = [b"", b"{", b"nonsense", b"[]", b"1", b"null", b'"text"', b"{}", b'{"id": {}}', b'{"id": 1}x', b"\xff\xfe\x00",
           b'{"jsonrpc": "2.0", "id": 1, "method": "\xe4"}', b'{"a": "' + b"x" * 3_000_000, b"[" * 1_000_000,
           b'{"a":' * 100_000 + b"1" + b"}" * 100_000, b'{"a": "' + b"\\ud800" * 300_000 + b'"}']
    for body in bad:
        client.send(body)
    text = {"textDocument": client.document("new.k")}
    odd = [None, 1, [], "x", {"textDocument": 1}, {"textDocument": {"uri": 7}}, {"textDocument": {"uri": "no"}},
           {**text, "position": None}, {**text, "position": {"line": -1, "character": -1}},
           {**text, "position": {"line": 1e30, "character": 0}}, {**text, "position": {"line": "1", "character": []}},
           {**text, "position": {"line": 4294967295, "character": 4294967295}},
           {**text, "position": {"line": 18446744073709551615, "character": 18446744073709551615}},
           {**text, "position": {"line": 1, "character": 999}, "newName": 5, "context": 5},
           {**text, "range": {"start": {"line": 9, "character": 9}, "end": {"line": 0, "character": 0}}},
           {**text, "range": [], "contentChanges": {}}, {**text, "contentChanges": [1, None, {"text": 5}]},
           {**text, "contentChanges": [{"text": "x", "range": {"start": 1}}]},
           {"command": "gapcheck.fix", "arguments": 5}, {"command": "gapcheck.fix", "arguments": [5]},
           {"command": "rm", "arguments": ["/"]},
           {"textDocument": {"uri": uri_of(client.path("other.k")), "text": 5}},
           {"textDocument": {"uri": "file:///%00", "text": "x"}}, {"textDocument": {"uri": "", "text": "*NODE"}}]
    requests = ("hover", "completion", "definition", "references", "prepareRename", "rename", "documentSymbol",
                "foldingRange", "rangeFormatting", "codeAction")
    for params in odd:
        for method in requests:
            assert "id" in client.ask("textDocument/" + method, params), (method, params)
        client.ask("workspace/executeCommand", params)
        for method in ("didOpen", "didChange", "didSave", "didClose"):
            if method != "didClose" or params is None:
                client.notify("textDocument/" + method, params)
    # Ranges far out of the text, backwards, in the middle of characters.
    client.open("new.k", "*NODE\n1,0,0,0\n")
    client.change("new.k", 9, (5, 5, 1, 1, "y"), (4294967295, 0, 4294967295, 9, "\n*END"), (0, 3, 0, 99999, "DE😀"),
                  (0, 6, 0, 6, "z"))
    symbols = client.request("textDocument/documentSymbol", text)
    assert [each["name"] for each in symbols] == ["*NODEZ😀", "*END"], symbols
    hostile = ["\0" * 1000, "*" * 200_000, "*\n" * 5000, "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n" * 500,
               "*PART\n" + "&" * 100_000, "*NODE\n" + "," * 100_000, "*KEYWORD LONG=Y\n*SET_NODE_LIST\n" + "9" * 50_000,
               "*PARAMETER\nR a " + "(" * 50_000, "*INCLUDE\nnew.k\n", "*INCLUDE\n" + "../" * 5000 + "\n", "\r" * 1000,
               "*ELEMENT_SOLID\n" + "1\n" * 1000, "*SECTION_BEAM\n,\n"]
    for version, content in enumerate(hostile):
        client.notify("textDocument/didChange", {"textDocument": {**client.document("new.k"), "version": version},
                                                 "contentChanges": [{"text": content}]})
        for line in (0, 1, 2, 3):
            for method in requests:
                reply = client.ask("textDocument/" + method, client.at(
                    "new.k", line, 2, newName="5", range={"start": {"line": 0, "character": 0},
                                                          "end": {"line": 4, "character": 0}}))
                assert "result" in reply or reply["error"]["code"] in (-32803, -32602), (content[:40], method, reply)
    assert client.stop() == 0, client.error_text


def check_giant(folder):
    """A message that is too long is passed over, and the next one is answered."""
    client = Client(GAPCHECK, folder)
    client.start()
    size = (1 << 30) + 1
    client.process.stdin.write(b"Content-Length: %d\r\n\r\n" % size)
    block = b"x" * (1 << 24)
    sent = 0
    while sent < size:
        sent += client.process.stdin.write(block[:min(len(block), size - sent)])
    client.process.stdin.flush()
    assert client.wait(lambda m: "error" in m)["error"]["code"] == -32700
    client.open("new.k", "*NODE\n")
    assert client.request("textDocument/hover", client.at("new.k", 0, 0)) is not None
    assert client.stop() == 0


CHECKS = [check_editing, check_utf8, check_lifecycle, check_settings, check_same_as_audit, check_deleted,
          check_newer_audits, check_broken_streams, check_exit_with_id, check_unsaved_text, check_hostile_messages, check_giant]


def main():
    for check in CHECKS:
        if len(sys.argv) > 3 and check.__name__ not in sys.argv[3:]:
            continue
        started = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            if check in (check_same_as_audit, check_unsaved_text):
                shutil.copy(os.path.join(PROJECT, "data", "two_plates.k"), folder)
            check(folder)
        print(f"{check.__name__}: {time.monotonic() - started:.1f} s")


if __name__ == "__main__":
    main()
