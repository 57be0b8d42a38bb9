# SPDX-License-Identifier: GPL-3.0-or-later
"""What the method gives, with arrays that are the library's own memory."""
from __future__ import annotations

import json
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Optional, TypeVar

import numpy as np
import numpy.typing as npt

from ._docs import documented
from ._loops import Loop
from .typing import UV, Flags, Floats, Ids, Labels, Numbers, PathLike, Places, Triangles

if TYPE_CHECKING:
    import matplotlib.figure
    import open3d
    import pyvista
    import trimesh

Made = TypeVar("Made", bound="BoundaryResult")

# C++ names of what has a shorter one here.
RENAMED = {"boundary_probability": "probability", "triangles": "faces"}
FLAGS = {"boundary", "candidate", "filled"}


def _counted(count: int, noun: str) -> str:
    return f"{count:,} {noun}{'' if count == 1 else 's'}"


@documented
@dataclass(frozen=True, eq=False, repr=False)
class Distortion:
    angle: Floats
    area: Floats
    stretch: Floats
    max_stretch: Floats


@documented
@dataclass(frozen=True, eq=False, repr=False)
class BoundaryResult:
    points: Places
    loops: list[Loop]
    boundary: Flags
    loop: Ids
    candidate: Flags
    p_value: Numbers
    score: Numbers
    probability: Optional[Floats]
    label: Optional[Labels]
    report: dict[str, Any]
    columns: dict[str, npt.NDArray[Any]] = field(repr=False)

    @classmethod
    def _made(cls: type[Made], made: dict[str, Any], kept: dict[str, Any]) -> Made:
        """Of the dictionary of _core, and what is kept of the input."""
        values = {RENAMED.get(name, name): value for name, value in made.items()}
        for name in FLAGS & set(values):
            if values[name] is not None:
                values[name] = values[name].view(np.bool_)
        for name in {"distortion", "triangle_distortion"} & set(values):
            values[name] = Distortion(**values[name])
        values["report"] = json.loads(values["report"])
        return cls(**(kept | values))

    def __repr__(self) -> str:
        return f"<rimline.{type(self).__name__}: {', '.join(self._story())}>"

    def _story(self) -> list[str]:
        """The parts of __repr__."""
        counts = self.report["points"]
        story = [_counted(counts["input"], "point")]
        if counts["used"] < counts["input"]:
            story.append(f"{counts['input'] - counts['used']:,} left out")
        holes = sum(loop.kind == "hole" for loop in self.loops)
        loops = _counted(len(self.loops), "loop")
        story.append(loops + (f" ({_counted(holes, 'hole')})" if holes else "") if self.loops else "no loop")
        on_loops = int(np.count_nonzero(self.boundary))
        story.append(f"{_counted(on_loops, 'point')} on the boundary")
        if self.report["warnings"]:
            story.append(_counted(len(self.report["warnings"]), "warning"))
        return story

    def save(self, path: PathLike) -> None:
        """Write the result, as the tool does.

        Parameters
        ----------
        path : str or path
            .ply: the points with a property for each array; .json (schema 1), .geojson, .wkt, .csv, .obj or .dxf:
            the loops.

        Raises
        ------
        Error
            BadOption for another ending, CannotWrite where the file can not be written; no half file is left.
        """
        from ._save import save_boundary

        save_boundary(self, path)

    def plot(self, *, size: float = 3.4) -> matplotlib.figure.Figure:
        """Draw what was found, stage by stage: the panels of the tool's `--picture`.

        Parameters
        ----------
        size : float
            Width and height of each panel, inches.

        Returns
        -------
        matplotlib.figure.Figure
            Points, probability (the paper's presets: candidates) and boundary; with a map and a mesh, these too.

        Raises
        ------
        ImportError
            Where Matplotlib is not installed.
        """
        from ._plot import plot

        return plot(self, size)

    def to_polydata(self) -> pyvista.PolyData:
        """Give the loops as lines.

        Returns
        -------
        pyvista.PolyData
            One closed polyline a loop over the points of the result; cell data `kind` (0 outer, 1 hole),
            `length`, `probability` and `component`.
        """
        from ._convert import loops_to_polydata

        return loops_to_polydata(self)

    def to_pyvista(self) -> pyvista.PolyData:
        """Give the points, with a point array for each array of the result.

        Returns
        -------
        pyvista.PolyData
            Vertices; of a ReconstructResult the mesh, with `uv` as texture coordinates.
        """
        from ._convert import to_pyvista

        return to_pyvista(self)


@documented
@dataclass(frozen=True, eq=False, repr=False)
class ParameterizeResult(BoundaryResult):
    uv: UV

    def _story(self) -> list[str]:
        placed = int(np.count_nonzero(np.isfinite(self.uv[:, 0])))
        return [*super()._story(), f"{placed:,} mapped"]


@documented
@dataclass(frozen=True, eq=False, repr=False)
class ReconstructResult(BoundaryResult):
    uv: UV
    added: Places
    faces: Triangles
    seam_uv: Optional[UV]
    seam_point: Optional[Ids]
    corners: Optional[Triangles]
    chart: Optional[Ids]
    patch: Optional[Ids]
    filled: Optional[Flags]
    distortion: Distortion
    triangle_distortion: Distortion

    @property
    def vertices(self) -> Places:
        """(n, 3): the points as they were given, without a copy; those that fills added follow them."""
        if len(self.added) == 0:
            return self.points
        both: Places = np.concatenate([self.points, self.added]).astype(self.points.dtype, copy=False)
        return both

    @property
    def corner_uv(self) -> npt.NDArray[np.float64]:
        """(m, 3, 2): where each corner of each triangle lies; NaN where there is no map."""
        if self.corners is None or self.seam_uv is None:
            return self.uv[self.faces]
        return np.concatenate([self.uv, self.seam_uv])[self.corners]

    def _story(self) -> list[str]:
        mesh = self.report["mesh"]
        story = super()._story()
        story.insert(3, f"{_counted(len(self.faces), 'triangle')}, Euler number {mesh['euler_number']}")
        return story

    def save(self, path: PathLike) -> None:
        """Write the mesh or the loops, as the tool does.

        Parameters
        ----------
        path : str or path
            .ply (with u, v and boundary), .obj, .off, .stl or .glb: the mesh; .json (schema 1), .geojson, .wkt,
            .csv or .dxf: the loops.

        Raises
        ------
        Error
            BadOption for another ending, CannotWrite where the file can not be written; no half file is left.
        """
        from ._save import save_mesh

        save_mesh(self, path)

    def to_trimesh(self) -> trimesh.Trimesh:
        """Give the mesh to trimesh.

        Returns
        -------
        trimesh.Trimesh
            Vertices in their order (`process=False`), `uv` as texture coordinates, and the arrays of the result
            as vertex attributes.
        """
        from ._convert import to_trimesh

        return to_trimesh(self)

    def to_open3d(self) -> open3d.geometry.TriangleMesh:
        """Give the mesh to Open3D.

        Returns
        -------
        open3d.geometry.TriangleMesh
            With vertex normals, and `uv` at each corner of a triangle.
        """
        from ._convert import to_open3d

        return to_open3d(self)


NOT_OF_POINTS = ("points", "uv", "added", "seam_point", "chart")


def array_fields(result: BoundaryResult) -> dict[str, npt.NDArray[Any]]:
    """The arrays with a value for each point, by name."""
    count = len(result.boundary)
    values = {f.name: getattr(result, f.name) for f in fields(result) if f.name not in NOT_OF_POINTS}
    return {
        name: value
        for name, value in values.items()
        if isinstance(value, np.ndarray) and value.ndim == 1 and len(value) == count and name != "filled"
    }
