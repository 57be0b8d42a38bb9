# SPDX-License-Identifier: GPL-3.0-or-later
"""A curled strip laid out flat at its own scale, a checkerboard on it, and how far lengths are off."""
import pathlib

import numpy as np
import rimline
from matplotlib.figure import Figure

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)

points = rimline.sample("curled-strip", 6000).points
mesh = rimline.reconstruct(points, domain="free")
told = mesh.report["distortion"]
print(f"stretch {told['stretch_l2']:.4f} on average (1: lengths are kept), {told['stretch_linf']:.3f} at most")

square = np.ptp(mesh.uv, axis=0).max() / 32
centres = mesh.uv[mesh.faces].mean(axis=1)
dark = np.floor(centres / square).sum(axis=1) % 2

figure = Figure(figsize=(13, 5.5), layout="constrained")
space = figure.add_subplot(1, 3, 1, projection="3d")
drawn = space.plot_trisurf(*mesh.vertices.T, triangles=mesh.faces, linewidth=0)
drawn.set_array(None)
drawn.set_facecolor(np.where(dark[:, None] > 0, (0.20, 0.35, 0.25, 1), (0.93, 0.90, 0.80, 1)))
space.set_box_aspect(np.ptp(mesh.vertices, axis=0))
space.set_axis_off()
space.set_title("in space")
u, v = mesh.uv.T
for position, colours, title in ((2, dark, "laid flat"), (3, mesh.triangle_distortion.stretch, "stretch, L2")):
    axes = figure.add_subplot(1, 3, position)
    shown = axes.tripcolor(u, v, mesh.faces, colours, cmap="cividis" if position == 3 else "Greens")
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title)
figure.colorbar(shown, ax=axes, shrink=0.6)
figure.savefig(OUT / "04_flattened_leaf.png", dpi=120)
