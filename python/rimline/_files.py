# SPDX-License-Identifier: GPL-3.0-or-later
"""Files in and out: every format that the tool has."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import as_path, as_whole
from ._arrays import MOST_POINTS, as_doubles, as_places, as_triangles
from ._docs import documented
from ._errors import Error
from ._loops import Loop, as_loops
from ._progress import Run
from .typing import LoopsLike, PathLike, Places, PointsLike, ProgressLike, Triangles


@documented
@dataclass(frozen=True, eq=False)
class Cloud:
    points: Places
    columns: dict[str, npt.NDArray[Any]] = field(default_factory=dict)
    format: str = ""

    @property
    def normals(self) -> Optional[npt.NDArray[np.float64]]:
        """(n, 3): of the columns nx, ny, nz; None where the cloud has none."""
        if not {"nx", "ny", "nz"} <= set(self.columns):
            return None
        return np.column_stack([self.columns[axis].astype(np.float64) for axis in ("nx", "ny", "nz")])

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        columns = ", ".join(self.columns) or "no other columns"
        return f"<rimline.Cloud: {len(self):,} points ({self.points.dtype}), {columns}>"


@documented
@dataclass(frozen=True, eq=False, repr=False)
class Mesh(Cloud):
    faces: Triangles = field(default_factory=lambda: as_triangles(np.empty((0, 3), np.int32)))

    @property
    def vertices(self) -> Places:
        """The points."""
        return self.points

    def __repr__(self) -> str:
        return f"<rimline.Mesh: {len(self):,} vertices, {len(self.faces):,} triangles>"


def file_columns(columns: dict[str, npt.NDArray[Any]]) -> dict[str, npt.NDArray[Any]]:
    """Columns as files hold them: integers of at most 32 bits, floats, doubles."""
    return {name: _file_column(name, np.asarray(values)) for name, values in columns.items()}


def _file_column(name: str, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
    if values.ndim != 1:
        raise ValueError(f"column {name!r} must have the shape (n,), not {values.shape}")
    kind, size = values.dtype.kind, values.dtype.itemsize
    if kind == "b":
        return np.ascontiguousarray(values).view(np.uint8)
    if kind not in "iuf":
        raise ValueError(f"column {name!r} must be real numbers, not {values.dtype}")
    if kind in "iu" and size == 8:
        fits = values.size == 0 or (int(values.min()) >= -(2**31) and int(values.max()) < 2**31)
        return np.ascontiguousarray(values, np.int32 if fits else np.float64)
    if kind == "f" and size not in (4, 8):
        return np.ascontiguousarray(values, np.float64 if size > 8 else np.float32)
    return np.ascontiguousarray(values, values.dtype.newbyteorder("="))


@documented
def read_cloud(path: PathLike, *, memory_limit: int = 0, progress: ProgressLike = None) -> Cloud:
    with Run(memory_limit=memory_limit, progress=progress) as run:
        points, columns, form = _core.read_cloud(as_path(path), run)
    return Cloud(points, columns, form)


@documented
def read_mesh(path: PathLike, *, memory_limit: int = 0, progress: ProgressLike = None) -> Mesh:
    with Run(memory_limit=memory_limit, progress=progress) as run:
        (points, columns, form), faces = _core.read_mesh(as_path(path), run)
    return Mesh(points, columns, form, faces)


@documented
def read_loops(path: PathLike, point_count: int) -> list[Loop]:
    loops: list[Loop] = _core.read_loops(as_path(path), as_whole("point_count", point_count, MOST_POINTS))
    return loops


def _parts(cloud: Union[Cloud, PointsLike]) -> tuple[Places, dict[str, npt.NDArray[Any]]]:
    return as_places(cloud), file_columns(cloud.columns if isinstance(cloud, Cloud) else {})


@documented
def write_cloud(path: PathLike, cloud: Union[Cloud, PointsLike]) -> None:
    name = as_path(path)
    if not name.lower().endswith(".ply"):
        raise Error(f"'{name}': points are written as .ply", _core.ErrorCode.BadOption)
    places, columns = _parts(cloud)
    with Run() as run:
        _core.write_cloud(name, as_doubles(places), places.dtype == np.float32, columns, run)


@documented
def write_mesh(path: PathLike, cloud: Union[Cloud, PointsLike], triangles: npt.ArrayLike) -> None:
    places, columns = _parts(cloud)
    ids = as_triangles(triangles)
    with Run() as run:
        single = places.dtype == np.float32
        _core.write_mesh(as_path(path), as_doubles(places), single, columns, ids, {}, {}, run)


@documented
def write_loops(path: PathLike, loops: LoopsLike, points: PointsLike) -> None:
    with Run() as run:
        _core.write_loops(as_path(path), as_loops(loops), as_doubles(points), run)


@documented
def loops_to_json(loops: LoopsLike, point_count: int) -> str:
    return _core.loops_to_json(as_loops(loops), point_count)


def formats() -> list[dict[str, Any]]:
    """List the file formats.

    Returns
    -------
    list of dict
        For each its name, its endings, and whether this build reads_points, reads_faces, writes_mesh, writes_loops.
    """
    made: list[dict[str, Any]] = _core.formats()
    return made


def read(path: PathLike, *, memory_limit: int = 0, progress: ProgressLike = None) -> Cloud:
    """Read the points of a file, whatever its format.

    Parameters
    ----------
    path : str or path
        In any format that `formats()` lists as read; the content tells it.
    memory_limit : int
        Most bytes that the process may hold; 0 for no limit.
    progress : bool or callable
        True for a bar; a callable (stage, done, total), False from which cancels.

    Returns
    -------
    Cloud
        The points with all their columns; faces are not read (`read_mesh` does).

    Raises
    ------
    Error
        CannotRead, with the line or byte and what to do.
    """
    return read_cloud(path, memory_limit=memory_limit, progress=progress)


def write(path: PathLike, what: Any) -> None:
    """Write points, a mesh or a result, by the ending of the file.

    Parameters
    ----------
    path : str or path
        As for `save` of a result; points alone go to .ply.
    what : result, Mesh, Cloud or array_like, shape (n, 3)
        What to write.

    Raises
    ------
    Error
        BadOption for an ending that is not known, CannotWrite where the file can not be written.
    """
    if hasattr(what, "save"):
        what.save(path)
    elif isinstance(what, Mesh):
        write_mesh(path, what, what.faces)
    else:
        write_cloud(path, what)
