# SPDX-License-Identifier: GPL-3.0-or-later
"""Options are those of the C++ structs: names, defaults, ranges."""
from __future__ import annotations

import ast
import inspect
import pathlib
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import rimline
from rimline import _core

Tool = Callable[..., str]

OTHERS = {"up", "holes", "corners"}
RUN = {"points", "preset", "seed", "threads", "memory_limit", "progress", "normals", "loops", "reference"}


def shown(function: object) -> dict[str, object]:
    """Options in a signature, with their defaults."""
    parameters = inspect.signature(function).parameters  # type: ignore[arg-type]
    return {name: p.default for name, p in parameters.items() if name not in RUN | OTHERS}


@pytest.mark.parametrize("function", [rimline.boundary, rimline.parameterize, rimline.reconstruct])
def test_the_signature_has_every_option_that_the_report_has_with_its_default(
    function: object, mesh: rimline.ReconstructResult
) -> None:
    reported = {k: v for k, v in mesh.report["options"].items() if k not in OTHERS | {"preset"}}
    assert {name: shown(function)[name] for name in reported} == reported


def test_defaults_and_ranges_are_those_that_the_tool_tells(tool: Tool) -> None:
    text = " ".join(tool("reconstruct", "--help").split())
    for field in _core.fields():
        flag = "--" + field["name"].replace("_", "-")
        told = re.search(rf"{flag} .*?Default ([^ ;]+?)[.;]( |$)", text)
        assert told is not None, flag
        if field["type"] == "bool":
            assert (told[1] == "on") == field["default"]
        elif field["type"] == "choice":
            assert told[1] in {rimline.options(preset)[field["name"]] for preset in _core.presets()}
            assert f"One of {', '.join(field['choices'])}." in told[0]
        elif "word" in field:
            assert told[1] == field["default"]
        else:
            assert float(told[1]) == field["default"]
            bounds = re.search(r"From (\S+) to (\S+)\. (Of|Default)", told[0])
            assert bounds is not None, flag
            assert (float(bounds[1]), float(bounds[2])) == (field["least"], field["most"])


def test_presets_have_the_defaults_of_the_library(cap: rimline.Sample) -> None:
    for preset in _core.presets():
        given: dict[str, Any] = {} if preset == "default" else {"generations": 3}
        reported = rimline.boundary(cap.points, preset=preset, **given).report["options"]
        expected = rimline.options(preset) | given
        assert {name: reported[name] for name in expected if name in reported} == {
            name: value for name, value in expected.items() if name in reported
        }
        assert reported["preset"] == preset


def test_every_option_reaches_the_library(cap: rimline.Sample) -> None:
    given: dict[str, Any] = {"k": 30, "min_loop": 8, "domain": "square", "residual": 1e-8, "fill_points": True}
    reported = rimline.reconstruct(cap.points, up=(0, 0, -1), holes="fill:7", **given).report["options"]
    assert {name: reported[name] for name in given} == given
    assert reported["up"] == [0, 0, -1]
    assert reported["holes"] == "fill:7"


def ends() -> list[tuple[str, object]]:
    out: list[tuple[str, object]] = []
    for field in _core.fields():
        if "least" in field and "word" not in field:
            out += [(field["name"], field["least"] - 1), (field["name"], field["most"] + max(1, field["most"]))]
    return out


@pytest.mark.parametrize("name, value", ends())
def test_what_is_out_of_range_is_refused_by_name(name: str, value: object, cap: rimline.Sample) -> None:
    with pytest.raises(rimline.Error, match=f"{name} is .*; it must lie between") as caught:
        rimline.boundary(cap.points, **{name: value})  # type: ignore[arg-type]
    assert caught.value.code is rimline.ErrorCode.BadOption


@pytest.mark.parametrize("name, value", [("k", "forty"), ("k", 4.5), ("k", True), ("significance", "x"), ("domain", 3)])
def test_another_type_is_a_type_error(name: str, value: object, cap: rimline.Sample) -> None:
    with pytest.raises(TypeError, match=name):
        rimline.boundary(cap.points, **{name: value})  # type: ignore[arg-type]


def test_an_option_that_there_is_not_is_a_type_error(cap: rimline.Sample) -> None:
    with pytest.raises(TypeError, match="no option 'kk'"):
        rimline.boundary(cap.points, kk=3)  # type: ignore[call-arg]
    neighbours = rimline.find_neighbours(cap.points, 40)
    with pytest.raises(TypeError, match="no option 'domain'"):
        rimline.score_boundary(cap.points, neighbours, domain="free")  # type: ignore[call-arg]


def test_integers_of_numpy_are_integers(cap: rimline.Sample) -> None:
    result = rimline.boundary(cap.points, k=np.int32(30), significance=np.float32(0.25))  # type: ignore[arg-type]
    assert result.report["options"]["k"] == 30
    assert result.report["options"]["significance"] == 0.25


def test_the_stub_has_the_same_options() -> None:
    stub = pathlib.Path(rimline.__file__).with_name("_methods.pyi")
    for node in ast.parse(stub.read_text()).body:
        if not isinstance(node, ast.FunctionDef):
            continue
        told = {
            argument.arg: ast.literal_eval(default)
            for argument, default in zip(node.args.kwonlyargs, node.args.kw_defaults)
            if default is not None and argument.arg not in RUN | OTHERS
        }
        assert told == shown(getattr(rimline, node.name))


@pytest.mark.parametrize(
    "wrong", [{"up": 3}, {"up": "zzz"}, {"up": [0, None, 1]}, {"holes": 3}, {"corners": 4}, {"corners": (0, 1.5, 2, 3)},
              {"preset": 1}, {"seed": 1.5}, {"seed": "1"}, {"threads": None}, {"threads": True}, {"memory_limit": 1e9},
              {"reference": 3}, {"reference": (1, 2, 3)}], ids=str)
def test_arguments_of_another_type_are_a_type_error_that_names_them(wrong: Any, cap: rimline.Sample) -> None:
    with pytest.raises(TypeError, match=next(iter(wrong))):
        rimline.reconstruct(cap.points, **wrong)


@pytest.mark.parametrize("wrong", [{"up": (0, 1)}, {"up": (1, 2, 3, 4)}, {"corners": (1, 2, 3)}], ids=str)
def test_vectors_of_another_length_are_a_value_error(wrong: Any, cap: rimline.Sample) -> None:
    with pytest.raises(ValueError, match=f"{next(iter(wrong))} must be [34] numbers"):
        rimline.reconstruct(cap.points, **wrong)


def test_vectors_may_be_arrays(cap: rimline.Sample) -> None:
    down = rimline.reconstruct(cap.points, up=np.array([0, 0, -1], np.float32))  # type: ignore[arg-type]
    assert down.report["options"]["up"] == [0, 0, -1]
    ids = cap.loops[0].points[[0, 30, 60, 90]]
    assert rimline.reconstruct(cap.points, domain="rectangle", corners=ids).report["options"]["corners"] == ids.tolist()  # type: ignore[arg-type]


def test_holes_up_and_corners_are_checked(cap: rimline.Sample) -> None:
    for wrong in ({"holes": "close"}, {"up": (0, 0, 0)}, {"corners": (0, 1, 2, 99999), "domain": "square"},
                  {"corners": (0, 1, 2, -1)}, {"corners": (0, 1, 2, 2**40)}):
        with pytest.raises(rimline.Error) as caught:
            rimline.reconstruct(cap.points, **wrong)
        assert caught.value.code is rimline.ErrorCode.BadOption
