# SPDX-License-Identifier: GPL-3.0-or-later
"""How sure it is that a point lies on the boundary, as colour in PyVista, with the loops as lines."""
import pathlib

import numpy as np
import pyvista
import rimline  # and clouds have cloud.rimline

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)

sample = rimline.sample("square-with-holes", 4000, sampling="random", noise=0.2)
cloud = pyvista.PolyData(np.asarray(sample.points))
result = cloud.rimline.boundary()
print(result)

plotter = pyvista.Plotter(off_screen=True, window_size=(900, 700))
plotter.add_mesh(result.to_pyvista(), scalars="probability", cmap="cividis", point_size=7)
plotter.add_mesh(result.to_polydata(), color="crimson", line_width=4)
plotter.camera_position = "xy"
plotter.screenshot(OUT / "02_probability_in_pyvista.png")
plotter.close()
