# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh to measure a result against."""
from __future__ import annotations

import os
from typing import Any, Union

import numpy.typing as npt

from ._arguments import as_path
from ._arrays import Doubles, as_doubles, as_triangles
from ._files import read_mesh
from .typing import PathLike, Triangles

#: A file, (vertices, faces), or what has both.
ReferenceLike = Union[PathLike, tuple[npt.ArrayLike, npt.ArrayLike], Any]


def as_reference(reference: ReferenceLike) -> tuple[str, Doubles, Triangles]:
    """Its name, vertices and faces."""
    name = "reference"
    if isinstance(reference, (str, os.PathLike)):
        name = as_path(reference)
        reference = read_mesh(reference)
    if isinstance(reference, tuple) and len(reference) == 2:
        vertices, faces = reference
    elif hasattr(reference, "vertices") and hasattr(reference, "faces"):
        vertices, faces = reference.vertices, reference.faces
    else:
        raise TypeError("reference must be a file, (vertices, faces), or what has both")
    return name, as_doubles(vertices, "vertices of the reference"), as_triangles(faces, "faces of the reference")
