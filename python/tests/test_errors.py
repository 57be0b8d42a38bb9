# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors: code, ids, pickles."""
from __future__ import annotations

import copy
import pathlib
import pickle

import numpy as np
import pytest
import rimline
from rimline import ErrorCode


def caught(code: ErrorCode, call: object, *arguments: object, **options: object) -> rimline.Error:
    with pytest.raises(rimline.Error) as error:
        call(*arguments, **options)  # type: ignore[operator]
    assert error.value.code is code
    return error.value


@pytest.mark.parametrize("count", [0, 1, 2])
def test_too_few_points(count: int) -> None:
    error = caught(ErrorCode.TooFewPoints, rimline.reconstruct, np.zeros((count, 3)) + np.arange(count)[:, None])
    assert error.exit_status == 3
    assert isinstance(error, RuntimeError)


def test_only_points_that_are_not_finite() -> None:
    caught(ErrorCode.TooFewPoints, rimline.boundary, np.full((100, 3), np.nan))


def test_a_closed_surface_has_no_loop_and_no_mesh() -> None:
    ball = rimline.sample("closed-sphere", 1000).points
    assert rimline.boundary(ball).loops == []
    with pytest.raises(rimline.Error):
        rimline.reconstruct(ball, preset="paper")


def test_ids_are_an_array_of_those_of_the_input(cap: rimline.Sample) -> None:
    error = caught(ErrorCode.BadOption, rimline.reconstruct, cap.points, loops=[[0, 1, 99999]])
    assert error.ids.dtype == np.int32
    assert error.ids.tolist() == [99999]


@pytest.mark.parametrize("wrong", [[[0, 1]], [[0, 1, 2, 1]], [[0, 1, -2]], [[]]])
def test_loops_that_are_none(wrong: list[list[int]], cap: rimline.Sample) -> None:
    caught(ErrorCode.BadOption, rimline.reconstruct, cap.points, loops=wrong)


def test_loops_of_another_type_are_a_value_error(cap: rimline.Sample) -> None:
    for wrong in ([[0.5, 1, 2]], [[2**40, 1, 2]], [["a"]], [[[1, 2, 3]]]):
        with pytest.raises(ValueError):
            rimline.reconstruct(cap.points, loops=wrong)


@pytest.mark.parametrize("how", [pickle.dumps, copy.copy, copy.deepcopy])
def test_errors_can_be_pickled_and_copied(how: object, cap: rimline.Sample) -> None:
    error = caught(ErrorCode.BadOption, rimline.reconstruct, cap.points, loops=[[0, 1, 99999]])
    again = pickle.loads(pickle.dumps(error)) if how is pickle.dumps else how(error)  # type: ignore[operator]
    assert (type(again), str(again), again.code) == (rimline.Error, str(error), error.code)
    assert np.array_equal(again.ids, error.ids)


def test_a_file_that_is_not_there(tmp_path: pathlib.Path) -> None:
    error = caught(ErrorCode.CannotRead, rimline.read, tmp_path / "none.ply")
    assert "none.ply" in str(error) and error.exit_status == 2


def test_a_file_that_can_not_be_written(tmp_path: pathlib.Path, mesh: rimline.ReconstructResult) -> None:
    caught(ErrorCode.CannotWrite, mesh.save, tmp_path / "no folder" / "mesh.ply")
    caught(ErrorCode.BadOption, mesh.save, tmp_path / "mesh.docx")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("given", [{"seed": -1}, {"seed": 2**64}, {"threads": -1}, {"threads": 10**9}, {"memory_limit": -5}])
def test_a_run_that_can_not_be(given: dict[str, int], cap: rimline.Sample) -> None:
    error = caught(ErrorCode.BadOption, rimline.boundary, cap.points, **given)
    assert next(iter(given)) in str(error)


def test_a_memory_limit_is_kept(cap: rimline.Sample) -> None:
    caught(ErrorCode.OutOfMemory, rimline.boundary, cap.points, memory_limit=1000)


def test_results_can_be_pickled(mesh: rimline.ReconstructResult) -> None:
    again = pickle.loads(pickle.dumps(mesh))
    assert np.array_equal(again.faces, mesh.faces)
    assert again.report == mesh.report
    assert repr(again) == repr(mesh)
