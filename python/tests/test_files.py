# SPDX-License-Identifier: GPL-3.0-or-later
"""Files: what is written is read again."""
from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
import pytest
import rimline


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_a_cloud_with_columns(kind: type[np.floating[Any]], tmp_path: pathlib.Path, cap: rimline.Sample) -> None:
    columns: dict[str, np.ndarray[Any, Any]] = {
        "intensity": np.arange(len(cap.points), dtype=np.uint16),
        "time": np.linspace(0, 1, len(cap.points)),
        "red": np.full(len(cap.points), 200, np.uint8),
        "edge": cap.boundary,
        "far": np.arange(len(cap.points)) - 5,
    }
    cloud = rimline.Cloud(cap.points.astype(kind), columns)
    rimline.write(tmp_path / "c.ply", cloud)
    again = rimline.read(tmp_path / "c.ply")
    assert again.points.dtype == kind
    assert np.array_equal(again.points, cloud.points)
    assert list(again.columns) == list(columns)
    for name, values in columns.items():
        assert np.array_equal(again.columns[name], values)
    assert again.columns["intensity"].dtype == np.uint16
    assert again.columns["far"].dtype == np.int32


@pytest.mark.parametrize("ending", ["ply", "obj", "off"])
def test_a_mesh(ending: str, tmp_path: pathlib.Path, mesh: rimline.ReconstructResult) -> None:
    path = tmp_path / f"mesh.{ending}"
    mesh.save(path)
    again = rimline.read_mesh(path)
    assert np.array_equal(again.faces, mesh.faces)
    assert np.array_equal(again.vertices, mesh.vertices)
    rimline.write(tmp_path / f"again.{ending}", again)
    assert np.array_equal(rimline.read_mesh(tmp_path / f"again.{ending}").faces, mesh.faces)


@pytest.mark.parametrize("ending", ["stl", "glb", "json", "geojson", "wkt", "csv", "dxf"])
def test_other_endings_leave_a_file(ending: str, tmp_path: pathlib.Path, mesh: rimline.ReconstructResult) -> None:
    rimline.write(tmp_path / f"out.{ending}", mesh)
    assert (tmp_path / f"out.{ending}").stat().st_size > 500


def test_loops(tmp_path: pathlib.Path, holes: rimline.Sample) -> None:
    result = rimline.boundary(holes.points)
    assert len(result.loops) > 1
    result.save(tmp_path / "loops.json")
    again = rimline.read_loops(tmp_path / "loops.json", len(holes.points))
    for before, after in zip(result.loops, again):
        assert np.array_equal(before.points, after.points)
        assert (before.kind, before.length, before.fitness) == (after.kind, after.length, after.fitness)
    with pytest.raises(rimline.Error) as caught:
        rimline.read_loops(tmp_path / "loops.json", 10)
    assert caught.value.code is rimline.ErrorCode.CannotRead


def test_loops_as_arrays_or_objects_are_the_same(cap: rimline.Sample) -> None:
    found = rimline.boundary(cap.points)
    as_objects = rimline.reconstruct(cap.points, loops=found.loops)
    as_lists = rimline.reconstruct(cap.points, loops=[loop.points.tolist() for loop in found.loops])
    assert np.array_equal(as_objects.faces, as_lists.faces)
    again = rimline.reconstruct(cap.points)
    assert np.array_equal(as_objects.loops[0].points, again.loops[0].points)


def test_a_reference(tmp_path: pathlib.Path, cap: rimline.Sample, mesh: rimline.ReconstructResult) -> None:
    mesh.save(tmp_path / "reference.ply")
    for reference in (tmp_path / "reference.ply", (mesh.vertices, mesh.faces), mesh):
        told = rimline.reconstruct(cap.points, reference=reference).report["reference"]
        assert told["edges_agree"] == 1
        assert told["hausdorff"] < 1e-12
    with pytest.raises(rimline.Error):
        rimline.reconstruct(cap.points, reference=(mesh.vertices, mesh.faces + 10**6))


def test_every_format_that_is_read_is_known_and_ply_does_all() -> None:
    by_name = {one["name"]: one for one in rimline.formats()}
    assert len(by_name) > 6
    uses = ("reads_points", "reads_faces", "writes_mesh", "writes_loops")
    assert all(by_name["PLY"][use] for use in uses)
    assert not by_name["PCD"]["writes_mesh"]


def test_names_of_files_may_be_bytes_and_must_be_names(tmp_path: pathlib.Path, cap: rimline.Sample) -> None:
    path = bytes(tmp_path / "points.ply")
    rimline.write(path, cap.points)  # type: ignore[arg-type]
    assert np.array_equal(rimline.read(path).points, cap.points)  # type: ignore[arg-type]
    for wrong in ("a\0b.ply", "\udcff.ply"):
        with pytest.raises(ValueError, match="name"):
            rimline.read(wrong)
        with pytest.raises(ValueError, match="name"):
            rimline.write(wrong, cap.points)


def test_points_go_to_ply_alone(tmp_path: pathlib.Path, cap: rimline.Sample) -> None:
    with pytest.raises(rimline.Error) as caught:
        rimline.write(tmp_path / "points.jpeg", cap.points)
    assert caught.value.code is rimline.ErrorCode.BadOption
    assert list(tmp_path.iterdir()) == []


def test_columns_of_another_length_are_refused(tmp_path: pathlib.Path, cap: rimline.Sample) -> None:
    with pytest.raises(ValueError, match="short"):
        rimline.write(tmp_path / "c.ply", rimline.Cloud(cap.points, {"short": np.zeros(3)}))
    with pytest.raises(ValueError, match="words"):
        rimline.write(tmp_path / "c.ply", rimline.Cloud(cap.points, {"words": np.full(len(cap.points), "a")}))
