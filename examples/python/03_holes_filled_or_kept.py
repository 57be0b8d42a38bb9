# SPDX-License-Identifier: GPL-3.0-or-later
"""The same scan with its holes kept, with the small ones filled, and with all of them filled."""
import pathlib

import numpy as np
import rimline
from matplotlib.figure import Figure

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)

points = rimline.sample("square-with-holes", 3000, noise=0.05).points
rims = sorted(len(loop) for loop in rimline.boundary(points).loops if loop.kind == "hole")
print("points on the rims of holes:", rims)

figure = Figure(figsize=(12, 4.3), layout="constrained")
for axes, holes in zip(figure.subplots(1, 3), ("keep", f"fill:{rims[0]}", "fill")):
    mesh = rimline.reconstruct(points, holes=holes, fill_points=True)
    told = mesh.report["holes"]
    print(f"{holes}: {told['kept']} kept, {told['filled']} filled by {told['fill_triangles']} triangles")
    x, y = mesh.vertices[:, 0], mesh.vertices[:, 1]
    axes.tripcolor(x, y, mesh.faces, np.asarray(mesh.filled, float), cmap="PuOr", edgecolors="0.6", linewidth=0.2)
    axes.set_title(f'holes="{holes}"')
    axes.set_aspect("equal")
    axes.axis("off")
figure.savefig(OUT / "03_holes_filled_or_kept.png", dpi=120)
