# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads, the interpreter's lock, memory, progress, Ctrl-C."""
from __future__ import annotations

import concurrent.futures
import gc
import pathlib
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


@pytest.mark.parametrize("threads", [1, 2])
def test_memory_and_references_over_200_calls(threads: int, cap: rimline.Sample) -> None:
    points = cap.points[:500].copy()
    for _ in range(20):
        rimline.reconstruct(points, threads=threads)
    gc.collect()
    references, before = sys.getrefcount(points), resident()
    kept = None
    for _ in range(200):
        kept = rimline.reconstruct(points, threads=threads)
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


def test_false_at_the_very_end_cancels_too(cap: rimline.Sample) -> None:
    told: list[tuple[str, int, int]] = []

    def count(stage: str, done: int, total: int) -> None:
        told.append((stage, done, total))

    rimline.boundary(cap.points, progress=count)
    last, calls = told[-1][0], 0

    def refuse(stage: str, done: int, total: int) -> bool:
        nonlocal calls
        calls += 1
        return stage != last

    with pytest.raises(rimline.Error) as caught:
        rimline.boundary(cap.points, progress=refuse)
    assert caught.value.code is rimline.ErrorCode.Cancelled and calls > 1


def test_progress_is_told_in_the_thread_that_called(cap: rimline.Sample) -> None:
    threads: set[int] = set()

    def hear(stage: str, done: int, total: int) -> None:
        threads.add(threading.get_ident())

    rimline.reconstruct(cap.points, progress=hear)
    assert threads == {threading.get_ident()}


def test_a_call_within_progress(cap: rimline.Sample, mesh: rimline.ReconstructResult) -> None:
    def hear(stage: str, done: int, total: int) -> None:
        assert len(rimline.boundary(cap.points[:300]).points) == 300

    assert np.array_equal(rimline.reconstruct(cap.points, progress=hear).faces, mesh.faces)


def test_a_handler_that_raises_nothing_stops_nothing(cap: rimline.Sample, mesh: rimline.ReconstructResult) -> None:
    heard: list[int] = []
    before = signal.signal(signal.SIGUSR1, lambda number, frame: heard.append(number))
    try:
        result = rimline.reconstruct(
            cap.points, progress=lambda stage, done, total: signal.raise_signal(signal.SIGUSR1)
        )
    finally:
        signal.signal(signal.SIGUSR1, before)
    assert heard and np.array_equal(result.faces, mesh.faces)


def test_a_child_made_by_fork_can_call(cap: rimline.Sample) -> None:
    code = """
import os, rimline
points = rimline.sample("hemisphere-cap", 2000).points
expected = rimline.reconstruct(points).faces
child = os.fork()
if child == 0:
    os._exit(0 if (rimline.reconstruct(points).faces == expected).all() else 9)
assert os.waitpid(child, 0)[1] == 0
"""
    subprocess.run([sys.executable, "-W", "ignore", "-c", code], check=True, timeout=120)


# A shell that starts the tests in the background has them ignore SIGINT, and so their children.
INTERRUPTED = """
import signal, sys, time, rimline
signal.signal(signal.SIGINT, signal.default_int_handler)
points = rimline.sample("wavy-saddle", 400_000, sampling="random").points
if "{call}".startswith("rimline.read"):
    rimline.write("points.ply", points)
print("ready", flush=True)
try:
    while True:
        {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(3)
"""
CALLS = ["rimline.reconstruct(points, threads=1)", "rimline.reconstruct(points, threads=2)",
         "rimline.boundary(points)", "rimline.parameterize(points)", "rimline.reconstruct(points, domain='free')",
         "rimline.read('points.ply')", "rimline.write('points.ply', points)"]


@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("after", [0.1, 1.5])
def test_ctrl_c_stops_a_call(
    call: str, after: float, figure: Callable[[str], None], tmp_path: pathlib.Path
) -> None:
    """Within a second, of which the figure is printed; far longer is a failure."""
    code = INTERRUPTED.format(call=call)
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, cwd=tmp_path) as child:
        assert child.stdout is not None and child.stdout.readline() == "ready\n"
        time.sleep(after)
        sent = time.perf_counter()
        child.send_signal(signal.SIGINT)
        told = child.stdout.readline()
        took = time.perf_counter() - sent
        child.stdout.read()
    assert told == "interrupted\n"
    assert child.returncode == 3
    figure(f"Ctrl-C after {after} s of {call}: KeyboardInterrupt {1000 * took:.0f} ms later")
    assert took < 20, "the call went on as if nothing had been"
