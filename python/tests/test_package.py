# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel: where it is, how large, what it carries, how long it takes to import; docstrings and stubs."""
from __future__ import annotations

import importlib.metadata
import inspect
import os
import pathlib
import re
import subprocess
import sys
import tarfile
from collections.abc import Callable

import pytest
import rimline

Figure = Callable[[str], None]
FUNCTIONS = [getattr(rimline, name) for name in rimline.__all__ if inspect.isfunction(getattr(rimline, name))]
RESULTS = [rimline.BoundaryResult, rimline.ParameterizeResult, rimline.ReconstructResult, rimline.Cloud, rimline.Loop]


def test_it_is_the_installed_wheel_that_is_tested() -> None:
    assert pathlib.Path(rimline.__file__).is_relative_to(sys.prefix)
    assert importlib.metadata.version("rimline") == rimline.__version__


def test_it_carries_what_it_needs_and_no_more() -> None:
    if "RIMLINE_WHEEL" not in os.environ:
        pytest.skip("RIMLINE_WHEEL names no repaired wheel")
    core = next(pathlib.Path(rimline.__file__).parent.glob("_core*.so"))
    loaded = subprocess.run(["ldd", core], capture_output=True, text=True, check=True).stdout
    system = r"linux-vdso|/ld-linux|lib(stdc\+\+|m|gcc_s|c|pthread|dl|rt|z)\.so"
    others = [line.split()[-2] for line in loaded.splitlines() if not re.search(system, line)]
    assert others and all("rimline.libs" in path for path in others), others


def test_size(figure: Figure) -> None:
    if "RIMLINE_WHEEL" not in os.environ:
        pytest.skip("RIMLINE_WHEEL names no repaired wheel")
    size = os.stat(os.environ["RIMLINE_WHEEL"]).st_size
    figure(f"the wheel has {size / 1e6:.2f} MB (aim: 3 MB)")
    assert size < 6_000_000


def test_import_time(figure: Figure) -> None:
    """The figure is printed; only far more than the aim is a failure."""
    code = "import time, numpy; a = time.perf_counter(); import rimline; print(time.perf_counter() - a)"
    took = min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
               for _ in range(5))
    figure(f"import rimline takes {1000 * took:.0f} ms after NumPy (aim: 100 ms)")
    assert took < 2


def test_nothing_large_is_imported() -> None:
    code = "import sys, rimline; print(*sys.modules)"
    modules = set(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split())
    assert not modules & {"matplotlib", "pandas", "pyvista", "vtk", "trimesh", "open3d", "scipy", "tqdm"}


def test_licences_are_in_the_wheel() -> None:
    files = {pathlib.Path(str(f)).name: f for f in importlib.metadata.files("rimline") or []}
    assert {"LICENSE", "THIRD-PARTY.md", "Apache-2.0.txt", "LGPL-3.0.txt", "MPL-2.0.txt"} <= set(files)
    notices = files["THIRD-PARTY.md"].read_text()
    for part in ("CGAL", "GMP", "MPFR", "oneTBB", "fmt", "Eigen", "Boost", "nlohmann", "fast_float", "nanobind"):
        assert part in notices
    assert "source" in notices


def test_every_library_that_is_bundled_has_its_notice() -> None:
    bundled = [p for p in importlib.metadata.files("rimline") or [] if ".libs/" in str(p)]
    notices = next(f for f in importlib.metadata.files("rimline") or [] if str(f).endswith("THIRD-PARTY.md")).read_text()
    for library in bundled:
        name = re.split(r"[-.]", pathlib.Path(str(library)).name)[0]
        assert f"`{name}" in notices, f"{name} is in the wheel and not in THIRD-PARTY.md"


def test_every_crate_has_its_notice(source: pathlib.Path) -> None:
    """Those that are compiled in on Linux: named in the manifests of what reads scans, or needed by them."""
    build_only = {"autocfg", "cc", "find-msvc-tools", "proc-macro2", "quote", "rustversion", "shlex", "syn",
                  "thiserror-impl", "unicode-ident", "rimline-scan-formats"}
    elsewhere = re.compile("windows|android|wasm|js-sys|haiku|core-foundation|bumpalo|futures|pin-project|slab|libc|cfg-if")
    text = (source / "src/io/scan_formats/Cargo.lock").read_text()
    crates = {name for name in re.findall(r'^name = "(.*)"', text, re.M) if not elsewhere.search(name)} - build_only
    notices = (source / "python/licenses/THIRD-PARTY.md").read_text()
    assert crates and not {name for name in crates if f"`{name}` (Rust)" not in notices}


def test_the_sdist_has_all_sources(source: pathlib.Path) -> None:
    if "RIMLINE_SDIST" not in os.environ:
        pytest.skip("RIMLINE_SDIST names no sdist")
    with tarfile.open(os.environ["RIMLINE_SDIST"]) as archive:
        inside = {name.partition("/")[2] for name in archive.getnames()}
    listed = subprocess.run(
        ["git", "-C", source, "ls-files", "src", "include", "cmake", "python", "cli", "CMakeLists.txt", "LICENSE"],
        capture_output=True, text=True,
    )
    if listed.returncode != 0:
        pytest.skip("the sources are not a git repository")
    assert not set(listed.stdout.split()) - inside


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.__name__)
def test_docstrings_tell_each_parameter_once(function: object) -> None:
    doc = inspect.getdoc(function) or ""
    summary, _, rest = doc.partition("\n")
    assert summary.endswith("."), doc
    part = re.search(r"Parameters\n-+\n(.*?)(?:\n\n[A-Z]\w+\n-+|\Z)", doc, re.S)
    names = list(inspect.signature(function).parameters)  # type: ignore[arg-type]
    told = re.findall(r"^([\w, ]+) : ", part[1], re.M) if part else []
    assert sorted(name for line in told for name in line.split(", ")) == sorted(names)


@pytest.mark.parametrize("result", RESULTS, ids=lambda r: r.__name__)
def test_docstrings_tell_each_attribute(result: type) -> None:
    doc = inspect.getdoc(result) or ""
    for name in result.__annotations__:
        assert re.search(rf"^{name} : .+\n    \S", doc, re.M), f"{result.__name__}.{name}"


def test_docstrings_are_the_comments_of_the_headers(source: pathlib.Path) -> None:
    """Every sentence about a result in C++ is in Python; none is typed twice."""
    text = "\n".join(path.read_text() for path in (source / "include/rimline").glob("*.h"))
    comment = re.search(r"p_value;\s*// (.*)", text)
    assert comment and comment[1].rstrip(".") in " ".join((rimline.BoundaryResult.__doc__ or "").split()).replace("Of the", "of the")
    words = " ".join((rimline.reconstruct.__doc__ or "").split())
    fields = re.search(r'field\("map_k".*?"([^"]*)"\)', text, re.S)
    assert fields and fields[1][1:] in words


def test_repr_tells_the_story_in_a_line(mesh: rimline.ReconstructResult, holes: rimline.Sample) -> None:
    told = repr(mesh)
    assert told.startswith("<rimline.ReconstructResult: ") and "\n" not in told
    assert f"{len(mesh.points):,} points, 1 loop" in told
    assert f"{len(mesh.faces):,} triangles, Euler number 1" in told
    assert "holes)" in repr(rimline.boundary(holes.points))
    assert repr(mesh.loops[0]).startswith("<rimline.Loop: outer, ")
