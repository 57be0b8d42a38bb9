# SPDX-License-Identifier: GPL-3.0-or-later
"""Options as keyword arguments: the fields of the C++ structs, as _core.fields() lists them."""
from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any, TypeVar

from . import _core
from ._arguments import as_ids_of_corners, as_text, as_vector

Function = TypeVar("Function", bound=Callable[..., Any])

FIELDS: dict[str, dict[str, Any]] = {field["name"]: field for field in _core.fields()}
# Those that visit_fields leaves out, with what makes a value of an argument.
OTHERS: dict[str, Callable[[str, Any], Any]] = {"up": as_vector, "holes": as_text, "corners": as_ids_of_corners}


def takes_options(*groups: str) -> Callable[[Function], Function]:
    """`**options` of a function are the fields of these structs, or these fields (all, where none is named). Its signature shows
    them with their defaults, and it refuses others."""

    def decorate(function: Function) -> Function:
        signature = inspect.signature(function)
        shown = [p for p in signature.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
        for field in fields_of(groups):
            shown.append(
                inspect.Parameter(field["name"], inspect.Parameter.KEYWORD_ONLY, default=field["default"])
            )
        setattr(function, "__signature__", signature.replace(parameters=shown))
        return function

    return decorate


def fields_of(groups: tuple[str, ...]) -> list[dict[str, Any]]:
    """Of the structs boundary, loops, boundary_loops, map, mesh, or of their own name."""
    return [f for f in FIELDS.values() if not groups or f["group"] in groups or f["name"] in groups]


def chosen(function: Callable[..., Any], preset: str, given: dict[str, Any]) -> _core.Options:
    """The preset's options with what was given on top; None stands for the default."""
    known = set(inspect.signature(function).parameters) - {"preset"}
    for name in given:
        if name not in known:
            raise TypeError(f"{function.__name__}() has no option {name!r}; rimline.options() lists all")
    values = {name: value for name, value in given.items() if value is not None}
    for name in values.keys() & OTHERS.keys():
        values[name] = OTHERS[name](name, values[name])
    return _core.options(as_text("preset", preset), values)


def options(preset: str = "default") -> dict[str, Any]:
    """Give the defaults of a preset, by the names of the keyword arguments.

    Parameters
    ----------
    preset : {'default', 'paper', 'paper-log'}
        The set of defaults.

    Returns
    -------
    dict
        Value by name.

    Raises
    ------
    Error
        BadOption, where there is no such preset.
    """
    _core.options(as_text("preset", preset), {})
    values: dict[str, Any] = _core.presets()[preset]
    return values
