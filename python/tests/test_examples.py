# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts of examples/python run and leave their pictures; the notebook is made of them."""
from __future__ import annotations

import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

FOLDER = pathlib.Path(os.environ.get("RIMLINE_SOURCE", "")) / "examples/python"
NEEDED = {"01": ["matplotlib"], "02": ["pyvista"], "03": ["matplotlib"], "04": ["matplotlib"], "05": ["matplotlib"],
          "06": ["matplotlib"], "07": ["matplotlib"]}
SCRIPTS = sorted(FOLDER.glob("[0-9]*.py")) if "RIMLINE_SOURCE" in os.environ else []
SKIPPED = 77  # exit status of a script that lacks a package


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda s: s.stem)
def test_script(script: pathlib.Path, tmp_path: pathlib.Path) -> None:
    for package in NEEDED.get(script.stem[:2], []):
        if importlib.util.find_spec(package) is None:
            pytest.skip(f"{package} is not installed")
    run = subprocess.run([sys.executable, script], cwd=tmp_path, capture_output=True, text=True,
                         env=os.environ | {"MPLBACKEND": "agg"})
    if run.returncode == SKIPPED:
        pytest.skip(run.stdout.strip())
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout
    picture = tmp_path / "out/examples" / f"{script.stem}.png"
    if script.stem[:2] in NEEDED:
        assert picture.stat().st_size > 5_000
    if "RIMLINE_PICTURES" in os.environ and picture.exists():
        (pathlib.Path(os.environ["RIMLINE_PICTURES"]) / picture.name).write_bytes(picture.read_bytes())


def test_there_are_scripts(source: pathlib.Path) -> None:
    assert len(SCRIPTS) >= 8


def test_the_notebook_is_made_of_the_first_three(source: pathlib.Path, tmp_path: pathlib.Path) -> None:
    subprocess.run([sys.executable, FOLDER / "make_notebook.py", tmp_path / "again.ipynb"], check=True)
    assert (tmp_path / "again.ipynb").read_text() == (FOLDER / "first_steps.ipynb").read_text()


def test_the_notebook_runs(source: pathlib.Path, tmp_path: pathlib.Path) -> None:
    for package in ("nbconvert", "ipykernel", "pyvista", "matplotlib"):
        pytest.importorskip(package)
    run = subprocess.run(
        [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", FOLDER / "first_steps.ipynb",
         "--output", tmp_path / "run.ipynb", "--ExecutePreprocessor.cwd", tmp_path],
        cwd=tmp_path, capture_output=True, text=True,
    )
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "run.ipynb").read_text().count('"image/png"') >= 3
