# SPDX-License-Identifier: GPL-3.0-or-later
"""Loops of a boundary."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ._arrays import as_ids
from ._docs import documented
from .typing import Ids, LoopsLike


@documented
@dataclass(frozen=True, eq=False)
class Loop:
    points: Ids
    kind: Literal["outer", "hole"] = "outer"
    length: float = 0.0
    fitness: float = 0.0
    component: int = 0
    probability: float = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", as_ids(self.points, "points of a loop"))

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return (
            f"<rimline.Loop: {self.kind}, {len(self):,} points, length {self.length:.6g}, "
            f"probability {self.probability:.3g}>"
        )


def as_loops(loops: LoopsLike) -> list[Loop]:
    """Of loops, or of arrays of ids."""
    return [loop if isinstance(loop, Loop) else Loop(as_ids(loop, "a loop")) for loop in loops]
