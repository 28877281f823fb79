"""What a page of skyway-view holds, read back: numbers as JSON, arrays by name."""

import base64
import html
import json
import re
import struct

CODES = {"f4": ("f", 4), "u4": ("I", 4), "u2": ("H", 2), "u1": ("B", 1)}


class Page:
    def __init__(self, path):
        text = open(path, encoding="utf-8").read()
        self.text = text
        self.title = html.unescape(re.search("<title>(.*?)</title>", text).group(1))
        self.meta = json.loads(self._script("skyway-meta", text))
        self._bytes = base64.b64decode(self._script("skyway-arrays", text), validate=True)

    @staticmethod
    def _script(name, text):
        return re.search(f'<script id="{name}"[^>]*>(.*?)</script>', text, re.S).group(1)

    def array(self, reference):
        code, size = CODES[reference["type"]]
        assert reference["at"] + size * reference["count"] <= len(self._bytes)
        return struct.unpack_from(f"<{reference['count']}{code}", self._bytes, reference["at"])

    def points(self, reference):
        """In ENU metres."""
        flat, origin = self.array(reference), self.meta["origin"]
        return [tuple(flat[i + k] + origin[k] for k in range(3)) for i in range(0, len(flat), 3)]
