# SPDX-License-Identifier: GPL-3.0-or-later
"""From what people have to what the library takes: contiguous arrays of one type and shape."""
from __future__ import annotations

from typing import Any, Literal, cast

import numpy as np
import numpy.typing as npt

from .typing import Ids, Numbers, Places, PointsLike, Triangles

Doubles = np.ndarray[tuple[int, Literal[3]], np.dtype[np.float64]]
MOST_POINTS = 2**31 - 2


def _plain(values: Any, what: str) -> npt.NDArray[Any]:
    """An array of real numbers; what a mask hides is NaN."""
    try:
        array = np.asanyarray(values)
    except ValueError as error:
        raise ValueError(f"{what} can not be made an array: {error}") from None
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{what} must be real numbers, not {array.dtype}")
    if isinstance(array, np.ma.MaskedArray):
        array = np.ma.filled(array.astype(np.float64), np.nan)
    return np.asarray(array)


def _columns(values: Any) -> Any:
    """The columns x, y, z of a frame, the points of a data set, else the values themselves."""
    if isinstance(values, np.ndarray):
        return values
    if hasattr(values, "columns") and hasattr(values, "to_numpy"):
        missing = [axis for axis in "xyz" if axis not in values.columns]
        if missing:
            raise ValueError(f"the frame has no column {', '.join(missing)}")
        return values[["x", "y", "z"]].to_numpy()
    return getattr(values, "points", values)


def as_places(values: PointsLike, what: str = "points") -> Places:
    """(n, 3), float32 where it was, else float64; no copy where it is so already."""
    array = _plain(_columns(values), what)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} must have the shape (n, 3), not {array.shape}")
    if array.shape[0] > MOST_POINTS:
        raise ValueError(f"{what} has {array.shape[0]} rows; at most {MOST_POINTS} are possible")
    single = array.dtype.newbyteorder("=") == np.float32
    return cast(Places, np.ascontiguousarray(array, dtype=np.float32 if single else np.float64))


def as_doubles(values: PointsLike, what: str = "points") -> Doubles:
    """(n, 3), float64, C order; no copy where it is so already."""
    return cast(Doubles, np.ascontiguousarray(as_places(values, what), dtype=np.float64))


def as_rows(values: npt.ArrayLike, columns: int, what: str) -> npt.NDArray[np.float64]:
    """(n, columns), float64, C order."""
    array = _plain(values, what)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{what} must have the shape (n, {columns}), not {array.shape}")
    return np.ascontiguousarray(array, dtype=np.float64)


def as_numbers(values: npt.ArrayLike, what: str) -> Numbers:
    """(n,), float64."""
    array = _plain(values, what)
    if array.ndim != 1:
        raise ValueError(f"{what} must have the shape (n,), not {array.shape}")
    return cast(Numbers, np.ascontiguousarray(array, dtype=np.float64))


def _as_int32(values: npt.ArrayLike, what: str) -> npt.NDArray[np.int32]:
    array = _plain(values, what)
    if array.size == 0:
        return np.ascontiguousarray(array, dtype=np.int32)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{what} must be integers, not {array.dtype}")
    if int(array.max()) >= 2**31 or int(array.min()) < -(2**31):
        raise ValueError(f"{what} must be ids of points; they have {MOST_POINTS} at most")
    return np.ascontiguousarray(array, dtype=np.int32)


def as_ids(values: npt.ArrayLike, what: str) -> Ids:
    """(n,), int32."""
    array = _as_int32(values, what)
    if array.ndim != 1:
        raise ValueError(f"{what} must have the shape (n,), not {array.shape}")
    return cast(Ids, array)


def as_triangles(values: npt.ArrayLike, what: str = "triangles") -> Triangles:
    """(m, 3), int32."""
    array = _as_int32(values, what)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} must have the shape (m, 3), not {array.shape}")
    return cast(Triangles, array)
