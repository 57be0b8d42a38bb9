# SPDX-License-Identifier: GPL-3.0-or-later
"""`cloud.rimline.reconstruct()` on every PyVista data set, where both packages were imported, in any order."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from ._methods import boundary, parameterize, reconstruct
from ._results import BoundaryResult, ParameterizeResult, ReconstructResult


class RimlineAccessor:
    """The method over the points of a data set; its point data `Normals`, where it has them, tell the side that the
    mesh faces. Arguments are those of the functions of the same names."""

    def __init__(self, dataset: pyvista.DataSet) -> None:
        self._dataset = dataset

    def boundary(self, **options: Any) -> BoundaryResult:
        """`rimline.boundary` of the points."""
        return boundary(np.asarray(self._dataset.points), **options)

    def parameterize(self, **options: Any) -> ParameterizeResult:
        """`rimline.parameterize` of the points."""
        return parameterize(np.asarray(self._dataset.points), **self._with_normals(options))

    def reconstruct(self, **options: Any) -> ReconstructResult:
        """`rimline.reconstruct` of the points."""
        return reconstruct(np.asarray(self._dataset.points), **self._with_normals(options))

    def _with_normals(self, options: dict[str, Any]) -> dict[str, Any]:
        if "Normals" not in self._dataset.point_data:
            return options
        return {"normals": np.asarray(self._dataset.point_data["Normals"])} | options


def _register() -> None:
    if hasattr(pyvista, "register_dataset_accessor"):
        pyvista.register_dataset_accessor("rimline", pyvista.DataSet)(RimlineAccessor)
    else:  # before PyVista 0.48
        setattr(pyvista.DataSet, "rimline", property(RimlineAccessor))


_register()
