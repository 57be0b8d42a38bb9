# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes first_steps.ipynb of the first three scripts: their docstrings as text, the rest as code.

    python examples/python/make_notebook.py [FILE]
"""
import ast
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
SCRIPTS = ["01_first_mesh.py", "02_probability_in_pyvista.py", "03_holes_filled_or_kept.py"]
SHOW = "from IPython.display import Image\n\nImage(OUT / {picture!r})"


def cells(script: str) -> list[dict[str, object]]:
    """Text and code of one script, and its picture."""
    tree = ast.parse((HERE / script).read_text())
    lines = (HERE / script).read_text().splitlines()
    code = "\n".join(lines[tree.body[0].end_lineno :]).strip("\n")
    name = script[:2]
    made = [("markdown", f"## {ast.get_docstring(tree)}"), ("code", code)]
    made.append(("code", SHOW.format(picture=script.replace(".py", ".png"))))
    return [cell(kind, text, f"{name}-{i}") for i, (kind, text) in enumerate(made)]


def cell(kind: str, text: str, name: str) -> dict[str, object]:
    """As nbformat 4.5 writes it."""
    made: dict[str, object] = {"cell_type": kind, "id": name, "metadata": {}, "source": text.splitlines(keepends=True)}
    return made if kind == "markdown" else made | {"execution_count": None, "outputs": []}


def notebook() -> str:
    title = "# rimline: first steps\n\nMade of the scripts beside it by `make_notebook.py`."
    made = [cell("markdown", title, "title")]
    for script in SCRIPTS:
        made += cells(script)
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    whole = {"cells": made, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(whole, indent=1) + "\n"


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "first_steps.ipynb"
    target.write_text(notebook())
