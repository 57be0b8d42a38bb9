# SPDX-License-Identifier: GPL-3.0-or-later
"""What went wrong, as a sentence, a code and the points that are the reason."""
import pathlib

import numpy as np
import rimline

OUT = pathlib.Path("out/examples")
OUT.mkdir(parents=True, exist_ok=True)


def why(error: rimline.Error) -> str:
    ids = f", points {error.ids[:5].tolist()}" if len(error.ids) else ""
    return f"{error.code.name} (exit status {error.exit_status}): {error}{ids}"


(OUT / "cut_short.ply").write_text(
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"
)
told = []
for attempt in (
    lambda: rimline.read(OUT / "cut_short.ply"),
    lambda: rimline.reconstruct(np.zeros((2, 3))),
    lambda: rimline.reconstruct(rimline.sample("hemisphere-cap", 500).points, loops=[[0, 1, 1000]]),
    lambda: rimline.boundary(rimline.sample("hemisphere-cap", 500).points, k=0),
):
    try:
        attempt()
    except rimline.Error as error:
        told.append(why(error))
        print(told[-1])
assert len(told) == 4
