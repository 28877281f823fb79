"""What is raised where something is wrong with the data or with how a function is used."""

from __future__ import annotations

from typing import Optional


class InputError(ValueError):
    """A bad file, a bad record, or things that do not belong together.

    The message begins with the source and the line: `boxes.csv:2: min_x must be a finite number within 1e8 m, found "x"`.
    The attributes have its parts. What a message does not say is "", a line None.
    """

    source: str = ""
    """The file, the record or the argument."""
    line: Optional[int] = None
    item: str = ""
    """The part of the source: `feature 3`."""
    key: str = ""
    """What has the wrong value: `margin`."""
    expected: str = ""
    found: str = ""
    advice: str = ""
    """What to do about it."""


class UsageError(ValueError):
    """An argument that the function cannot obey.

    For example an unknown vehicle, missing limits, limits looser than the vehicle's, or an option that would change nothing.
    """
