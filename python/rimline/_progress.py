# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a call has come, and what else every call takes."""
from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, Optional

from . import _core
from ._arguments import as_whole
from .typing import ProgressLike

MOST_THREADS = 1024


class Bar:
    """One bar for all stages: tqdm's where it is installed, else a line on standard error."""

    def __init__(self) -> None:
        self._tqdm: Any = None
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return
        self._tqdm = tqdm(total=1, bar_format="{desc:<13} {bar} {percentage:3.0f} %", leave=False)

    def __call__(self, stage: str, done: int, total: int) -> None:
        if self._tqdm is not None:
            self._tqdm.set_description_str(stage, refresh=False)
            self._tqdm.total = max(total, 1)
            self._tqdm.n = min(done, self._tqdm.total)
            self._tqdm.refresh()
        else:
            share = f"{100 * min(done, total) / total:3.0f} %" if total else ""
            sys.stderr.write(f"\r\033[K{stage:<13} {share}")
            sys.stderr.flush()

    def close(self) -> None:
        """Leaves nothing on the screen."""
        if self._tqdm is not None:
            self._tqdm.close()
        else:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()


class Run:
    """What rimline::Run holds, for the time of one call: `with Run(...) as run`."""

    def __init__(
        self, seed: int = 1, threads: int = 0, memory_limit: int = 0, progress: ProgressLike = None
    ) -> None:
        seed = as_whole("seed", seed, 2**64 - 1)
        threads = as_whole("threads", threads, MOST_THREADS)
        memory_limit = as_whole("memory_limit", memory_limit, 2**63 - 1)
        self._bar: Optional[Bar] = None
        hear: Optional[Callable[[str, int, int], Optional[bool]]] = None
        if progress is True:
            hear = self._bar = Bar()
        elif callable(progress):
            hear = progress
        elif progress not in (None, False):
            raise TypeError("progress must be True, False, None or a callable (stage, done, total)")
        self._run = _core.Run(seed, threads, memory_limit, hear)

    def __enter__(self) -> _core.Run:
        return self._run

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()
