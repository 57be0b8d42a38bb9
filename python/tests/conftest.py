# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests share. They run in an environment where the wheel is installed (scripts/wheel)."""
from __future__ import annotations

import os
import pathlib
import subprocess
from collections.abc import Callable

import pytest
import rimline


@pytest.fixture(scope="session")
def cap() -> rimline.Sample:
    """2,000 points of a cap with one loop."""
    return rimline.sample("hemisphere-cap", 2000)


@pytest.fixture(scope="session")
def holes() -> rimline.Sample:
    """2,000 points of a square with holes."""
    return rimline.sample("square-with-holes", 2000)


@pytest.fixture(scope="session")
def mesh(cap: rimline.Sample) -> rimline.ReconstructResult:
    return rimline.reconstruct(cap.points)


@pytest.fixture(scope="session")
def source() -> pathlib.Path:
    """The repository."""
    if "RIMLINE_SOURCE" not in os.environ:
        pytest.skip("RIMLINE_SOURCE names no repository")
    return pathlib.Path(os.environ["RIMLINE_SOURCE"])


class Tool:
    def __init__(self, program: str) -> None:
        self.program = program

    def __call__(self, *arguments: object) -> str:
        """What it prints."""
        run = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, check=True)
        return run.stdout


@pytest.fixture(scope="session")
def tool() -> Tool:
    """The command line tool of the same sources."""
    program = os.environ.get("RIMLINE_TOOL", "")
    if not os.access(program, os.X_OK):
        pytest.skip("RIMLINE_TOOL names no command line tool")
    return Tool(program)


@pytest.fixture
def figure(capsys: pytest.CaptureFixture[str]) -> Callable[[str], None]:
    """Prints a measurement, though the test passes."""

    def tell(text: str) -> None:
        with capsys.disabled():
            print(f"\nfigure: {text}")

    return tell
