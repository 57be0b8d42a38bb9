# SPDX-License-Identifier: GPL-3.0-or-later
"""The tool's panels with Matplotlib: points, candidates or probability, boundary, map, mesh."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import as_doubles
from ._results import BoundaryResult, ParameterizeResult, ReconstructResult

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = npt.NDArray[Any]

MOST_EDGES = 40_000  # more of them would only blacken the drawing
NEAR, FAR = np.array([0.12, 0.27, 0.39]), np.array([0.80, 0.86, 0.90])
GREY_NEAR, GREY_FAR = np.array([0.58, 0.62, 0.66]), np.array([0.88, 0.90, 0.92])
LIKELY = np.array([0.91, 0.42, 0.05])
LOOP_COLOURS = {"outer": (0.82, 0.10, 0.26), "hole": (0.06, 0.42, 0.80)}
FRONT, BACK, SHADOW = np.array([0.93, 0.85, 0.72]), np.array([0.56, 0.66, 0.78]), np.array([0.16, 0.16, 0.20])
LIGHT = np.array([-0.37, 0.52, 0.77])  # beside the eye, above its left shoulder


@dataclass(frozen=True)
class Scene:
    """What the panels share: places seen by the camera, x to the right, y up, z toward the eye."""

    result: BoundaryResult
    places: Array
    triangles: Array
    seen: Array  # ids of points that are drawn, from the far ones to the near ones
    nearness: Array  # of these, 0 to 1
    dot: float  # area of a dot, points squared


def _arrange(result: BoundaryResult, size: float) -> Scene:
    meshed = isinstance(result, ReconstructResult)
    vertices = as_doubles(result.vertices if isinstance(result, ReconstructResult) else result.points)
    triangles = result.faces if isinstance(result, ReconstructResult) else np.empty((0, 3), np.int32)
    front = _normals(vertices, triangles).sum(axis=0) if meshed else np.zeros(3)
    view = np.array(_core.choose_view(vertices, result.loops, tuple(front), None))
    places = vertices @ view.T
    finite = np.flatnonzero(np.isfinite(places).all(axis=1))
    seen = finite[np.argsort(places[finite, 2], kind="stable")]
    depth = places[seen, 2]
    nearness = (depth - depth.min()) / max(float(np.ptp(depth)), 1e-9) if len(seen) else depth
    # Dots of a third of the spacing, if the points filled the panel evenly.
    dot = float(np.clip((0.5 * size * 72) ** 2 / max(len(seen), 1), 0.3, 20))
    return Scene(result, places, triangles, seen, nearness, dot)


def _normals(vertices: Array, triangles: Array) -> Array:
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def _mix(a: Array, b: Array, share: Array) -> Array:
    mixed: Array = a + (b - a) * np.clip(share, 0, 1)[:, None]
    return mixed


def _scatter(axes: Axes, scene: Scene, colours: Array) -> None:
    at = scene.places[scene.seen]
    axes.scatter(at[:, 0], at[:, 1], s=scene.dot, c=colours, linewidths=0, rasterized=len(at) > 20_000)


def _lines(axes: Axes, scene: Scene, places: Array) -> None:
    for loop in scene.result.loops:
        closed = places[np.append(loop.points, loop.points[0])]
        axes.plot(closed[:, 0], closed[:, 1], color=LOOP_COLOURS[loop.kind], linewidth=1.6)


def _points(axes: Axes, scene: Scene) -> str:
    _scatter(axes, scene, _mix(FAR, NEAR, scene.nearness))
    return f"{scene.result.report['points']['used']:,} points"


def _grey(scene: Scene) -> Array:
    return _mix(GREY_FAR, GREY_NEAR, scene.nearness)


def _candidates(axes: Axes, scene: Scene) -> str:
    colours = _grey(scene)
    colours[scene.result.candidate[scene.seen]] = LIKELY
    _scatter(axes, scene, colours)
    return f"{np.count_nonzero(scene.result.candidate):,} candidates"


def _probability(axes: Axes, scene: Scene) -> str:
    probability = scene.result.probability
    assert probability is not None
    share = np.nan_to_num(probability[scene.seen])
    grey = _grey(scene)
    _scatter(axes, scene, grey + (LIKELY - grey) * share[:, None])
    return f"{np.count_nonzero(probability > 0.5):,} points above 0.5"


def _boundary(axes: Axes, scene: Scene) -> str:
    _scatter(axes, scene, _grey(scene))
    _lines(axes, scene, scene.places)
    count = sum(len(loop) for loop in scene.result.loops)
    loops = len(scene.result.loops)
    return f"{loops:,} loop{'' if loops == 1 else 's'}, {count:,} points"


def _shaded(axes: Axes, corners: Array, colours: Array, edges: bool) -> None:
    from matplotlib.collections import PolyCollection

    few = edges and len(corners) * 3 // 2 <= MOST_EDGES
    line = (0.25, 0.25, 0.30, 0.5) if few else colours
    axes.add_collection(
        PolyCollection(
            list(corners), facecolors=colours, edgecolors=line, linewidths=0.15, rasterized=len(corners) > 20_000
        )
    )
    axes.autoscale_view()


def _facing(scene: Scene) -> Array:
    """Unit normals in the axes of the camera."""
    normals = _normals(scene.places, scene.triangles)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    facing: Array = normals / np.where(lengths > 0, lengths, 1)
    return facing


def _map(axes: Axes, scene: Scene) -> str:
    assert isinstance(scene.result, (ParameterizeResult, ReconstructResult))
    uv = scene.result.uv
    if len(scene.triangles):
        light = 0.25 + 0.40 * (1 + _facing(scene) @ LIGHT)
        _shaded(axes, uv[scene.triangles], _mix(SHADOW, FRONT, light), edges=True)
    else:
        axes.scatter(uv[:, 0], uv[:, 1], s=0.5 * scene.dot, color=tuple(NEAR), linewidths=0)
    _lines(axes, scene, uv)
    told = scene.result.report.get("map", {})
    return f"residual {told['residual']:.0e}" if "residual" in told else f"{np.isfinite(uv).all(axis=1).sum():,} points"


def _mesh(axes: Axes, scene: Scene) -> str:
    normals = _facing(scene)
    order = np.argsort(scene.places[scene.triangles, 2].mean(axis=1), kind="stable")
    turned = np.where(normals[:, 2:] >= 0, normals, -normals)
    base = np.where(normals[:, 2:] >= 0, FRONT, BACK)
    share = np.clip(0.30 + 0.75 * np.maximum(turned @ LIGHT, 0), 0, 1)[:, None]
    colours = SHADOW + (base - SHADOW) * share
    _shaded(axes, scene.places[scene.triangles[order]][:, :, :2], colours[order], edges=True)
    _lines(axes, scene, scene.places)
    return f"{len(scene.triangles):,} triangles"


def _panels(result: BoundaryResult) -> list[tuple[str, Callable[[Axes, Scene], str]]]:
    panels: list[tuple[str, Callable[[Axes, Scene], str]]] = [("points", _points)]
    rated = result.probability is not None
    panels.append(("boundary probability", _probability) if rated else ("candidates", _candidates))
    panels.append(("boundary", _boundary))
    if isinstance(result, (ParameterizeResult, ReconstructResult)):
        panels.append(("map", _map))
    if isinstance(result, ReconstructResult):
        panels.append(("mesh", _mesh))
    return panels


def plot(result: BoundaryResult, size: float) -> Figure:
    """All panels beside each other; the figure belongs to no window."""
    from matplotlib.figure import Figure

    panels = _panels(result)
    scene = _arrange(result, size)
    figure = Figure(figsize=(size * len(panels), size * 1.15), layout="constrained")
    for axes, (title, draw) in zip(np.atleast_1d(figure.subplots(1, len(panels))), panels):
        note = draw(axes, scene)
        axes.set_title(f"{title}\n", fontsize=10, loc="left", fontweight="bold")
        axes.text(0, 1.02, note, fontsize=8, transform=axes.transAxes, color="0.35")
        axes.set_aspect("equal")
        axes.axis("off")
    return figure
