# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary loops, a map to the plane and a mesh of a point cloud of an open surface.

    >>> import rimline
    >>> result = rimline.reconstruct(points)
    >>> result.loops, result.vertices, result.faces, result.uv

Options are keyword arguments (`rimline.options()`), errors are `rimline.Error` with `code` and `ids`.
"""
from __future__ import annotations

from . import typing
from ._core import version as __version__
from ._core import (
    Arrangement,
    BoundaryScores,
    BoundaryLoops,
    DiscMap,
    ErrorCode,
    GeneticLoop,
    Neighbours,
    Patch,
    PointLabel,
    Surface,
)
from ._accessor import register as _register_accessor
from ._errors import Error
from ._files import (
    Cloud,
    Mesh,
    formats,
    loops_to_json,
    read,
    read_cloud,
    read_loops,
    read_mesh,
    write,
    write_cloud,
    write_loops,
    write_mesh,
)
from ._loops import Loop
from ._methods import boundary, parameterize, reconstruct
from ._options import options
from ._results import BoundaryResult, Distortion, ParameterizeResult, ReconstructResult
from ._sample import Sample, sample, samplings, shapes
from ._stages import (
    arrange,
    circle_by_chord_length,
    delaunay,
    edge_agreement,
    estimate_memory,
    find_boundary_loops,
    find_genetic_loop,
    find_neighbours,
    find_self_intersections,
    fitness,
    leave_out_stray,
    local_spacing,
    loop_length,
    map_to_disc,
    measure_distortion,
    measure_mesh,
    orient_mesh,
    p_value,
    refine_patch,
    refine_surface,
    score,
    score_boundary,
    summarize_spacing,
    surface_distance,
)

_register_accessor()

__all__ = [
    "__version__",
    "arrange",
    "Arrangement",
    "boundary",
    "BoundaryResult",
    "BoundaryScores",
    "BoundaryLoops",
    "circle_by_chord_length",
    "Cloud",
    "delaunay",
    "DiscMap",
    "Distortion",
    "edge_agreement",
    "Error",
    "ErrorCode",
    "estimate_memory",
    "find_boundary_loops",
    "find_genetic_loop",
    "find_neighbours",
    "find_self_intersections",
    "fitness",
    "formats",
    "GeneticLoop",
    "leave_out_stray",
    "local_spacing",
    "Loop",
    "loop_length",
    "loops_to_json",
    "map_to_disc",
    "measure_distortion",
    "measure_mesh",
    "Mesh",
    "Neighbours",
    "options",
    "orient_mesh",
    "p_value",
    "parameterize",
    "Patch",
    "ParameterizeResult",
    "PointLabel",
    "read",
    "read_cloud",
    "read_loops",
    "read_mesh",
    "reconstruct",
    "ReconstructResult",
    "refine_patch",
    "refine_surface",
    "Sample",
    "sample",
    "samplings",
    "score",
    "score_boundary",
    "shapes",
    "summarize_spacing",
    "Surface",
    "surface_distance",
    "typing",
    "write",
    "write_cloud",
    "write_loops",
    "write_mesh",
]
