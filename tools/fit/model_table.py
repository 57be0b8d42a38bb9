#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/model.md from src/base/model.h, model_search.h and model_clean.h: a row for each coefficient of the default method."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def read_headers():
    """The text of all headers that have coefficients."""
    return "".join((ROOT / "src/base" / name).read_text() for name in ("model.h", "model_search.h", "model_clean.h"))


def coefficients(text):
    """Yields (section, struct, name, value, comment) in the order of the file."""
    section, struct, comment = "", "", ""
    for line in text.splitlines():
        heading = re.match(r"// ---- (.*) ----", line)
        if heading:
            section, comment = heading[1], ""
            continue
        opened = re.match(r"struct (\w+) \{", line)
        if opened:
            struct, comment = opened[1], ""
            continue
        if line == "};":
            struct, comment = "", ""
            continue
        said = re.match(r"\s*// (.*)", line)
        if said:
            starts = not comment or comment.endswith("]")
            comment = said[1] if starts else comment + " " + said[1]
            continue
        value = re.match(r"\s*(?:inline constexpr )?(?:int|double|float|std::size_t) (\w+ = [^;]*);", line)
        if value:
            for name, number in re.findall(r"(\w+) = ([-\w.]+)", value[1]):
                yield section, struct, name, number, comment
        comment = ""


def page(text):
    lines = [
        "# The model",
        "",
        "Every coefficient of the default method, as [src/base/model.h](../src/base/model.h), model_search.h and model_clean.h have it. This page is",
        "written by `tools/fit/model_table.py`; a test compares it with the code. `tools/fit/fit` fits again those that are marked fitted, and",
        "prints them beside these.",
        "",
    ]
    last = None
    for section, struct, name, number, comment in coefficients(text):
        if (section, struct) != last:
            last = (section, struct)
            title = section + (f", `{struct}`" if struct else "")
            lines += ["", f"## {title}" if title else "## Neighbourhoods", "", "| name | value | unit | meaning | source |",
                      "|---|---|---|---|---|"]
        unit, rest = comment.split(": ", 1)
        meaning, source = re.match(r"(.*) \[(.*)\]$", rest).groups()
        lines.append(f"| `{name}` | {number} | {unit} | {meaning} | {source} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    written = page(read_headers())
    if len(sys.argv) > 1 and sys.argv[1] == "--check":
        sys.exit(written != (ROOT / "docs/model.md").read_text())
    (ROOT / "docs/model.md").write_text(written)
