# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and maps as plain arrays: a PLY that rimline wrote, and the files of peers/maps_protocol.h. Needs numpy."""
import numpy as np

KINDS = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4", "double": "f8"}


def _read_tables(path):
    data = open(path, "rb").read()
    start = data.index(b"end_header\n") + len(b"end_header\n")
    elements = []
    for line in data[:start].decode().splitlines():
        word = line.split()
        if word[0] == "element":
            elements.append((word[1], int(word[2]), []))
        elif word[0] == "property":
            elements[-1][2].append(word[1:])
    tables = {}
    for name, count, properties in elements:
        row = []
        for p in properties:
            if p[0] == "list":  # a triangle's, so each is as long as the first
                row += [("count of " + p[3], "<" + KINDS[p[1]]), (p[3], "<" + KINDS[p[2]], 3)]
            else:
                row.append((p[1], "<" + KINDS[p[0]]))
        kind = np.dtype(row)
        tables[name] = np.frombuffer(data, kind, count, start)
        start += count * kind.itemsize
    return tables


def _points_of(tables):
    return np.stack([tables["vertex"][c].astype(float) for c in "xyz"], 1)


def read_points(path):
    """Points (n, 3) of a binary PLY."""
    return _points_of(_read_tables(path))


def read_mesh(path):
    """Points (n, 3) and triangles (m, 3) of a binary PLY with one kind of face."""
    tables = _read_tables(path)
    return _points_of(tables), tables["face"]["vertex_indices"].astype(np.int64)


def _write_array(file, values, kind):
    np.array([len(values)], "<i8").tofile(file)
    np.ascontiguousarray(values, kind).tofile(file)


def _read_array(file, kind, width):
    count = int(np.fromfile(file, "<i8", 1)[0])
    return np.fromfile(file, kind, count * width).reshape(count, width)


def write_question(path, points, triangles):
    with open(path, "wb") as file:
        _write_array(file, points, "<f8")
        _write_array(file, triangles, "<i4")


def read_question(path):
    with open(path, "rb") as file:
        return _read_array(file, "<f8", 3), _read_array(file, "<i4", 3)


def write_answer(path, seconds, corners, chart):
    with open(path, "wb") as file:
        np.array([seconds], "<f8").tofile(file)
        _write_array(file, corners, "<f8")
        _write_array(file, chart, "<i4")


def read_answer(path):
    """Seconds, uv of corners (m, 3, 2), chart of each triangle (m)."""
    with open(path, "rb") as file:
        seconds = float(np.fromfile(file, "<f8", 1)[0])
        corners = _read_array(file, "<f8", 6).reshape(-1, 3, 2)
        return seconds, corners, _read_array(file, "<i4", 1).ravel()


def put_page(text, path):
    """Writes a page, or prints it where there is no path."""
    if path:
        with open(path, "w") as file:
            file.write(text)
    else:
        print(text)
