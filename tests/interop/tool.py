# SPDX-License-Identifier: GPL-3.0-or-later
"""The tool, its PLY files, and how a check tells what came of it."""

import json
import subprocess
import sys
import traceback

import numpy as np

TYPES = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4",
         "float": "<f4", "double": "<f8"}


class Skipped(Exception):
    """What the check needs can not be had here."""


class Tool:
    def __init__(self, path, folder):
        self.path = path
        self.folder = folder

    def __call__(self, *arguments):
        done = subprocess.run([self.path, *map(str, arguments), "--quiet"], capture_output=True, text=True)
        assert done.returncode == 0, f"{' '.join(map(str, arguments))}: {done.stderr}"
        return done.stdout

    def points(self, path, *options):
        """All that the tool reads of a file: a structured array with x, y, z and the properties."""
        out = self.folder / "points.ply"
        self("boundary", path, "-o", out, "--preset", "paper", *options)
        return read_ply(out)


def read_ply(path):
    """The points of a binary PLY, as the tool writes it."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    fields, count = [], 0
    for line in head.decode().splitlines():
        words = line.split()
        if words[:2] == ["element", "vertex"]:
            count = int(words[2])
        elif words[0] == "element":
            break
        elif words[0] == "property":
            fields.append((words[2], TYPES[words[1]]))
    return np.frombuffer(body, np.dtype(fields), count)


def places(points):
    return np.stack([points["x"], points["y"], points["z"]], axis=1)


def same(found, expected, what):
    assert len(found) == len(expected), f"{what}: {len(found)} for {len(expected)}"
    assert np.array_equal(found, expected, equal_nan=np.issubdtype(np.asarray(expected).dtype, np.floating)), \
        f"{what} differ, first {np.asarray(found)[:3]} for {np.asarray(expected)[:3]}"


def module(name):
    try:
        return __import__(name)
    except ImportError as error:
        raise Skipped(f"the Python package {name} can not be had ({error})") from error


def run_checks(checks, tool):
    """Runs them all and prints a line for each; returns how many failed."""
    failed = 0
    for check in checks:
        name = check.__doc__.splitlines()[0].rstrip(".")
        try:
            check(tool)
            print(f"interop: passed: {name}")
        except Skipped as reason:
            print(f"interop: SKIPPED: {name}: {reason}")
        except Exception:
            failed += 1
            print(f"interop: FAILED: {name}")
            traceback.print_exc(file=sys.stdout)
        sys.stdout.flush()
    return failed


def read_json(path):
    return json.loads(path.read_text())
