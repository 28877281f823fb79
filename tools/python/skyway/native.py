"""What all classes of the package share: each holds one object of the compiled part."""

from __future__ import annotations

from typing import Any, Self, TypeVar

from . import _skyway

T = TypeVar("T")


class Native:
    """An object of the compiled part."""

    __slots__ = ("_native",)
    _native: Any

    @classmethod
    def _of(cls, native: Any) -> Self:
        self = cls.__new__(cls)
        self._native = native
        return self


def of_same_file(map: Native, answer: T) -> T:
    """The answer, unless the file of the map was written to since it was opened: then it may be of neither state."""
    _skyway.require_unchanged(map._native)
    return answer
