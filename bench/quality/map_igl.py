#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""libigl's maps, asked as in peers/maps_protocol.h: map_igl.py METHOD IN OUT, METHOD lscm, arap or slim. Needs `pip install libigl`."""
import sys
import time

import igl
import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import spsolve

from map_files import read_question, write_answer

ROUNDS = {"arap": 100, "slim": 20}


def lscm(points, triangles):
    rim = igl.boundary_loop(triangles)
    held = np.array([rim[0], rim[len(rim) // 2]])
    places = np.array([[0.0, 0.0], [np.linalg.norm(points[held[1]] - points[held[0]]), 0.0]])
    return igl.lscm(points, triangles, held, places)[0]


def circle(points, triangles):
    """Harmonic in the circle with cotangent weights, or with equal ones (Tutte's) where those turn triangles; at the mesh's area."""
    rim = igl.boundary_loop(triangles)
    length = np.linalg.norm(np.roll(points[rim], -1, 0) - points[rim], axis=1)
    turn = 2 * np.pi * (np.cumsum(length) - length) / length.sum()
    places = np.stack([np.cos(turn), np.sin(turn)], 1)
    uv = igl.harmonic(points, triangles, rim, places, 1)
    s, t = (uv[triangles[:, c]] - uv[triangles[:, 0]] for c in (1, 2))
    if not (s[:, 0] * t[:, 1] - s[:, 1] * t[:, 0] > 0).all():
        uv = tutte(triangles, rim, places, len(points))
    sides = [points[triangles[:, c]] - points[triangles[:, 0]] for c in (1, 2)]
    return uv * np.sqrt(np.linalg.norm(np.cross(*sides), axis=1).sum() / 2 / np.pi)


def tutte(triangles, rim, places, count):
    """Holes are closed by a vertex each: without it nothing keeps their triangles from turning."""
    closed, held = [triangles], set(rim.tolist())
    for hole in igl.boundary_loop_all(triangles):
        if hole[0] not in held:
            after = np.roll(hole, -1)
            closed.append(np.stack([after, hole, np.full(len(hole), count + len(closed) - 1)], 1))
    sides = np.concatenate([t[:, [i, j]] for t in closed for i in range(3) for j in range(3) if i != j])
    both = np.unique(sides, axis=0)
    total = count + len(closed) - 1
    adjacent = coo_matrix((np.ones(len(both)), (both[:, 0], both[:, 1])), (total, total)).tocsr()
    free = np.setdiff1d(np.arange(total), rim)
    degree = np.asarray(adjacent.sum(1)).ravel()[free]
    uv = np.zeros((total, 2))
    uv[rim] = places
    uv[free] = spsolve((diags(degree) - adjacent[free][:, free]).tocsc(), adjacent[free][:, rim] @ places)
    return uv[:count]


def arap(points, triangles):
    data = igl.ARAPData()
    data.max_iter = ROUNDS["arap"]
    igl.arap_precomputation(points, triangles, 2, np.zeros(0, np.int32), data)
    return igl.arap_solve(np.zeros((0, 2)), data, circle(points, triangles))


def slim(points, triangles):
    start = np.asfortranarray(circle(points, triangles))
    data = igl.slim_precompute(np.asfortranarray(points), np.asfortranarray(triangles.astype(np.int32)), start,
                               igl.MappingEnergyType.SYMMETRIC_DIRICHLET, np.zeros(0, np.int32), np.asfortranarray(np.zeros((0, 2))), 0.0)
    return igl.slim_solve(data, ROUNDS["slim"])


def main(method, question, answer):
    points, triangles = read_question(question)
    triangles = np.ascontiguousarray(triangles, np.int64)
    began = time.process_time()
    uv = {"lscm": lscm, "arap": arap, "slim": slim}[method](points, triangles)
    seconds = time.process_time() - began
    write_answer(answer, seconds, uv[triangles].reshape(-1, 6), np.zeros(len(triangles)))


if __name__ == "__main__":
    main(*sys.argv[1:4])
