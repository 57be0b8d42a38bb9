# SPDX-License-Identifier: GPL-3.0-or-later
"""Open3D's boundary flags beside our loops, on points whose boundary is known."""
import pathlib
import sys

import numpy as np
import rimline
from matplotlib.figure import Figure

try:
    import open3d
except ImportError:
    print("SKIPPED: Open3D is not installed")
    sys.exit(77)

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)

sample = rimline.sample("square-with-holes", 4000, sampling="random", noise=0.1)
points = np.asarray(sample.points)
spacing = float(rimline.local_spacing(points, rimline.find_neighbours(points, 8)).mean())

cloud = open3d.t.geometry.PointCloud(points.astype(np.float32))
cloud.estimate_normals(max_nn=30, radius=4 * spacing)
_, mask = cloud.compute_boundary_points(4 * spacing, 30, 90.0)
theirs = mask.numpy().astype(bool)
ours = rimline.boundary(points)


def score(flags: np.ndarray) -> str:
    hits = np.count_nonzero(flags & sample.boundary)
    return f"precision {hits / max(1, flags.sum()):.3f}, recall {hits / sample.boundary.sum():.3f}"


print("Open3D, flags:", score(theirs))
print("rimline, loops:", score(ours.boundary))
figure = Figure(figsize=(10, 5), layout="constrained")
for axes, flags, title in zip(figure.subplots(1, 2), (theirs, ours.boundary), ("Open3D: flags", "rimline: loops")):
    axes.scatter(*points[:, :2].T, s=1, color="0.8")
    axes.scatter(*points[flags, :2].T, s=6, color="tab:orange")
    axes.set_title(f"{title}\n{score(flags)}", fontsize=9)
    axes.set_aspect("equal")
    axes.axis("off")
for loop in ours.loops:
    closed = points[np.append(loop.points, loop.points[0])]
    figure.axes[1].plot(closed[:, 0], closed[:, 1], color="crimson", linewidth=1.5)
figure.savefig(OUT / "06_beside_open3d.png", dpi=120)
