# SPDX-License-Identifier: GPL-3.0-or-later
"""From points to a mesh in five lines, and a picture of every stage."""
import pathlib

import rimline

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)

points = rimline.sample("half-tunnel", 4000, noise=0.05).points
result = rimline.reconstruct(points)
print(result)
result.save(OUT / "tunnel.ply")
result.plot().savefig(OUT / "01_first_mesh.png", dpi=120)
