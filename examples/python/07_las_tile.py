# SPDX-License-Identifier: GPL-3.0-or-later
"""The outline of a LAS tile, as GeoJSON in the tile's own coordinates. The tile is made here, with laspy."""
import json
import pathlib
import sys

import numpy as np
import rimline

try:
    import laspy
except ImportError:
    print("SKIPPED: laspy is not installed, which makes the tile")
    sys.exit(77)
if not any(form["reads_points"] for form in rimline.formats() if "las" in form["endings"]):
    print("SKIPPED: this build of rimline reads no LAS (it was made without cargo)")
    sys.exit(77)

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)

# A square kilometre of hills around a lake without returns, at the coordinates of a map.
sample = rimline.sample("square-with-holes", 5000, sampling="random")
ground = np.asarray(sample.points)
ground = 500 * ground / np.abs(ground[:, :2]).max()
ground[:, 2] = 20 * np.sin(ground[:, 0] / 150) * np.cos(ground[:, 1] / 200)
header = laspy.LasHeader(point_format=6, version="1.4")
header.scales, header.offsets = np.full(3, 0.01), np.array([412_000, 5_650_000, 0.0])
tile = laspy.LasData(header)
tile.x, tile.y, tile.z = (ground + header.offsets).T
tile.classification = np.full(len(ground), 2, np.uint8)
tile.write(OUT / "tile.las")

cloud = rimline.read(OUT / "tile.las")
print(cloud)
result = rimline.boundary(cloud)
print(result)
result.save(OUT / "tile.geojson")
outline = json.loads((OUT / "tile.geojson").read_text())
x, y, *_ = np.array(outline["features"][0]["geometry"]["coordinates"]).T
assert 411_400 < x.min() < x.max() < 412_600 and 5_649_400 < y.min() < y.max() < 5_650_600
result.plot().savefig(OUT / "07_las_tile.png", dpi=120)
