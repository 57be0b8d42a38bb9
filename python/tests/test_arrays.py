# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays as people have them: types, orders, strides, frames; and arrays that come out."""
from __future__ import annotations

import gc
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import rimline

Array = npt.NDArray[Any]


def every_other(points: Array) -> Array:
    wide = np.full((2 * len(points), 5), 7.0)
    wide[::2, 1:4] = points
    return wide[::2, 1:4]


LAYOUTS: dict[str, Callable[[Array], Any]] = {
    "Fortran order": np.asfortranarray,
    "every other row of a wider array": every_other,
    "reversed twice": lambda p: p[::-1].copy()[::-1],
    "big endian": lambda p: p.astype(">f8"),
    "a list of lists": lambda p: p.tolist(),
    "read only": lambda p: np.frombuffer(p.tobytes()).reshape(-1, 3),
    "a memory view": lambda p: p.data,
    "a cloud": rimline.Cloud,
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_layout_changes_nothing(layout: str, cap: rimline.Sample, mesh: rimline.ReconstructResult) -> None:
    result = rimline.reconstruct(LAYOUTS[layout](cap.points))
    assert np.array_equal(result.faces, mesh.faces)
    assert result.uv.tobytes() == mesh.uv.tobytes()


def test_float32_stays_float32_and_gives_what_its_doubles_give(cap: rimline.Sample) -> None:
    single = cap.points.astype(np.float32)
    result = rimline.reconstruct(single)
    doubles = rimline.reconstruct(single.astype(np.float64))
    assert result.vertices.dtype == np.float32
    assert np.array_equal(result.vertices, single)
    assert np.array_equal(result.faces, doubles.faces)


def test_frames_of_pandas(cap: rimline.Sample) -> None:
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"id": 5, "z": cap.points[:, 2], "y": cap.points[:, 1], "x": cap.points[:, 0]})
    assert np.array_equal(rimline.boundary(frame).boundary, rimline.boundary(cap.points).boundary)
    with pytest.raises(ValueError, match="no column x"):
        rimline.boundary(frame.drop(columns="x"))


def test_integers_are_numbers() -> None:
    grid = np.stack(np.meshgrid(np.arange(20), np.arange(20), [0]), axis=-1).reshape(-1, 3)
    result = rimline.reconstruct(grid)
    assert result.vertices.dtype == np.float64
    assert len(result.loops) == 1


def test_rows_that_are_not_finite_are_left_out_and_counted(cap: rimline.Sample) -> None:
    bad = np.insert(cap.points, [0, 100, 100], [[np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf]], axis=0)
    result = rimline.reconstruct(bad)
    assert result.report["points"]["not_finite"] == 3
    left_out = ~np.isfinite(bad).all(axis=1)
    assert np.isnan(result.uv[left_out]).all()
    assert not np.isin(np.flatnonzero(left_out), result.faces).any()
    assert len(result.boundary) == len(bad)


def test_what_a_mask_hides_is_left_out(cap: rimline.Sample) -> None:
    hidden = np.zeros_like(cap.points, dtype=bool)
    hidden[17] = True
    result = rimline.boundary(np.ma.MaskedArray(cap.points, hidden))
    assert result.report["points"]["not_finite"] == 1


@pytest.mark.parametrize(
    "wrong",
    [
        np.zeros(3),
        np.zeros((5, 2)),
        np.zeros((5, 4)),
        np.zeros((2, 5, 3)),
        np.zeros((5, 3), complex),
        np.zeros((5, 3), bool),
        [["a", "b", "c"]],
        [[1, 2, 3], [4, 5]],
        None,
        3.5,
        "points",
        {"x": 1},
    ],
    ids=str,
)
def test_a_wrong_shape_or_type_is_a_value_error(wrong: Any) -> None:
    for function in (rimline.boundary, rimline.parameterize, rimline.reconstruct, rimline.arrange):
        with pytest.raises(ValueError, match="points"):
            function(wrong)


def test_normals_must_be_as_many(cap: rimline.Sample) -> None:
    with pytest.raises(ValueError, match="normals"):
        rimline.reconstruct(cap.points, normals=cap.points[1:])
    up = rimline.reconstruct(cap.points, normals=np.tile([0.0, 0, 1], (len(cap.points), 1)))
    down = rimline.reconstruct(cap.points, normals=np.tile([0.0, 0, -1], (len(cap.points), 1)))
    assert not np.array_equal(up.faces, down.faces)


def test_results_are_the_memory_of_the_library(mesh: rimline.ReconstructResult) -> None:
    arrays = [mesh.boundary, mesh.loop, mesh.p_value, mesh.uv, mesh.faces, mesh.probability, mesh.loops[0].points]
    for array in arrays:
        owner: Any = array
        while isinstance(owner, np.ndarray):
            assert not owner.flags.owndata
            owner = owner.base
        assert type(owner).__name__ in {"memoryview", "PyCapsule"}


def test_vertices_are_the_points_that_were_given(cap: rimline.Sample) -> None:
    result = rimline.reconstruct(cap.points)
    assert np.shares_memory(result.vertices, cap.points)


def test_arrays_outlive_the_result(cap: rimline.Sample) -> None:
    result = rimline.reconstruct(cap.points)
    copy, uv = result.uv.copy(), result.uv[5:]
    del result
    gc.collect()
    rimline.reconstruct(cap.points, seed=9)  # takes the memory, were it free
    assert uv.tobytes() == copy[5:].tobytes()


def test_arrays_outlive_the_object_of_a_stage(cap: rimline.Sample) -> None:
    neighbours = rimline.find_neighbours(cap.points, 8)
    ids, copy = neighbours.ids, neighbours.ids.copy()
    assert ids.shape == (len(cap.points), 8) and not ids.flags.writeable
    del neighbours
    gc.collect()
    rimline.find_neighbours(cap.points[::-1], 8)
    assert np.array_equal(ids, copy)


def test_results_can_be_written_to(mesh: rimline.ReconstructResult) -> None:
    uv = mesh.uv[:1].copy()
    mesh.uv[:1] += 1
    assert np.array_equal(mesh.uv[:1], uv + 1)
    mesh.uv[:1] = uv
