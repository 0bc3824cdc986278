"""Chromium without a window, driven over the pipe of its DevTools protocol; and the pixels of its pictures.

Only the standard library is used. WebGL is drawn by the processor (SwiftShader), so no graphics card is needed.
"""

import base64
import json
import os
import select
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import zlib


def program():
    """The path of Chromium; None where it is not installed."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


class Browser:
    """One tab. Collects the errors that its console shows."""

    def __init__(self, width=1280, height=900, dark=False, webgl=True):
        self.folder = tempfile.mkdtemp(prefix="gapcheck_chromium_")
        to_browser, our_write = os.pipe()
        our_read, from_browser = os.pipe()

        def pipes():
            os.dup2(to_browser, 13)
            os.dup2(from_browser, 14)
            os.dup2(13, 3)
            os.dup2(14, 4)

        graphics = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else ["--disable-3d-apis"]
        self.process = subprocess.Popen(
            [program(), "--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--disable-extensions",
             "--disable-background-networking", "--no-first-run", f"--user-data-dir={self.folder}",
             f"--window-size={width},{height}", *graphics, "about:blank"],
            close_fds=False, preexec_fn=pipes, start_new_session=True, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.read, self.write, self.buffer = our_read, our_write, b""
        self.number, self.session, self.errors, self.requests, self.loaded = 0, None, [], [], set()
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        attached = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)
        self.session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.call("Page.setLifecycleEventsEnabled", enabled=True)
        self.resize(width, height, dark)

    def resize(self, width, height, dark=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.call("Emulation.setEmulatedMedia", features=[scheme])

    def close(self):
        # Its profile is thrown away, so there is nothing that an orderly end, which takes it seconds, would save.
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        os.close(self.read)
        os.close(self.write)
        shutil.rmtree(self.folder, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def message(self, seconds):
        """The next message of the browser."""
        end = time.monotonic() + seconds
        while b"\0" not in self.buffer:
            if not select.select([self.read], [], [], max(0, end - time.monotonic()))[0]:
                raise RuntimeError("Chromium does not answer")
            piece = os.read(self.read, 1 << 20)
            if not piece:
                raise RuntimeError("Chromium has ended")
            self.buffer += piece
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def take(self, message):
        """Keeps what an event says."""
        method, what = message.get("method"), message.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = what["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Log.entryAdded" and what["entry"]["level"] == "error":
            self.errors.append(what["entry"]["text"])
        elif method == "Runtime.consoleAPICalled" and what["type"] in ("error", "assert"):
            self.errors.append(" ".join(str(a.get("value", a.get("description"))) for a in what["args"]))
        elif method == "Network.requestWillBeSent":
            self.requests.append(what["request"]["url"][:200])
        elif method == "Page.lifecycleEvent" and what["name"] == "load":
            self.loaded.add(what["loaderId"])

    def call(self, method, seconds=120, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.write, data):]
        while True:
            message = self.message(seconds)
            if message.get("id") == request["id"]:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            self.take(message)

    def open(self, path, seconds=120):
        """Loads a page of gapcheck; returns the seconds until its first picture is drawn, or it has said that it has none."""
        start = time.monotonic()
        self.requests.clear()
        address = path if str(path).startswith("about:") else "file://" + os.path.abspath(path)
        # The browser's first empty page may end loading only now, so this waits for its own page.
        loader = self.call("Page.navigate", url=address)["loaderId"]
        while loader not in self.loaded:
            self.take(self.message(seconds))
        # A page whose scripts fail never draws: after a minute its errors say more than waiting would.
        self.value("new Promise(done => { const look = () => { const canvas = document.getElementById('canvas');"
                   "canvas === null || canvas.dataset.camera || performance.now() > 6e4 ? done() : requestAnimationFrame(look); }; look(); })")
        return time.monotonic() - start

    def value(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']['text']}")
        return result["result"].get("value")

    def click(self, selector, x=None, y=None):
        """A press with the mouse in the middle of an element, or at a place in it."""
        box = self.value(f"(() => {{ const e = document.querySelector({json.dumps(selector)});"
                         "e.scrollIntoView({block: 'nearest'}); const b = e.getBoundingClientRect();"
                         "return [b.x, b.y, b.width, b.height]; })()")
        place = {"x": box[0] + (box[2] / 2 if x is None else x), "y": box[1] + (box[3] / 2 if y is None else y)}
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            button = {} if kind == "mouseMoved" else {"button": "left", "clickCount": 1}
            self.call("Input.dispatchMouseEvent", type=kind, **button, **place)

    def press(self, key):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)

    def becomes(self, expression, seconds=60):
        """Whether an expression of the page is true, now or within some time."""
        end = time.monotonic() + seconds
        while not self.value(expression):
            if time.monotonic() > end:
                return False
            time.sleep(0.05)
        return True

    def settle(self, seconds=60, different_from=None):
        """Waits until the camera stands still, and, if given, has left a place; returns where it is.

        Frames are counted besides time: on a busy machine one of them may take longer than a flight should.
        """
        return self.value(
            "new Promise(done => { const begin = performance.now(); let last = null, since = 0, frames = 0;"
            "const look = now => { const at = document.getElementById('canvas')?.dataset.camera ?? '';"
            f"if (at !== last || at === {json.dumps(different_from)}) {{ last = at; since = now; frames = 0; }}"
            f"if ((++frames > 5 && now - since > 500) || performance.now() - begin > {1000 * seconds}) done(at);"
            "else requestAnimationFrame(look); }; requestAnimationFrame(look); })")

    def picture(self, selector=None, scale=1):
        """The page, or one element of it, as the bytes of a PNG file; smaller by a scale."""
        clip = {}
        if selector:
            box = self.value(f"(() => {{ const e = document.querySelector({json.dumps(selector)});"
                             "const b = e.getBoundingClientRect();"
                             "return [b.x + scrollX, b.y + scrollY, b.width, b.height]; })()")
            clip = {"clip": dict(zip(("x", "y", "width", "height"), box), scale=scale), "captureBeyondViewport": True}
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", **clip)["data"])

    def steady_picture(self, selector):
        """The same once it does not change any more: on a busy machine a frame may be drawn late."""
        last = self.picture(selector)
        for _ in range(40):
            self.settle()
            now = self.picture(selector)
            if now == last:
                break
            last = now
        return last


def colors(png):
    """How often each colour occurs in a PNG file of 8 bits per channel (ISO 15948), as a dictionary."""
    place, data, size = 8, b"", None
    while place < len(png):
        length, kind = struct.unpack(">I4s", png[place:place + 8])
        body = png[place + 8:place + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            data += body
        place += 12 + length
    width, height, _, form = size
    channels = {2: 3, 6: 4}[form]
    raw, row, counts = zlib.decompress(data), bytearray(width * channels), {}
    for y in range(height):
        start = y * (width * channels + 1)
        row = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + width * channels]), row, channels)
        for x in range(0, len(row), channels):
            color = bytes(row[x:x + 3])
            counts[color] = counts.get(color, 0) + 1
    return counts


def unfiltered(kind, row, above, channels):
    """One line of a PNG file without its filter."""
    for i in range(len(row)):
        left = row[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + above[i]) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + above[i]) // 2) & 255
        elif kind == 4:
            guess = left + above[i] - corner
            choices = ((abs(guess - value), place, value) for place, value in enumerate((left, above[i], corner)))
            row[i] = (row[i] + min(choices)[2]) & 255
    return row
