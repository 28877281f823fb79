"""What callers give, as the compiled part takes it: paths of files, numbers, arrays, and objects of this package."""

from __future__ import annotations

import os
from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from .native import Native

Floats = NDArray[numpy.float64]
Bools = NDArray[numpy.bool_]
Tuple3 = tuple[float, float, float]
File = Union[str, os.PathLike[str]]


def array(name: str, values: ArrayLike, *shapes: tuple[Optional[int], ...]) -> Floats:
    """The values as a C-contiguous array of float64, in place where they are one already. None in a shape stands for any
    number of rows, of which there are none in an empty list."""
    wanted = " or ".join("(" + ", ".join("n" if n is None else str(n) for n in s) + ("," if len(s) == 1 else "") + ")"
                         for s in shapes)
    require_unmasked(name, values)
    try:
        given = numpy.asarray(values)
    except ValueError:
        raise ValueError(f"{name}: expected shape {wanted}, found rows of different lengths") from None
    if given.size == 0 and given.ndim == 1 and shapes[0][0] is None:
        given = numpy.zeros([n or 0 for n in shapes[0]])
    if given.dtype.kind not in "iuf":
        raise TypeError(f"{name}: expected numbers, found {_kind_of(values, given)}")
    if not any(len(s) == given.ndim and all(n in (None, m) for n, m in zip(s, given.shape)) for s in shapes):
        raise ValueError(f"{name}: expected shape {wanted}, found {given.shape}")
    return numpy.ascontiguousarray(given, dtype=numpy.float64)


def require_unmasked(name: str, values: ArrayLike) -> None:
    """Below a mask stands a number that nobody means, also where rows of a list are masked arrays."""
    if isinstance(values, numpy.ma.MaskedArray):
        if numpy.any(values.mask):
            raise ValueError(f"{name}: expected numbers, found a masked array with masked values: leave them out")
    elif isinstance(values, (list, tuple)):
        for row in values:
            if isinstance(row, (list, tuple, numpy.ma.MaskedArray)):
                require_unmasked(name, row)


def _kind_of(values: Any, given: NDArray[Any]) -> str:
    return f"an array of {given.dtype}" if given.ndim else type(values).__name__


def number(name: str, value: Any) -> float:
    """Any number of Python or NumPy."""
    if isinstance(value, (bool, str, bytes)) or not hasattr(value, "__float__"):
        raise TypeError(f"{name}: expected a number, found {value!r}")
    return float(value)


def whole(name: str, value: Any) -> int:
    """A whole number, 0 or more."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{name}: expected a whole number, found {value!r}")
    if value.__index__() < 0 or value.__index__() >= 2**31:
        raise ValueError(f"{name}: expected a whole number from 0 to 2147483647, found {value!r}")
    return int(value.__index__())


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected text, found {value!r}")
    return value


def texts(name: str, values: Iterable[str]) -> list[str]:
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise TypeError(f"{name}: expected a list of text, found {values!r}")
    return [text(f"{name}[{i}]", one) for i, one in enumerate(values)]


def limits(value: Optional[Mapping[str, float]]) -> Optional[dict[str, Optional[float]]]:
    """Limits by their names in records."""
    if value is None:
        return None
    if not isinstance(value, Mapping):
        raise TypeError(f"limits: expected names with numbers, such as {{'vmax': 8, 'amax': 6}}, found {value!r}")
    return {text("limits", key): None if n is None else number(f"limits['{key}']", n) for key, n in value.items()}


def file(name: str, value: File) -> str:
    """The name of a file, of text or of a pathlib.Path."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{name}: expected a path, found {value!r}")
    return os.fsdecode(value)


def native(name: str, value: Any, *kinds: type[Native]) -> Any:
    """The compiled object in `value`, which is of one of the kinds."""
    if isinstance(value, kinds):
        return value._native
    raise TypeError(f"{name}: expected a {' or '.join(k.__name__ for k in kinds)}, found {type(value).__name__}")


def natives(name: str, values: Union[Native, Iterable[Native]], *kinds: type[Native]) -> list[Any]:
    """The compiled objects of one or of several."""
    several: Sequence[Any] = [values] if isinstance(values, kinds) else list(_iterable(name, values, kinds))
    return [native(f"{name}[{i}]" if len(several) > 1 else name, one, *kinds) for i, one in enumerate(several)]


def _iterable(name: str, values: Any, kinds: tuple[type[Native], ...]) -> Iterable[Any]:
    if isinstance(values, Iterable) and not isinstance(values, (str, bytes)):
        return values
    raise TypeError(f"{name}: expected a {' or '.join(k.__name__ for k in kinds)}, or a list of them, found {values!r}")
