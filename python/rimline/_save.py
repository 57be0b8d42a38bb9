# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of results, with the columns that the tool writes (cli/columns.cpp)."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import as_path
from ._arrays import as_doubles
from ._files import file_columns
from ._progress import Run
from .typing import PathLike

if TYPE_CHECKING:
    from ._results import BoundaryResult, ReconstructResult

Columns = dict[str, npt.NDArray[Any]]


def _boundary_columns(result: BoundaryResult) -> Columns:
    made: Columns = {
        "boundary": result.boundary,
        "loop": result.loop,
        "candidate": result.candidate,
        "p_value": result.p_value,
        "score": result.score,
    }
    if result.probability is not None and result.label is not None:
        made |= {"boundary_probability": result.probability, "label": result.label}
    return made


def _lengthened(values: npt.NDArray[Any], added: int) -> npt.NDArray[Any]:
    """Vertices of fills have NaN, or 0 where the type has no NaN."""
    unknown = np.nan if values.dtype.kind == "f" else 0
    return np.concatenate([values, np.full(added, unknown, values.dtype)])


def _fills_holes(result: ReconstructResult) -> bool:
    """Presets that do not use the option leave it out of their report."""
    return bool(result.report["options"].get("holes", "keep") != "keep")


def _mesh_columns(result: ReconstructResult) -> Columns:
    made = {name: _lengthened(values, len(result.added)) for name, values in result.columns.items()}
    made |= {"u": result.uv[:, 0], "v": result.uv[:, 1]}
    made["boundary"] = _lengthened(result.boundary, len(result.added))
    if result.patch is not None:
        made["component"] = result.patch
    if _fills_holes(result):
        made["filled"] = np.arange(len(result.uv)) >= len(result.points)
    return made


def _face_columns(result: ReconstructResult) -> Columns:
    made: Columns = {}
    if _fills_holes(result) and result.filled is not None:
        made["filled"] = result.filled
    if result.chart is not None and result.chart.max(initial=0) > 0:
        made["chart"] = result.chart
    return made


def _seams(result: ReconstructResult) -> Columns:
    if result.seam_uv is None or result.seam_point is None or result.corners is None:
        return {}
    return {"uv": result.seam_uv, "point": result.seam_point, "corners": result.corners}


def save_boundary(result: BoundaryResult, path: PathLike) -> None:
    """.ply: the points; else the loops."""
    name = as_path(path)
    with Run() as run:
        if name.lower().endswith(".ply"):
            columns = file_columns({**result.columns, **_boundary_columns(result)})
            places = as_doubles(result.points)
            _core.write_cloud(name, places, result.points.dtype == np.float32, columns, run)
        else:
            _core.write_loops(name, result.loops, as_doubles(result.points), run)


def save_mesh(result: ReconstructResult, path: PathLike) -> None:
    """The mesh or, by an ending that meshes have not, the loops."""
    name = as_path(path)
    if not name.lower().endswith(tuple("." + ending for ending in _core.mesh_endings())):
        save_boundary(result, path)
        return
    vertices = result.vertices
    with Run() as run:
        _core.write_mesh(
            name,
            as_doubles(vertices),
            vertices.dtype == np.float32,
            file_columns(_mesh_columns(result)),
            result.faces,
            file_columns(_face_columns(result)),
            _seams(result),
            run,
        )
