# SPDX-License-Identifier: GPL-3.0-or-later
"""The method from end to end. The build writes the options into the stub (_methods.pyi)."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, Optional

import numpy.typing as npt

from . import _core
from ._arrays import Doubles, as_doubles, as_places, as_rows
from ._docs import documented
from ._files import Cloud, file_columns
from ._loops import as_loops
from ._options import chosen, takes_options
from ._progress import Run
from ._reference import ReferenceLike, as_reference
from ._results import BoundaryResult, ParameterizeResult, ReconstructResult
from .typing import LoopsLike, PointsLike, ProgressLike


def _given(
    points: PointsLike,
    normals: Optional[npt.ArrayLike],
    loops: Optional[LoopsLike],
    reference: Optional[ReferenceLike] = None,
) -> dict[str, Any]:
    """What may come with the points; the normals and the raster of a Cloud are its own."""
    given: dict[str, Any] = {}
    if isinstance(points, Cloud) and {"column", "row"} <= set(points.columns):
        cells = {name: points.columns[name] for name in ("column", "row", "scan") if name in points.columns}
        given["raster"] = file_columns(cells)
    if normals is None and isinstance(points, Cloud):
        normals = points.normals
    if normals is not None:
        given["normals"] = as_rows(normals, 3, "normals")
    if loops is not None:
        given["loops"] = as_loops(loops)
    if reference is not None:
        given["reference"] = as_reference(reference)
    return given


def _kept(points: PointsLike) -> dict[str, Any]:
    """What the result keeps of its input."""
    columns = points.columns if isinstance(points, Cloud) else {}
    return {"points": as_places(points), "columns": columns}


def _doubles(points: PointsLike, given: dict[str, Any]) -> Doubles:
    places = as_doubles(points)
    if "normals" in given and len(given["normals"]) != len(places):
        raise ValueError(f"there are {len(given['normals'])} normals for {len(places)} points")
    return places


@documented
@takes_options()
def boundary(
    points: PointsLike,
    *,
    preset: str = "default",
    seed: int = 1,
    threads: int = 0,
    memory_limit: int = 0,
    progress: ProgressLike = None,
    normals: Optional[npt.ArrayLike] = None,
    loops: Optional[LoopsLike] = None,
    up: Optional[Sequence[float]] = None,
    holes: Optional[str] = None,
    corners: Optional[Sequence[int]] = None,
    **options: Any,
) -> BoundaryResult:
    choice = chosen(boundary, preset, options | {"up": up, "holes": holes, "corners": corners})
    given = _given(points, normals, loops)
    kept = _kept(points)
    with Run(seed, threads, memory_limit, progress) as run:
        made = _core.find_boundary(_doubles(kept["points"], given), choice, run, given)
    return BoundaryResult._made(made, kept)


@documented
@takes_options()
def parameterize(
    points: PointsLike,
    *,
    preset: str = "default",
    seed: int = 1,
    threads: int = 0,
    memory_limit: int = 0,
    progress: ProgressLike = None,
    normals: Optional[npt.ArrayLike] = None,
    loops: Optional[LoopsLike] = None,
    up: Optional[Sequence[float]] = None,
    holes: Optional[str] = None,
    corners: Optional[Sequence[int]] = None,
    **options: Any,
) -> ParameterizeResult:
    choice = chosen(parameterize, preset, options | {"up": up, "holes": holes, "corners": corners})
    given = _given(points, normals, loops)
    kept = _kept(points)
    with Run(seed, threads, memory_limit, progress) as run:
        made = _core.parameterize(_doubles(kept["points"], given), choice, run, given)
    return ParameterizeResult._made(made, kept)


@documented
@takes_options()
def reconstruct(
    points: PointsLike,
    *,
    preset: str = "default",
    seed: int = 1,
    threads: int = 0,
    memory_limit: int = 0,
    progress: ProgressLike = None,
    normals: Optional[npt.ArrayLike] = None,
    loops: Optional[LoopsLike] = None,
    reference: Optional[ReferenceLike] = None,
    up: Optional[Sequence[float]] = None,
    holes: Optional[str] = None,
    corners: Optional[Sequence[int]] = None,
    **options: Any,
) -> ReconstructResult:
    choice = chosen(reconstruct, preset, options | {"up": up, "holes": holes, "corners": corners})
    given = _given(points, normals, loops, reference)
    kept = _kept(points)
    with Run(seed, threads, memory_limit, progress) as run:
        made = _core.reconstruct(_doubles(kept["points"], given), choice, run, given)
    return ReconstructResult._made(made, kept)

