"""A client of gapcheck lsp: starts the program, sends requests and notifications, keeps what the server says."""
import json
import os
import queue
import subprocess
import threading
import time
import urllib.parse


def uri_of(path):
    return "file://" + urllib.parse.quote(os.path.abspath(path))


def frame(message):
    body = message if isinstance(message, bytes) else json.dumps(message, ensure_ascii=False).encode()
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


class Client:
    def __init__(self, gapcheck, folder, arguments=(), encodings=None):
        self.folder = folder
        self.process = subprocess.Popen([gapcheck, "lsp", *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, cwd=folder)
        self.inbox = queue.Queue()
        self.said = []  # notifications and requests of the server, in order
        self.next_id = 0
        self.encodings = encodings
        threading.Thread(target=self._read, daemon=True).start()
        self.error_text = b""
        threading.Thread(target=self._read_errors, daemon=True).start()

    def _read(self):
        out = self.process.stdout
        while True:
            length = None
            line = out.readline()
            if not line:
                break
            while line not in (b"\r\n", b""):
                if line.lower().startswith(b"content-length:"):
                    length = int(line.split(b":")[1])
                line = out.readline()
            self.inbox.put((time.perf_counter(), json.loads(out.read(length))))
        self.inbox.put((time.perf_counter(), None))

    def _read_errors(self):
        for line in self.process.stderr:
            self.error_text += line

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        self.send_bytes(frame(message))

    def notify(self, method, params=None):
        self.send({"jsonrpc": "2.0", "method": method, "params": params or {}})

    def receive(self, timeout=60):
        """The next message with the time at which it came; None at the end of the output."""
        return self.inbox.get(timeout=timeout)

    def wait(self, wanted, timeout=60):
        """The next message that is wanted; all others are kept in `said`."""
        end = time.monotonic() + timeout
        while True:
            _, message = self.receive(max(0.01, end - time.monotonic()))
            assert message is not None, "the server has ended: " + self.error_text.decode(errors="replace")
            if "method" in message:
                self.said.append(message)
            if wanted(message):
                return message

    def ask(self, method, params=None, timeout=60):
        """The whole response."""
        self.next_id += 1
        own = self.next_id
        self.send({"jsonrpc": "2.0", "id": own, "method": method, "params": params or {}})
        return self.wait(lambda message: message.get("id") == own and "method" not in message, timeout)

    def request(self, method, params=None, timeout=60):
        """The result."""
        response = self.ask(method, params, timeout)
        assert "result" in response, response
        return response["result"]

    def start(self, **more):
        general = {"general": {"positionEncodings": self.encodings}} if self.encodings else {}
        result = self.request("initialize", {"processId": os.getpid(), "rootUri": uri_of(self.folder),
                                             "capabilities": general, **more})
        self.notify("initialized")
        return result

    def stop(self):
        """Ends the server in the orderly way; its exit code."""
        self.request("shutdown")
        self.notify("exit")
        return self.process.wait(20)

    # Documents

    def path(self, name):
        return os.path.join(self.folder, name)

    def open(self, name, text=None):
        if text is None:
            with open(self.path(name), encoding="utf-8", newline="") as file:
                text = file.read()
        self.notify("textDocument/didOpen", {"textDocument": {"uri": uri_of(self.path(name)), "languageId": "lsdyna",
                                                              "version": 1, "text": text}})

    def document(self, name):
        return {"uri": uri_of(self.path(name))}

    def at(self, name, line, character, **more):
        return {"textDocument": self.document(name), "position": {"line": line, "character": character}, **more}

    def diagnostics(self, name, version=1, timeout=60):
        """Those of the next time that the server publishes some for this version of the file."""
        uri = uri_of(self.path(name))
        said = self.wait(lambda m: m.get("method") == "textDocument/publishDiagnostics" and
                         (m["params"]["uri"], m["params"].get("version")) == (uri, version), timeout)
        return said["params"]["diagnostics"]

    def audited(self, timeout=60):
        """Waits for the end of an audit; its line in the log."""
        said = self.wait(lambda m: m.get("method") == "window/logMessage" and
                         m["params"]["message"].startswith("gapcheck audit"), timeout)
        return said["params"]["message"]

    def found(self, name):
        """The diagnostics that were last published for a file."""
        uri = uri_of(self.path(name))
        for message in reversed(self.said):
            if message["method"] == "textDocument/publishDiagnostics" and message["params"]["uri"] == uri:
                return message["params"]["diagnostics"]
        return None

    def change(self, name, version, *changes):
        """Each change: (first line, first character, last line, last character, text)."""
        self.notify("textDocument/didChange", {
            "textDocument": {**self.document(name), "version": version},
            "contentChanges": [{"range": {"start": {"line": a, "character": b}, "end": {"line": c, "character": d}},
                                "text": text} for a, b, c, d, text in changes]})
