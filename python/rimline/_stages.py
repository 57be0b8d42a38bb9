# SPDX-License-Identifier: GPL-3.0-or-later
"""Every stage alone, under its C++ name. Options of a stage are keyword arguments as those of the whole method."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, Optional

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import as_whole
from ._arrays import MOST_POINTS, as_doubles, as_ids, as_numbers, as_rows, as_triangles
from ._core import Arrangement, BoundaryScores, BoundaryLoops, DiscMap, GeneticLoop, Neighbours, Patch, Surface
from ._docs import documented
from ._loops import as_loops
from ._options import chosen, takes_options
from ._progress import Run
from ._results import Distortion
from .typing import UV, LoopsLike, Numbers, PointsLike, ProgressLike, Triangles

IdPairs = np.ndarray[tuple[int, Literal[2]], np.dtype[np.int32]]
NO_ROWS = np.empty((0, 3))


@documented
def arrange(points: PointsLike, *, threads: int = 0, progress: ProgressLike = None) -> Arrangement:
    with Run(1, threads, 0, progress) as run:
        return _core.arrange(as_doubles(points), run)


@documented
def leave_out_stray(
    arrangement: Arrangement, neighbours: Neighbours, *, least_group: int = 10, threads: int = 0
) -> Arrangement:
    with Run(1, threads) as run:
        return _core.leave_out_stray(arrangement, neighbours, as_whole("least_group", least_group, MOST_POINTS), run)


@documented
def find_neighbours(
    points: PointsLike, k: int, *, threads: int = 0, progress: ProgressLike = None
) -> Neighbours:
    with Run(1, threads, 0, progress) as run:
        return _core.find_neighbours(as_doubles(points), as_whole("k", k, MOST_POINTS), run)


@documented
def local_spacing(points: PointsLike, neighbours: Neighbours, *, threads: int = 0) -> Numbers:
    with Run(1, threads) as run:
        return _core.local_spacing(as_doubles(points), neighbours, run)


@documented
def summarize_spacing(spacing: npt.ArrayLike) -> dict[str, float]:
    return _core.summarize_spacing(as_numbers(spacing, "spacing"))


@documented
@takes_options("boundary")
def score_boundary(
    points: PointsLike,
    neighbours: Neighbours,
    *,
    preset: str = "default",
    threads: int = 0,
    progress: ProgressLike = None,
    **options: Any,
) -> BoundaryScores:
    with Run(1, threads, 0, progress) as run:
        return _core.score_boundary(as_doubles(points), neighbours, chosen(score_boundary, preset, options), run)


@documented
def p_value(log_score: float) -> float:
    return _core.p_value(log_score)


@documented
def score(log_score: float, form: str = "log") -> float:
    return _core.score(log_score, form)


@documented
@takes_options("boundary_loops", "length_exponent")
def find_boundary_loops(
    points: PointsLike,
    neighbours: Neighbours,
    scores: BoundaryScores,
    *,
    preset: str = "default",
    seed: int = 1,
    threads: int = 0,
    progress: ProgressLike = None,
    **options: Any,
) -> BoundaryLoops:
    with Run(seed, threads, 0, progress) as run:
        return _core.find_boundary_loops(as_doubles(points), neighbours, scores, chosen(find_boundary_loops, preset, options), run)


@documented
@takes_options("loops")
def find_genetic_loop(
    points: PointsLike,
    neighbours: Neighbours,
    scores: BoundaryScores,
    *,
    preset: str = "paper",
    seed: int = 1,
    threads: int = 0,
    progress: ProgressLike = None,
    **options: Any,
) -> GeneticLoop:
    with Run(seed, threads, 0, progress) as run:
        return _core.find_genetic_loop(as_doubles(points), neighbours, scores, chosen(find_genetic_loop, preset, options), run)


@documented
@takes_options("loops")
def fitness(ids: npt.ArrayLike, scores: BoundaryScores, *, preset: str = "paper-log", **options: Any) -> float:
    return _core.fitness(as_ids(ids, "ids"), scores, chosen(fitness, preset, options))


@documented
def loop_length(points: PointsLike, loop: npt.ArrayLike) -> float:
    return _core.loop_length(as_doubles(points), as_ids(loop, "loop"))


@documented
def circle_by_chord_length(points: PointsLike, loop: npt.ArrayLike) -> UV:
    return _core.circle_by_chord_length(as_doubles(points), as_ids(loop, "loop"))


@documented
@takes_options("map")
def map_to_disc(
    points: PointsLike,
    neighbours: Neighbours,
    loop: npt.ArrayLike,
    *,
    preset: str = "paper-log",
    threads: int = 0,
    progress: ProgressLike = None,
    **options: Any,
) -> DiscMap:
    with Run(1, threads, 0, progress) as run:
        ids = as_ids(loop, "loop")
        return _core.map_to_disc(as_doubles(points), neighbours, ids, chosen(map_to_disc, preset, options), run)


@documented
def delaunay(uv: npt.ArrayLike, *, threads: int = 0, progress: ProgressLike = None) -> Triangles:
    with Run(1, threads, 0, progress) as run:
        return _core.delaunay(as_rows(uv, 2, "uv"), run)


@documented
def orient_mesh(
    points: PointsLike,
    triangles: npt.ArrayLike,
    *,
    normals: Optional[npt.ArrayLike] = None,
    up: Sequence[float] = (0.0, 0.0, 1.0),
) -> tuple[Triangles, bool]:
    facing = NO_ROWS if normals is None else as_rows(normals, 3, "normals")
    return _core.orient_mesh(as_doubles(points), as_triangles(triangles), facing, chosen(orient_mesh, "default", {"up": up}))


@documented
@takes_options("map", "mesh")
def refine_patch(
    points: PointsLike,
    neighbours: Neighbours,
    loops: LoopsLike,
    *,
    preset: str = "default",
    threads: int = 0,
    progress: ProgressLike = None,
    holes: Optional[str] = None,
    corners: Optional[Sequence[int]] = None,
    **options: Any,
) -> Patch:
    choice = chosen(refine_patch, preset, options | {"holes": holes, "corners": corners})
    with Run(1, threads, 0, progress) as run:
        return _core.refine_patch(as_doubles(points), neighbours, as_loops(loops), choice, run)


@documented
@takes_options("map", "mesh")
def refine_surface(
    points: PointsLike,
    neighbours: Neighbours,
    loops: LoopsLike,
    surface_triangles: npt.ArrayLike = (),
    *,
    leave_beside: bool = False,
    preset: str = "default",
    threads: int = 0,
    progress: ProgressLike = None,
    holes: Optional[str] = None,
    corners: Optional[Sequence[int]] = None,
    **options: Any,
) -> Surface:
    choice = chosen(refine_surface, preset, options | {"holes": holes, "corners": corners})
    ids = as_triangles(np.reshape(surface_triangles, (-1, 3)), "surface_triangles")
    with Run(1, threads, 0, progress) as run:
        return _core.refine_surface(
            as_doubles(points), neighbours, as_loops(loops), ids, leave_beside, choice, run
        )


@documented
def measure_mesh(
    points: PointsLike,
    triangles: npt.ArrayLike,
    spacing: npt.ArrayLike,
    uv: Optional[npt.ArrayLike] = None,
    *,
    threads: int = 0,
) -> dict[str, float]:
    places = as_rows(np.empty((0, 2)) if uv is None else uv, 2, "uv")
    with Run(1, threads) as run:
        return _core.measure_mesh(
            as_doubles(points), as_triangles(triangles), as_numbers(spacing, "spacing"), places, run
        )


@documented
def measure_distortion(
    points: PointsLike, triangles: npt.ArrayLike, uv: npt.ArrayLike, *, threads: int = 0
) -> tuple[dict[str, float], Distortion, Distortion]:
    with Run(1, threads) as run:
        whole, of_triangles, of_points = _core.measure_distortion(
            as_doubles(points), as_triangles(triangles), as_rows(uv, 2, "uv"), run
        )
    return whole, Distortion(**of_triangles), Distortion(**of_points)


@documented
def find_self_intersections(points: PointsLike, triangles: npt.ArrayLike, *, threads: int = 0) -> IdPairs:
    with Run(1, threads) as run:
        return _core.find_self_intersections(as_doubles(points), as_triangles(triangles), run)


@documented
def edge_agreement(a: npt.ArrayLike, b: npt.ArrayLike) -> float:
    return _core.edge_agreement(as_triangles(a, "a"), as_triangles(b, "b"))


def surface_distance(
    points: PointsLike,
    triangles: npt.ArrayLike,
    other_points: PointsLike,
    other_triangles: npt.ArrayLike,
    *,
    threads: int = 0,
) -> dict[str, float]:
    """Measure how far a mesh lies from another one (SurfaceDistance in C++).

    Parameters
    ----------
    points, other_points : array_like, shape (n, 3)
        Vertices, in one unit.
    triangles, other_triangles : array_like of int, shape (m, 3)
        Ids of vertices.
    threads : int
        Most threads used at once; 0 takes all cores.

    Returns
    -------
    dict
        mean, rms and most of the distances from vertices, middles of edges and centres of triangles to the nearest
        point of the other mesh, in the unit of the points.

    Raises
    ------
    Error
        BadOption, where the other mesh has no triangles.
    """
    with Run(1, threads) as run:
        return _core.surface_distance(
            as_doubles(points),
            as_triangles(triangles),
            as_doubles(other_points, "other_points"),
            as_triangles(other_triangles, "other_triangles"),
            run,
        )


@documented
@takes_options()
def estimate_memory(points: int, *, preset: str = "default", **options: Any) -> dict[str, int]:
    return _core.estimate_memory(as_whole("points", points, MOST_POINTS), chosen(estimate_memory, preset, options))
