"""What notebooks show of an object."""

from __future__ import annotations

import re

_WIDTH = 640  # pixels


def small(svg: str) -> str:
    """The same picture, as wide as a notebook's column."""
    return re.sub(r'width="([0-9.]+)" height="([0-9.]+)"',
                  lambda size: f'width="{_WIDTH}" height="{_WIDTH * float(size[2]) / float(size[1]):.0f}"', svg, count=1)
