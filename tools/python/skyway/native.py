"""What all classes of the package share: each holds one object of the compiled part."""

from __future__ import annotations

from typing import Any, Self


class Native:
    """An object of the compiled part."""

    __slots__ = ("_native",)
    _native: Any

    @classmethod
    def _of(cls, native: Any) -> Self:
        self = cls.__new__(cls)
        self._native = native
        return self
