# SPDX-License-Identifier: GPL-3.0-or-later
"""A boundary corrected by hand and meshed again: a hole that was found is taken away, and a loop of our own cuts
the surface down to a disc."""
import pathlib

import numpy as np
import rimline

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)

points = rimline.sample("square-with-holes", 3000).points
found = rimline.boundary(points)
found.save(OUT / "loops.json")  # to be edited by other hands, too

loops = rimline.read_loops(OUT / "loops.json", len(points))
longest = max((loop for loop in loops if loop.kind == "hole"), key=lambda loop: loop.length)
kept = [loop for loop in loops if loop is not longest]
mesh = rimline.reconstruct(points, loops=kept)
print(f"{len(loops)} loops were found, {len(kept)} are given: {mesh}")
assert len(mesh.loops) == len(kept)
assert {frozenset(loop.points.tolist()) for loop in mesh.loops} == {frozenset(loop.points.tolist()) for loop in kept}
assert not np.isin(longest.points[mesh.boundary[longest.points]], longest.points).any()
mesh.save(OUT / "by_hand.ply")
mesh.plot().savefig(OUT / "05_boundary_by_hand.png", dpi=120)
