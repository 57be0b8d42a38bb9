# SPDX-License-Identifier: GPL-3.0-or-later
"""Test data whose boundary is known exactly."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import _core
from ._arguments import as_whole
from ._arrays import MOST_POINTS
from ._docs import documented
from ._loops import Loop
from ._progress import Run
from .typing import Flags, Places, ProgressLike


@documented
@dataclass(frozen=True, eq=False)
class Sample:
    points: Places
    boundary: Flags
    near_boundary: Flags
    loops: list[Loop]

    def __repr__(self) -> str:
        loops = f"{len(self.loops)} true loop{'' if len(self.loops) == 1 else 's'}"
        return f"<rimline.Sample: {len(self.points):,} points, {loops}>"


@documented
def sample(
    shape: str,
    n: int = 10000,
    *,
    sampling: str = "blue-noise",
    noise: float = 0.0,
    seed: int = 1,
    threads: int = 0,
    progress: ProgressLike = None,
) -> Sample:
    with Run(seed, threads, 0, progress) as run:
        points, boundary, near, loops = _core.sample(shape, as_whole("n", n, MOST_POINTS), sampling, noise, run)
    return Sample(points, boundary.view(np.bool_), near.view(np.bool_), loops)


def shapes() -> list[str]:
    """Names of the surfaces that `sample` knows."""
    return _core.shapes()


def samplings() -> list[str]:
    """Names of the ways in which `sample` takes points."""
    return _core.samplings()
