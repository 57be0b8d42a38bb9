# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments that are neither arrays nor fields of the options: whole numbers, vectors, names of files."""
from __future__ import annotations

import operator
import os
from typing import Any

from ._core import ErrorCode
from ._errors import Error
from .typing import PathLike


def _index(name: str, value: Any) -> int:
    try:
        if isinstance(value, bool):
            raise TypeError
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, not {value!r}") from None


def as_whole(name: str, value: Any, most: int) -> int:
    """An integer from 0 to `most`."""
    number = _index(name, value)
    if not 0 <= number <= most:
        raise Error(f"{name} is {number}; it must lie between 0 and {most}", ErrorCode.BadOption)
    return number


def _items(name: str, value: Any, count: int) -> list[Any]:
    try:
        items = list(value)
    except TypeError:
        raise TypeError(f"{name} must be {count} numbers, not {value!r}") from None
    if len(items) != count:
        raise ValueError(f"{name} must be {count} numbers, not {len(items)}")
    return items


def as_vector(name: str, value: Any) -> tuple[float, ...]:
    """Three numbers."""
    items = _items(name, value, 3)
    try:
        return tuple(float(item) for item in items)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be 3 numbers, not {value!r}") from None


def as_ids_of_corners(name: str, value: Any) -> tuple[int, ...]:
    """Four ids of points."""
    ids = tuple(_index(name, item) for item in _items(name, value, 4))
    for number in ids:
        if not 0 <= number < 2**31:
            raise Error(f"{name} has the id {number}, which no point has", ErrorCode.BadOption)
    return ids


def as_text(name: str, value: Any) -> str:
    """A string."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a string, not {value!r}")
    return value


def as_path(path: PathLike) -> str:
    """The name of a file; bytes are in the encoding of the file system."""
    name = os.fsdecode(path)
    if "\0" in name:
        raise ValueError(f"the name {name!r} has a null character")
    try:
        name.encode()
    except UnicodeEncodeError:
        raise ValueError(f"the name {name!r} is not Unicode") from None
    return name
