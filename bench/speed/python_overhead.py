# SPDX-License-Identifier: GPL-3.0-or-later
"""What calling the library from Python costs beside its stages, which are the tool's own. Run by bench/speed/run with a
Python that has rimline:

    python_overhead.py CLOUD REPETITIONS [TOOL]    prints JSON, seconds of each run
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import rimline


def seconds(report, without=()):
    """Of the stages."""
    return sum(cost["seconds"] for cost in report["run"]["stages"] if cost["stage"] not in without)


def python_run(function, points):
    start = time.perf_counter()
    result = function(points)
    call = time.perf_counter() - start
    whole = seconds(result.report)
    # The tool writes its file in the stage write, which is left out on both sides.
    return {"call": call, "stages": whole, "method": call - (whole - seconds(result.report, ("write",)))}


def tool_run(tool, work, path):
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        # Boundary writes nothing else; the mesh of reconstruct goes to a device that takes it at once.
        out = [] if work == "boundary" else ["-o", "/dev/null"]
        subprocess.run([tool, work, path, *out, "--report", report, "-q"], check=True)
        return seconds(json.loads(report.read_text()), ("read", "write"))


def main(path, repetitions, tool=None):
    points = rimline.read(path).points.astype("float64")
    found = {"points": len(points)}
    for work, function in (("boundary", rimline.boundary), ("reconstruct", rimline.reconstruct)):
        found[work] = []
        for _ in range(int(repetitions)):  # in turns, so that what else the machine does falls on both
            run = python_run(function, points)
            if tool:
                run["tool"] = tool_run(tool, work, path)
            found[work].append(run)
    print(json.dumps(found))


main(*sys.argv[1:])
