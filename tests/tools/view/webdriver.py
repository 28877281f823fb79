"""A headless Chromium by the W3C WebDriver protocol over plain HTTP: no packages beyond Python's own."""

import base64
import json
import os
import shutil
import socket
import subprocess
import time
import urllib.error
import urllib.request


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Browser:
    """Draws WebGL in software; `with Browser() as b:` ends it again."""

    def __init__(self, width=1440, height=900, extra=()):
        driver = shutil.which("chromedriver")
        chromium = shutil.which("chromium")
        if not driver or not chromium:
            raise FileNotFoundError("chromium and chromedriver")
        port = free_port()
        self._root = f"http://127.0.0.1:{port}"
        self._process = subprocess.Popen([driver, f"--port={port}"], stdout=subprocess.DEVNULL,
                                         stderr=subprocess.DEVNULL)
        arguments = ["--headless=new", f"--window-size={width},{height}", "--use-gl=angle",
                     "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                     "--disable-dev-shm-usage", "--force-device-scale-factor=1", *extra]
        if os.geteuid() == 0:
            arguments.append("--no-sandbox")
        wanted = {"capabilities": {"alwaysMatch": {
            "goog:chromeOptions": {"args": arguments, "binary": chromium},
            "goog:loggingPrefs": {"browser": "ALL"}}}}
        try:
            self._wait_for_driver()
            self._session = self._call("POST", "/session", wanted)["sessionId"]
            self._in_session("POST", "/timeouts", {"script": 300000})  # drawn in software, a frame may take seconds
        except BaseException:
            self._process.kill()
            raise

    def _wait_for_driver(self):
        for _ in range(200):
            try:
                if self._call("GET", "/status")["ready"]:
                    return
            except urllib.error.URLError:
                time.sleep(0.1)
        raise TimeoutError("chromedriver does not answer")

    def _call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self._root + path, data, {"Content-Type": "application/json"},
                                         method=method)
        try:
            with urllib.request.urlopen(request, timeout=300) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def _in_session(self, method, path, body=None):
        return self._call(method, f"/session/{self._session}{path}", body)

    def open(self, path):
        self._in_session("POST", "/url", {"url": "file://" + os.path.abspath(path)})

    def run(self, script, *arguments):
        """The value of a JavaScript function body."""
        return self._in_session("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def until(self, script, seconds=180):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.run(f"return Boolean({script})"):
                return
            time.sleep(0.05)
        raise TimeoutError(f"never true: {script}; console: {self.console()}")

    def centre(self, selector, x_share=0.5):
        """Where the middle of an element is, after scrolling to it; `x_share` along its width."""
        return self.run("const e = document.querySelector(arguments[0]); e.scrollIntoView({block: 'nearest'});"
                        "const b = e.getBoundingClientRect();"
                        "return [b.left + b.width * arguments[1], b.top + b.height / 2]", selector, x_share)

    def pointer(self, *actions):
        """("move", x, y), ("down",), ("up",), in order, by a mouse."""
        kinds = {"move": lambda x, y: {"type": "pointerMove", "duration": 30, "x": int(x), "y": int(y)},
                 "down": lambda: {"type": "pointerDown", "button": 0},
                 "up": lambda: {"type": "pointerUp", "button": 0}}
        steps = [kinds[name](*rest) for name, *rest in actions]
        self._in_session("POST", "/actions", {"actions": [{
            "type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": steps}]})

    def pinch(self, x, y, before, after):
        """Two fingers around (x, y), from `before` pixels apart to `after`."""
        def finger(name, side):
            at = lambda apart: {"type": "pointerMove", "duration": 60, "x": int(x + side * apart / 2), "y": int(y)}
            return {"type": "pointer", "id": name, "parameters": {"pointerType": "touch"}, "actions": [
                at(before), {"type": "pointerDown", "button": 0}, at(after), {"type": "pointerUp", "button": 0}]}
        self._in_session("POST", "/actions", {"actions": [finger("left", -1), finger("right", 1)]})

    def click(self, selector):
        x, y = self.centre(selector)
        self.pointer(("move", x, y), ("down",), ("up",))

    def key(self, text):
        steps = [{"type": t, "value": text} for t in ("keyDown", "keyUp")]
        self._in_session("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": steps}]})

    def prefer(self, scheme):
        """What the system prefers: "light" or "dark"."""
        self._in_session("POST", "/goog/cdp/execute", {"cmd": "Emulation.setEmulatedMedia", "params": {
            "features": [{"name": "prefers-color-scheme", "value": scheme}]}})

    def resize(self, width, height):
        self._in_session("POST", "/goog/cdp/execute", {"cmd": "Emulation.setDeviceMetricsOverride", "params": {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}})

    def screenshot(self, path):
        # Not by /screenshot, which gives up after 10 s: a page drawn in software may take longer.
        taken = self._in_session("POST", "/goog/cdp/execute", {"cmd": "Page.captureScreenshot", "params": {}})
        with open(path, "wb") as out:
            out.write(base64.b64decode(taken["data"]))

    def console(self):
        """Warnings and errors since the last call."""
        return [f"{e['level']}: {e['message']}" for e in self._in_session("POST", "/se/log", {"type": "browser"})
                if e["level"] in ("SEVERE", "WARNING")]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self._in_session("DELETE", "")
        finally:
            self._process.terminate()
            self._process.wait(timeout=30)
