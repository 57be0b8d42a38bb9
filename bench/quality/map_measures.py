# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a map is off, from its triangles alone: written for the bench, none of it is the library's. Needs numpy."""
import numpy as np


def angles(a, b, c):
    """The three angles of each triangle (m, 3), in the plane or in space."""
    def at(p, q, r):
        e, f = q - p, r - p
        dot = (e * f).sum(1)
        across = np.sqrt(np.maximum((e * e).sum(1) * (f * f).sum(1) - dot * dot, 0))
        return np.arctan2(across, dot)
    return np.stack([at(a, b, c), at(b, c, a), at(c, a, b)], 1)


def _rims(triangles):
    """Edges of one triangle, in its direction (k, 2)."""
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    _, first, count = np.unique(np.sort(sides, 1), axis=0, return_index=True, return_counts=True)
    return sides[first[count == 1]]


def least_angle_error(points, triangles):
    """No map without turned triangles is below it: around an inner vertex the angles in the plane make 2 pi, so those of its
    corners change by what is lacking in space, together. The mean over all corners, where no corner of a rim changes."""
    own = angles(*(points[triangles[:, c]] for c in range(3)))
    total = np.bincount(triangles.ravel(), own.ravel(), len(points))
    inner = np.bincount(triangles.ravel(), minlength=len(points)) > 0
    inner[_rims(triangles).ravel()] = False
    return float(np.abs(2 * np.pi - total[inner]).sum() / own.size)


def is_disc_with_holes(triangles):
    """One piece, two-sided, without handles."""
    rims = _rims(triangles)
    after = dict(map(tuple, rims.tolist()))
    if len(after) != len(rims) or not len(rims):
        return False
    loops, left = 0, set(after)
    while left:
        at = left.pop()
        loops += 1
        while after.get(at) in left:
            at = after[at]
            left.remove(at)
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), 1)
    euler = len(np.unique(triangles)) - len(np.unique(sides, axis=0)) + len(triangles)
    return euler == 2 - loops


def _singular(points, triangles, corners):
    """Singular values of the maps from uv to space, larger first (m, 2), and twice the signed areas in uv."""
    e, f = (points[triangles[:, c]] - points[triangles[:, 0]] for c in (1, 2))
    s, t = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    twice = s[:, 0] * t[:, 1] - s[:, 1] * t[:, 0]
    with np.errstate(all="ignore"):
        du = (t[:, 1:] * e - s[:, 1:] * f) / twice[:, None]
        dv = (s[:, :1] * f - t[:, :1] * e) / twice[:, None]
        a, b, c = (du * du).sum(1), (du * dv).sum(1), (dv * dv).sum(1)
        root = np.sqrt((a - c) ** 2 + 4 * b * b)
        return np.sqrt(np.stack([(a + c + root) / 2, np.maximum(a + c - root, 0) / 2], 1)), twice


def crossings(corners, chart, most=2_000_000):
    """Pairs of outline edges of one chart that cross in their insides. None where there are more than `most` pairs of boxes."""
    total = 0
    for number in np.unique(chart):
        edges = _outline(corners[chart == number])
        count = _crossings_of(edges, most)
        if count is None:
            return None
        total += count
    return total


def _outline(corners):
    places, index = np.unique(corners.reshape(-1, 2), axis=0, return_inverse=True)
    return places[_rims(index.reshape(-1, 3))]


def _crossings_of(edges, most):
    low, high = edges.min(1), edges.max(1)
    order = np.argsort(low[:, 0], kind="stable")
    low, high, edges = low[order], high[order], edges[order]
    last = np.searchsorted(low[:, 0], high[:, 0], side="right")
    pairs = np.maximum(last - np.arange(len(edges)) - 1, 0)
    if pairs.sum() > most * 10:
        return None
    i = np.repeat(np.arange(len(edges)), pairs)
    j = np.arange(len(i)) - np.repeat(np.cumsum(pairs) - pairs, pairs) + i + 1
    near = (low[i, 1] <= high[j, 1]) & (low[j, 1] <= high[i, 1])
    (a, b), (c, d) = edges[i[near]].swapaxes(0, 1), edges[j[near]].swapaxes(0, 1)
    def side(p, q, r):
        return np.sign((q - p)[:, 0] * (r - p)[:, 1] - (q - p)[:, 1] * (r - p)[:, 0])
    return int(((side(a, b, c) * side(a, b, d) < 0) & (side(c, d, a) * side(c, d, b) < 0)).sum())


def measure(points, triangles, corners, chart):
    """A map as it is, mirrored where most of it is turned; its scale does not count."""
    if not np.isfinite(corners).all():
        return {"turned": len(triangles)}
    singular, twice = _singular(points, triangles, corners)
    turned = min(int((twice <= 0).sum()), int((twice >= 0).sum()))
    own = angles(*(points[triangles[:, c]] for c in range(3)))
    flat = angles(*(corners[:, c] for c in range(3)))
    e, f = (points[triangles[:, c]] - points[triangles[:, 0]] for c in (1, 2))
    area = np.linalg.norm(np.cross(e, f), axis=1) / 2
    keeps = area > 0
    scale = np.sqrt(np.abs(twice).sum() / 2 / area.sum())
    with np.errstate(all="ignore"):
        ratio = np.abs(np.log(np.abs(twice[keeps]) / 2 / area[keeps] / scale**2))
        mean = np.sqrt((area[keeps] * (singular[keeps] ** 2).sum(1) / 2).sum() / area.sum()) * scale
    return {"angle": float(np.abs(own - flat).mean()), "area": float((area[keeps] * ratio).sum() / area.sum()),
            "mean": float(mean), "worst": float(singular[keeps, 0].max() * scale), "turned": turned,
            "charts": len(np.unique(chart)), "crossings": crossings(corners, chart)}
