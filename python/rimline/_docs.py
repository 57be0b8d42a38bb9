# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings, which the build makes of the comments in the C++ headers (python/docs)."""
from __future__ import annotations

from typing import Any, TypeVar

from ._docstrings import DOCSTRINGS

Documented = TypeVar("Documented", bound=Any)


def documented(item: Documented) -> Documented:
    """Gives a function or class its docstring."""
    item.__doc__ = DOCSTRINGS[item.__name__]
    return item
