"""What a page of skyway-view holds, read back: numbers as JSON, arrays by name."""

import base64
import html
import json
import re
import struct
import zlib

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

    def columns(self, reference):
        """Of a packed array: differences, modulo 2^32, small ones of either sign first, by bytes (tools/view/bundle.h)."""
        at, size, count = reference["at"], reference["bytes"], reference["count"]
        planes = zlib.decompress(self._bytes[at:at + size], -15)
        assert len(planes) == 4 * count * reference["columns"]
        out = []
        for c in range(reference["columns"]):
            parts = [planes[(4 * c + k) * count:(4 * c + k + 1) * count] for k in range(4)]
            value, column = 0, []
            for folded in (a | b << 8 | d << 16 | e << 24 for a, b, d, e in zip(*parts)):
                value = (value + (folded >> 1 ^ -(folded & 1))) % 2**32
                column.append(value)
            out.append(column)
        return out

    def boxes(self, reference, step):
        """Of a packed array of boxes: (low, high) in the page's metres."""
        signed = lambda v: v - 2**32 if v >= 2**31 else v
        rows = zip(*self.columns(reference))
        return [([signed(v) * step for v in row[:3]], [(signed(low) + signed(size)) * step for low, size in zip(row[:3], row[3:])])
                for row in rows]

    def array(self, reference):
        if reference["type"] == "packed":
            return tuple(self.columns(reference)[0])
        code, size = CODES[reference["type"]]
        assert reference["at"] + size * reference["count"] <= len(self._bytes)
        return struct.unpack_from(f"<{reference['count']}{code}", self._bytes, reference["at"])

    def points(self, reference):
        """In ENU metres."""
        flat, origin = self.array(reference), self.meta["origin"]
        return [tuple(flat[i + k] + origin[k] for k in range(3)) for i in range(0, len(flat), 3)]
