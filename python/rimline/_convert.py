# SPDX-License-Identifier: GPL-3.0-or-later
"""Results as objects of other packages. Nothing is imported before it is asked for."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._results import BoundaryResult, ReconstructResult, array_fields

if TYPE_CHECKING:
    import open3d
    import pyvista
    import trimesh


def _with_counts(ids: npt.NDArray[Any]) -> npt.NDArray[np.int64]:
    """Triangles as VTK lists its cells: each with the number of its corners before it."""
    counts = np.full((len(ids), 1), ids.shape[1], np.int64)
    return np.hstack([counts, ids.astype(np.int64)]).ravel()


def to_pyvista(result: BoundaryResult) -> pyvista.PolyData:
    """Points, or vertices and faces, with the arrays of the result."""
    import pyvista

    if isinstance(result, ReconstructResult):
        made = pyvista.PolyData(np.asarray(result.vertices), faces=_with_counts(result.faces))
        # VTK takes no NaN for a texture coordinate.
        made.active_texture_coordinates = np.nan_to_num(result.uv)
        made.point_data["uv"] = result.uv
    else:
        made = pyvista.PolyData(np.asarray(result.points))
    for name, values in array_fields(result).items():
        made.point_data[name] = values.view(np.uint8) if values.dtype == np.bool_ else values
    return made


def loops_to_polydata(result: BoundaryResult) -> pyvista.PolyData:
    """Loops as closed polylines over their own points."""
    import pyvista

    places: list[npt.NDArray[Any]] = [np.asarray(result.points)[loop.points] for loop in result.loops]
    cells: list[int] = []
    first = 0
    for part in places:
        cells += [len(part) + 1, *range(first, first + len(part)), first]
        first += len(part)
    if not places:
        return pyvista.PolyData()
    made = pyvista.PolyData(np.concatenate(places), lines=np.array(cells, np.int64))
    made.point_data["id"] = np.concatenate([loop.points for loop in result.loops])
    made.cell_data["kind"] = np.array([loop.kind == "hole" for loop in result.loops], np.uint8)
    for name in ("length", "probability", "component"):
        made.cell_data[name] = np.array([getattr(loop, name) for loop in result.loops])
    return made


def to_trimesh(result: ReconstructResult) -> trimesh.Trimesh:
    """Vertices in their order, uv as texture coordinates."""
    import trimesh

    textured: Any = trimesh.visual.TextureVisuals
    visual = textured(uv=np.nan_to_num(result.uv))
    made = trimesh.Trimesh(np.asarray(result.vertices), result.faces, process=False, visual=visual)
    made.vertex_attributes.update(array_fields(result))
    return made


def to_open3d(result: ReconstructResult) -> open3d.geometry.TriangleMesh:
    """With vertex normals and uv at the corners of triangles."""
    import open3d

    made = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(np.asarray(result.vertices, np.float64)),
        open3d.utility.Vector3iVector(result.faces),
    )
    made.triangle_uvs = open3d.utility.Vector2dVector(result.corner_uv.reshape(-1, 2))
    made.compute_vertex_normals()
    return made
