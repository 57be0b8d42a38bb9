# SPDX-License-Identifier: GPL-3.0-or-later
"""The same input gives the same bytes here and in the tool: loops, faces, uv, and whole files."""
from __future__ import annotations

import json
import pathlib
from collections.abc import Callable

import numpy as np
import pytest
import rimline

Tool = Callable[..., str]

SHAPES = ["hemisphere-cap", "square-with-holes", "half-tunnel"]
RUNS: list[dict[str, object]] = [
    {},
    {"seed": 7, "threads": 1},
    {"domain": "free", "k": 30},
    {"holes": "fill", "fill_points": True},
    {"preset": "paper-log", "generations": 20},
]


def flags(options: dict[str, object]) -> list[str]:
    made: list[str] = []
    for name, value in options.items():
        flag = "--" + name.replace("_", "-")
        made += [flag] if value is True else [flag, str(value)]
    return made


@pytest.fixture(scope="module", params=SHAPES)
def scan(request: pytest.FixtureRequest, tool: Tool, tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    path: pathlib.Path = tmp_path_factory.mktemp("scan") / f"{request.param}.ply"
    tool("sample", request.param, "-n", 1500, "--noise", 0.02, "-o", path, "-q")
    return path


@pytest.mark.parametrize("options", RUNS, ids=lambda o: " ".join(flags(o)) or "defaults")
def test_reconstruct(scan: pathlib.Path, options: dict[str, object], tool: Tool, tmp_path: pathlib.Path) -> None:
    theirs, report, loops = tmp_path / "tool.ply", tmp_path / "report.json", tmp_path / "loops.json"
    tool("reconstruct", scan, "-o", theirs, "--report", report, "--loops", loops, "-q", *flags(options))
    result = rimline.reconstruct(rimline.read(scan), **options)  # type: ignore[arg-type]

    expected = rimline.read_mesh(theirs)
    assert np.array_equal(result.faces, expected.faces)
    assert np.array_equal(result.vertices, expected.points)
    u_and_v = np.column_stack([expected.columns["u"], expected.columns["v"]])
    assert result.uv.tobytes() == u_and_v.tobytes()
    assert rimline.loops_to_json(result.loops, len(result.points)) == loops.read_text()
    told = json.loads(report.read_text())
    assert {k: v for k, v in told.items() if k != "run"} == {k: v for k, v in result.report.items() if k != "run"}

    mine = tmp_path / "python.ply"
    result.save(mine)
    assert mine.read_bytes() == theirs.read_bytes()


def test_boundary(scan: pathlib.Path, tool: Tool, tmp_path: pathlib.Path) -> None:
    theirs, loops = tmp_path / "tool.ply", tmp_path / "loops.json"
    tool("boundary", scan, "-o", theirs, "--loops", loops, "-q")
    result = rimline.boundary(rimline.read(scan))
    result.save(tmp_path / "python.ply")
    result.save(tmp_path / "python.json")
    assert (tmp_path / "python.ply").read_bytes() == theirs.read_bytes()
    assert (tmp_path / "python.json").read_bytes() == loops.read_bytes()


def test_a_boundary_made_by_hand(scan: pathlib.Path, tool: Tool, tmp_path: pathlib.Path) -> None:
    loops, theirs = tmp_path / "loops.json", tmp_path / "tool.obj"
    cloud = rimline.read(scan)
    found = rimline.boundary(cloud)
    found.save(loops)
    tool("reconstruct", scan, "-o", theirs, "--use-loops", loops, "-q")
    result = rimline.reconstruct(cloud, loops=rimline.read_loops(loops, len(cloud)))
    result.save(tmp_path / "python.obj")
    assert (tmp_path / "python.obj").read_bytes() == theirs.read_bytes()


def test_the_raster_of_a_scanner(tool: Tool, tmp_path: pathlib.Path) -> None:
    """A ball before a wall, seen by a scanner at the origin: columns of directions, as PTX has them."""
    azimuth, elevation = np.meshgrid(np.arange(-20, 20) / 50, np.arange(-15, 15) / 50, indexing="ij")
    seen = np.stack(
        [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)], axis=-1
    ).reshape(-1, 3)
    beside = 4 - (2 * seen[:, 0]) ** 2
    on_ball = 2 * seen[:, 0] - np.sqrt(np.maximum(0, 0.09 - beside))
    ranges = np.where(beside < 0.09, on_ball, 3 / seen[:, 0])
    scan, theirs = tmp_path / "scan.ptx", tmp_path / "tool.ply"
    head = "40\n30\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"
    scan.write_text(head + "".join(f"{x!r} {y!r} {z!r} 0.5\n" for x, y, z in (ranges[:, None] * seen).tolist()))
    tool("reconstruct", scan, "-o", theirs, "-q")
    result = rimline.reconstruct(rimline.read(scan))
    result.save(tmp_path / "python.ply")
    assert (tmp_path / "python.ply").read_bytes() == theirs.read_bytes()
    assert sorted(loop.kind for loop in result.loops) == ["hole", "outer", "outer"]


def test_samples(tool: Tool, tmp_path: pathlib.Path) -> None:
    truth = tmp_path / "truth.json"
    for shape in rimline.shapes():
        tool("sample", shape, "-n", 800, "--seed", 3, "-o", tmp_path / "s.ply", "--truth", truth, "-q")
        mine = rimline.sample(shape, 800, seed=3)
        theirs = rimline.read(tmp_path / "s.ply")
        assert mine.points.tobytes() == theirs.points.tobytes()
        assert rimline.loops_to_json(mine.loops, len(mine.points)) == truth.read_text()
