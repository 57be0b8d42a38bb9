#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the numbers of rimline_quality agree with those of the ruler that came with the data?

    check_score.py PROGRAM [SET ...]

Runs PROGRAM over the named sets of the folder RIMLINE_DATA (all but the largest where none is named), has
score.py judge the loops and meshes that it wrote, and compares every number that both have. Status 77 (skipped)
where there is no data, no ruler or no numpy. The ruler is RIMLINE_SCORE, or ../tools/score.py beside the data.
"""
import importlib.util
import json
import math
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
TOLERANCE = {"length": 1e-5}  # score.py rounds to as many digits
OTHERWISE = 1.01e-4


def skip(why):
    print("skipped:", why)
    sys.exit(SKIPPED)


def load_ruler(data):
    path = os.environ.get("RIMLINE_SCORE", os.path.join(data.split(":")[0], "..", "tools", "score.py"))
    if not os.path.exists(path):
        skip("no score.py")
    try:
        spec = importlib.util.spec_from_file_location("score", path)
        ruler = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(ruler)
    except ImportError as error:
        skip(error)
    return ruler


def truth_of(data, name, endings):
    paths = (os.path.join(folder, name + ending) for folder in data.split(":") for ending in endings)
    return next((p for p in paths if os.path.exists(p)), None)


def close(ours, theirs, key):
    tolerance = TOLERANCE.get(key, OTHERWISE) * max(1.0, abs(theirs))
    return math.isclose(ours, theirs, rel_tol=0, abs_tol=tolerance)


def compare(label, ours, theirs):
    """Number of values compared, and the lines that differ."""
    count, wrong = 0, []
    theirs = dict(theirs)
    for i, value in enumerate(theirs.pop("longest_loops_covered", ())):
        theirs[f"longest_loop_{i + 1}"] = value
    for key, value in theirs.items():
        if key not in ours or not isinstance(value, (int, float)):
            continue
        count += 1
        tolerance = 6e-4 if key.startswith("longest_loop_") else None  # three digits
        same = abs(ours[key] - value) <= tolerance if tolerance else close(ours[key], float(value), key)
        if not same:
            wrong.append(f"{label}: {key} is {ours[key]}, score.py has {value}")
    return count, wrong


def main():
    program, sets = sys.argv[1], sys.argv[2:]
    data = os.environ.get("RIMLINE_DATA") or skip("RIMLINE_DATA is not set")
    ruler = load_ruler(data)
    count, wrong = 0, []
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "results.json")
        command = [program, "--data", data, "--no-analytic", "--write", folder, "--out", out, "--markdown",
                   os.path.join(folder, "page.md")]
        if sets:
            command += ["--cases", ",".join("data/" + s for s in sets)]
        command += ["--methods", "default,paper-log"]
        subprocess.run(command, check=True)
        with open(out) as f:
            rows = json.load(f)["rows"]
        for row in rows:
            name = row["shape"]
            stem = os.path.join(folder, f"{name}.{row['method']}")
            points = truth_of(data, name, (".ply",))
            for part, file, endings, judge in (
                    ("loops", stem + ".loops.json", (".truth.ply", ".loops.json"), ruler.score_loops),
                    ("mesh", stem + ".mesh.ply", (".truth.ply",), ruler.score_mesh)):
                if part not in row or not os.path.exists(file):
                    continue
                n, lines = compare(f"{name}, {row['method']}", row[part], judge(points, file, truth_of(data, name, endings)))
                count += n
                wrong += lines
    print("\n".join(wrong) or f"{count} numbers agree")
    sys.exit(1 if wrong or count == 0 else 0)


main()
