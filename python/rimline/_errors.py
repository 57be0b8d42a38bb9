# SPDX-License-Identifier: GPL-3.0-or-later
"""How the library says no."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._core import ErrorCode, exit_status
from .typing import Ids


class Error(RuntimeError):
    """The library can not give its result.

    Attributes
    ----------
    code : ErrorCode
        Why; the tool's exit status follows from it.
    ids : ndarray of int32, shape (n,)
        The points that are the reason, ascending; may be empty.
    """

    __module__ = "rimline"
    code: ErrorCode
    ids: Ids

    def __init__(self, message: str, code: ErrorCode, ids: npt.ArrayLike = ()) -> None:
        super().__init__(message)
        self.code = code
        self.ids = np.asarray(ids, dtype=np.int32)

    @property
    def exit_status(self) -> int:
        """Exit status of the tool for this code, 1 to 5."""
        return exit_status(self.code)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.code, self.ids)
