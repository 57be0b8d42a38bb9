# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever the array: a result, ValueError or rimline.Error, and the process lives."""
from __future__ import annotations

from typing import Any

import hypothesis.extra.numpy as arrays
import numpy as np
import numpy.typing as npt
import rimline
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

SETTINGS = settings(max_examples=150, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
TYPES: Any = st.one_of(arrays.scalar_dtypes(), st.sampled_from(["f4", "f8", ">f8", "i8", "O", "M8[s]", "S3"]).map(np.dtype))
IDS: Any = st.sampled_from([np.dtype("i4"), np.dtype("i8"), np.dtype("u8"), np.dtype("f8")])
NUMBERS = st.one_of(
    st.floats(width=64),
    st.sampled_from([0.0, -0.0, 1.0, 1e-320, 1e-160, 1e150, 1.7e308, -1.7e308, np.nan, np.inf, 0.1, 1 / 3]),
    st.integers(-2, 2).map(float),
)


def survives(call: Any, *arguments: Any, **options: Any) -> None:
    try:
        call(*arguments, **options)
    except (ValueError, rimline.Error):
        pass


@SETTINGS
@given(arrays.arrays(TYPES, arrays.array_shapes(min_dims=0, max_dims=3, max_side=12)))
def test_any_type_and_shape(array: npt.NDArray[Any]) -> None:
    survives(rimline.reconstruct, array)


@SETTINGS
@given(arrays.arrays(np.float64, st.tuples(st.integers(0, 60), st.just(3)), elements=NUMBERS))
def test_any_numbers(points: npt.NDArray[Any]) -> None:
    survives(rimline.reconstruct, points, rim_generations=3)
    survives(rimline.boundary, points, preset="paper", generations=3)


@SETTINGS
@given(st.integers(4, 80), st.integers(0, 2**32 - 1), st.sampled_from(["line", "plane", "lattice", "one place", "huge"]))
def test_any_kind_of_degenerate_cloud(count: int, seed: int, kind: str) -> None:
    points = np.random.default_rng(seed).random((count, 3))
    if kind == "line":
        points[:, 1:] = 0
    elif kind == "plane":
        points[:, 2] = 0
    elif kind == "lattice":
        points = np.round(3 * points)
    elif kind == "one place":
        points[:] = points[0]
    else:
        points *= 1e154
    survives(rimline.reconstruct, points, rim_generations=3)


@SETTINGS
@given(
    arrays.arrays(IDS, arrays.array_shapes(max_dims=2, max_side=6)),
    arrays.arrays(np.float64, st.tuples(st.integers(0, 8), st.integers(0, 4)), elements=NUMBERS),
)
def test_any_ids_and_rows_to_the_stages(ids: npt.NDArray[Any], rows: npt.NDArray[Any]) -> None:
    points = np.random.default_rng(1).random((50, 3))
    survives(rimline.loop_length, points, ids)
    survives(rimline.circle_by_chord_length, points, ids)
    survives(rimline.orient_mesh, points, ids)
    survives(rimline.find_self_intersections, points, ids)
    survives(rimline.edge_agreement, ids, ids)
    survives(rimline.measure_distortion, points, ids, np.zeros((50, 2)))
    survives(rimline.reconstruct, points, loops=[ids])
    survives(rimline.delaunay, rows)
    survives(rimline.reconstruct, points, normals=rows)
    survives(rimline.arrange, rows)


@SETTINGS
@given(st.binary(max_size=300))
def test_any_bytes_as_a_file(tmp_path_factory: Any, content: bytes) -> None:
    path = tmp_path_factory.mktemp("bytes") / "any.ply"
    path.write_bytes(content)
    survives(rimline.read, path)
    survives(rimline.read_mesh, path)
    survives(rimline.read_loops, path, 10)
