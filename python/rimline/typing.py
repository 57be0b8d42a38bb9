# SPDX-License-Identifier: GPL-3.0-or-later
"""Types of arrays with their shapes, and of arguments."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Literal, Optional, Union

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from ._loops import Loop

#: (n, 3): points or vertices in the unit of the input, float32 or float64 as they were given.
Places = np.ndarray[tuple[int, Literal[3]], np.dtype[np.floating[Any]]]
#: (n, 2): places in the plane.
UV = np.ndarray[tuple[int, Literal[2]], np.dtype[np.float64]]
#: (m, 3): ids of points, counter-clockwise seen from the side that the surface faces.
Triangles = np.ndarray[tuple[int, Literal[3]], np.dtype[np.int32]]
#: (n,): ids of points or of loops.
Ids = np.ndarray[tuple[int], np.dtype[np.int32]]
#: (n,): yes or no for each point or triangle.
Flags = np.ndarray[tuple[int], np.dtype[np.bool_]]
#: (n,): values of PointLabel.
Labels = np.ndarray[tuple[int], np.dtype[np.uint8]]
#: (n,): one number for each point.
Numbers = np.ndarray[tuple[int], np.dtype[np.float64]]
#: (n,): likewise, in single precision.
Floats = np.ndarray[tuple[int], np.dtype[np.float32]]

#: Points as they come: an array of the shape (n, 3), a frame with x, y and z, or what has `points`.
PointsLike = Union[npt.ArrayLike, Any]
#: Loops as they come: rimline.Loop, or arrays of ids.
LoopsLike = Iterable[Union["Loop", npt.ArrayLike]]
#: True for a bar, or a callable (stage, done, total), False from which cancels.
ProgressLike = Union[bool, None, Callable[[str, int, int], Optional[bool]]]
#: A file.
PathLike = Union[str, "os.PathLike[str]"]
