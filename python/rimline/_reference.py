# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh to measure a result against."""
from __future__ import annotations

import os
from typing import Any, Union

import numpy.typing as npt

from ._arrays import Doubles, as_doubles, as_triangles
from ._files import read_mesh
from .typing import PathLike, Triangles

#: A file, (vertices, faces), or what has both.
ReferenceLike = Union[PathLike, tuple[npt.ArrayLike, npt.ArrayLike], Any]


def as_reference(reference: ReferenceLike) -> tuple[str, Doubles, Triangles]:
    """Its name, vertices and faces."""
    name = "reference"
    if isinstance(reference, (str, os.PathLike)):
        name = os.fspath(reference)
        reference = read_mesh(reference)
    if isinstance(reference, tuple):
        vertices, faces = reference
    else:
        vertices, faces = reference.vertices, reference.faces
    return name, as_doubles(vertices, "vertices of the reference"), as_triangles(faces, "faces of the reference")
