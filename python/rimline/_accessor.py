# SPDX-License-Identifier: GPL-3.0-or-later
"""Registers the accessor of PyVista as soon as PyVista is there, and never imports it: many do without."""
from __future__ import annotations

import importlib
import importlib.util
import sys
from collections.abc import Sequence
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Optional


class _AfterPyVista(MetaPathFinder):
    """Waits for `import pyvista`, which goes on as if it were not there."""

    def find_spec(
        self, name: str, path: Optional[Sequence[str]] = None, target: Optional[ModuleType] = None
    ) -> Optional[ModuleSpec]:
        if name != "pyvista":
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        if spec is not None and spec.loader is not None:
            execute = spec.loader.exec_module

            def execute_and_register(module: ModuleType) -> None:
                execute(module)
                importlib.import_module("rimline.pyvista")

            setattr(spec.loader, "exec_module", execute_and_register)
        return spec


def register() -> None:
    """At once where PyVista is imported already, else when it is."""
    if "pyvista" in sys.modules:
        importlib.import_module("rimline.pyvista")
    else:
        sys.meta_path.insert(0, _AfterPyVista())
