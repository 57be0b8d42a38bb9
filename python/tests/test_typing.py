# SPDX-License-Identifier: GPL-3.0-or-later
"""mypy --strict over the tests and the package as it is installed."""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys
from collections.abc import Callable

import pytest
import rimline


Mypy = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture(scope="module")
def mypy(tmp_path_factory: pytest.TempPathFactory) -> Mypy:
    """Runs it. What it learnt of NumPy and others, most of its time, is kept from one run to the next."""
    pytest.importorskip("mypy")
    cache = tmp_path_factory.mktemp("mypy")

    def run(*arguments: object, cwd: pathlib.Path) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", "--config-file", os.devnull, "--cache-dir", cache,
             *map(str, arguments)],
            cwd=cwd, capture_output=True, text=True,
        )

    return run


def test_the_tests(mypy: Mypy, source: pathlib.Path, tmp_path: pathlib.Path) -> None:
    pytest.importorskip("pyvista")
    run = mypy(source / "python/tests", cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr


def test_the_package(mypy: Mypy, tmp_path: pathlib.Path) -> None:
    pytest.importorskip("pyvista")
    run = mypy("-p", "rimline", "--disable-error-code", "import-untyped", "--disable-error-code", "import-not-found",
               cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr


WRONG = """
import numpy as np
import rimline
from typing_extensions import assert_type
from rimline.typing import UV, Triangles

result = rimline.reconstruct(np.zeros((5, 3)), domain="free", k=30)
assert_type(result.faces, Triangles)
assert_type(result.uv, UV)
rimline.reconstruct(np.zeros((5, 3)), domain="fre")
rimline.reconstruct(np.zeros((5, 3)), neighbors=3)
rimline.reconstruct(np.zeros((5, 3)), k="x")
"""


def test_stubs_know_options_and_shapes(mypy: Mypy, tmp_path: pathlib.Path) -> None:
    (tmp_path / "wrong.py").write_text(WRONG)
    run = mypy("wrong.py", cwd=tmp_path)
    lines = [line.split(":")[1] for line in run.stdout.splitlines() if ": error:" in line]
    assert lines == ["10", "11", "12"], run.stdout
    assert (pathlib.Path(rimline.__file__).parent / "py.typed").exists()
