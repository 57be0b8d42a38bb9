# SPDX-License-Identifier: GPL-3.0-or-later
"""Results in other packages. Skipped, by name, where one is not installed."""
from __future__ import annotations

import pathlib
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
import rimline


def test_trimesh(mesh: rimline.ReconstructResult) -> None:
    pytest.importorskip("trimesh")
    made = mesh.to_trimesh()
    assert np.array_equal(made.vertices, mesh.vertices) and np.array_equal(made.faces, mesh.faces)
    assert made.euler_number == mesh.report["mesh"]["euler_number"]
    assert made.area == pytest.approx(mesh.report["mesh"]["area"])
    assert np.array_equal(made.vertex_attributes["boundary"], mesh.boundary)


def test_open3d(mesh: rimline.ReconstructResult) -> None:
    pytest.importorskip("open3d")
    made: Any = mesh.to_open3d()
    assert np.array_equal(made.vertices, mesh.vertices) and np.array_equal(made.triangles, mesh.faces)
    assert np.array_equal(np.asarray(made.triangle_uvs), mesh.uv[mesh.faces.ravel()])


def test_pyvista(mesh: rimline.ReconstructResult) -> None:
    pytest.importorskip("pyvista")
    made = mesh.to_pyvista()
    assert made.n_cells == len(mesh.faces) and made.is_all_triangles
    assert np.array_equal(made.regular_faces, mesh.faces)
    assert made.n_open_edges == mesh.report["mesh"]["boundary_edges"]
    for name in ("probability", "boundary", "uv", "label"):
        assert len(made.point_data[name]) == made.n_points


def test_loops_as_lines(holes: rimline.Sample) -> None:
    pytest.importorskip("pyvista")
    result = rimline.boundary(holes.points)
    lines = result.to_polydata()
    assert lines.n_cells == len(result.loops)
    lengths = lines.compute_cell_sizes()["Length"]
    assert np.allclose(lengths, [loop.length for loop in result.loops])
    assert lines.cell_data["kind"].tolist() == [int(loop.kind == "hole") for loop in result.loops]
    assert np.array_equal(holes.points[lines.point_data["id"]], lines.points)


def test_no_loops_are_no_lines() -> None:
    pytest.importorskip("pyvista")
    assert rimline.boundary(rimline.sample("closed-sphere", 800).points).to_polydata().n_cells == 0


def test_the_accessor(cap: rimline.Sample, mesh: rimline.ReconstructResult) -> None:
    pyvista = pytest.importorskip("pyvista")
    import rimline.pyvista

    cloud = pyvista.PolyData(np.asarray(cap.points))
    result = cloud.rimline.reconstruct(seed=1)
    assert np.array_equal(result.faces, mesh.faces)
    assert len(cloud.rimline.boundary(min_loop=10).loops) == 1
    assert cloud.rimline.parameterize(domain="square").uv.shape == (len(cap.points), 2)
    cloud.point_data["Normals"] = np.tile([0.0, 0, -1], (len(cap.points), 1))
    assert not np.array_equal(cloud.rimline.reconstruct().faces, mesh.faces)


@pytest.mark.parametrize("order", ["import pyvista, rimline", "import rimline, pyvista", "import rimline.pyvista, pyvista"])
def test_the_accessor_is_there_after(order: str) -> None:
    pytest.importorskip("pyvista")
    code = "import warnings; warnings.simplefilter('error'); " + order
    code += "; assert hasattr(pyvista.PolyData(), 'rimline')"
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("preset", ["default", "paper-log"])
def test_plot_has_the_five_panels(preset: str, cap: rimline.Sample, tmp_path: pathlib.Path) -> None:
    pytest.importorskip("matplotlib")
    result = rimline.reconstruct(cap.points, preset=preset)
    figure = result.plot()
    titles = [axes.get_title(loc="left").strip() for axes in figure.axes]
    second = "boundary probability" if preset == "default" else "candidates"
    assert titles == ["points", second, "boundary", "map", "mesh"]
    notes = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert notes[0] == f"{result.report['points']['used']:,} points"
    assert notes[4] == f"{len(result.faces):,} triangles"
    figure.savefig(tmp_path / "plot.png")
    assert (tmp_path / "plot.png").stat().st_size > 20_000


def test_plots_of_less_have_fewer_panels(cap: rimline.Sample) -> None:
    pytest.importorskip("matplotlib")
    assert len(rimline.boundary(cap.points).plot().axes) == 3
    assert len(rimline.parameterize(cap.points).plot().axes) == 4
    bad = np.vstack([cap.points, [[np.nan, 0, 0]]])
    assert len(rimline.reconstruct(bad).plot().axes) == 5
