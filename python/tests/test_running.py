# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads, the interpreter's lock, memory, progress, Ctrl-C."""
from __future__ import annotations

import concurrent.futures
import gc
import resource
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from typing import Optional

import numpy as np
import pytest
import rimline


def resident() -> int:
    """Bytes of memory that the process holds."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


def test_memory_and_references_over_200_calls(cap: rimline.Sample) -> None:
    points = cap.points[:500].copy()
    for _ in range(20):
        rimline.reconstruct(points, threads=1)
    gc.collect()
    references, before = sys.getrefcount(points), resident()
    kept = None
    for _ in range(200):
        kept = rimline.reconstruct(points, threads=1)
        with pytest.raises(rimline.Error):
            rimline.reconstruct(points[:1])
    assert kept is not None and np.shares_memory(kept.vertices, points)
    del kept
    gc.collect()
    assert sys.getrefcount(points) == references
    grown = resident() - before
    assert grown < 8_000_000, f"200 calls kept {grown} bytes"


def test_threads_that_call_at_once_get_the_same(cap: rimline.Sample, mesh: rimline.ReconstructResult) -> None:
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        results = list(pool.map(lambda _: rimline.reconstruct(cap.points), range(24)))
    for result in results:
        assert np.array_equal(result.faces, mesh.faces)
        assert result.uv.tobytes() == mesh.uv.tobytes()


def test_other_threads_run_meanwhile() -> None:
    """Ticks that another thread makes during a call; none if it held the interpreter's lock."""
    points = rimline.sample("wavy-saddle", 60_000, sampling="random").points
    ticks = 0
    done = threading.Event()

    def tick() -> None:
        nonlocal ticks
        while not done.is_set():
            time.sleep(0.001)
            ticks += 1

    other = threading.Thread(target=tick)
    other.start()
    before = ticks
    rimline.reconstruct(points, threads=1)
    during = ticks - before
    done.set()
    other.join()
    assert during > 5


def test_progress_tells_the_stages_in_order(cap: rimline.Sample) -> None:
    told: list[tuple[str, int, int]] = []

    def hear(stage: str, done: int, total: int) -> None:
        told.append((stage, done, total))

    rimline.reconstruct(cap.points, progress=hear)
    stages = list(dict.fromkeys(stage for stage, _, _ in told))
    order = ["arrange", "neighbours", "boundary", "survey", "loops", "refine", "measure", "write"]
    assert stages == [stage for stage in order if stage in stages]
    assert {"neighbours", "refine", "measure"} <= set(stages)
    assert all(0 <= done <= max(total, done) for _, done, total in told)


def test_false_cancels(cap: rimline.Sample) -> None:
    def hear(stage: str, done: int, total: int) -> bool:
        return stage != "refine"

    with pytest.raises(rimline.Error) as caught:
        rimline.reconstruct(cap.points, progress=hear)
    assert caught.value.code is rimline.ErrorCode.Cancelled


def test_an_exception_of_progress_comes_out_as_itself(cap: rimline.Sample) -> None:
    class Mine(Exception):
        pass

    def hear(stage: str, done: int, total: int) -> Optional[bool]:
        if stage == "boundary":
            raise Mine("from within")
        return None

    with pytest.raises(Mine, match="from within"):
        rimline.reconstruct(cap.points, progress=hear)
    assert len(rimline.reconstruct(cap.points).loops) == 1  # and nothing is left of it


def test_progress_of_another_type(cap: rimline.Sample) -> None:
    with pytest.raises(TypeError, match="progress"):
        rimline.boundary(cap.points, progress=3)  # type: ignore[arg-type]


def test_a_bar(cap: rimline.Sample, capsys: pytest.CaptureFixture[str]) -> None:
    rimline.reconstruct(cap.points, progress=True)
    assert "neighbours" in capsys.readouterr().err


# A shell that starts the tests in the background has them ignore SIGINT, and so their children.
INTERRUPTED = """
import signal, sys, time, rimline
signal.signal(signal.SIGINT, signal.default_int_handler)
points = rimline.sample("wavy-saddle", 400_000, sampling="random").points
print("ready", flush=True)
try:
    while True:
        rimline.reconstruct(points, threads=1)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(3)
"""


@pytest.mark.parametrize("after", [0.1, 0.6, 1.5])
def test_ctrl_c_stops_a_call(after: float, figure: Callable[[str], None]) -> None:
    """Within a second, of which the figure is printed; far longer is a failure."""
    with subprocess.Popen([sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None and child.stdout.readline() == "ready\n"
        time.sleep(after)
        sent = time.perf_counter()
        child.send_signal(signal.SIGINT)
        told = child.stdout.readline()
        took = time.perf_counter() - sent
        child.stdout.read()
    assert told == "interrupted\n"
    assert child.returncode == 3
    figure(f"Ctrl-C after {after} s: KeyboardInterrupt {1000 * took:.0f} ms later")
    assert took < 20, "the call went on as if nothing had been"
