# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of dirt. Each takes a random generator, clean points (n, 3), their spacing and an amount, and returns the dirty points, of which
the first n are the clean ones, in their order. Lengths are in spacings. Needs numpy."""
import math

import numpy as np


def directions(rng, count):
    d = rng.normal(size=(count, 3))
    return d / np.linalg.norm(d, axis=1)[:, None]


def count_of(points, share):
    return max(1, round(share * len(points)))


def with_added(points, added):
    return np.vstack([points, added])


def in_box(rng, points, spacing, share):
    """Anywhere in the box of the points, grown by a tenth of its diagonal."""
    low, high = points.min(0), points.max(0)
    margin = 0.1 * np.linalg.norm(high - low)
    return with_added(points, rng.uniform(low - margin, high + margin, (count_of(points, share), 3)))


def near(rng, points, spacing, share):
    """In balls of five spacings about points."""
    count = count_of(points, share)
    offsets = directions(rng, count) * (5 * spacing * rng.random((count, 1)) ** (1 / 3))
    return with_added(points, points[rng.integers(len(points), size=count)] + offsets)


def tail(rng, points, spacing, count):
    """A line that leads away from the point that lies outermost in a random direction, a point a spacing."""
    d = directions(rng, 1)[0]
    start = points[(points @ d).argmax()]
    return with_added(points, start + spacing * np.arange(1, count + 1)[:, None] * d)


def line_across(rng, points, spacing, count):
    """A line that leads away from some point, up or down."""
    start = points[rng.integers(len(points))]
    d = np.array([0, 0, rng.choice([-1.0, 1.0])]) + 0.3 * directions(rng, 1)[0]
    return with_added(points, start + 0.7 * spacing * np.arange(1, count + 1)[:, None] * d / np.linalg.norm(d))


def group(distance):
    def far_group(rng, points, spacing, count):
        """A small piece of a plane beside the box."""
        d = directions(rng, 1)[0]
        centre = points[(points @ d).argmax()] + distance * spacing * d
        side = math.ceil(math.sqrt(count))
        grid = np.array([(i % side, i // side, 0) for i in range(count)], float) - [side / 2, side / 2, 0]
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        return with_added(points, centre + spacing * (grid + 0.2 * rng.normal(size=grid.shape)) @ turn)
    return far_group


def steps_of_axis(rng, points, spacing, quantum):
    """The third coordinate in steps."""
    q = quantum * spacing
    return np.column_stack([points[:, :2], np.round(points[:, 2] / q) * q])


def steps_of_all(rng, points, spacing, quantum):
    """All coordinates in steps, as centimetres do."""
    q = quantum * spacing
    return np.round(points / q) * q


def viewpoint_of(points):
    low, high = points.min(0), points.max(0)
    return (low + high) / 2 + [0, 0, 2 * np.linalg.norm(high - low)]


def steps_of_ray(rng, points, spacing, quantum):
    """The distance from a viewpoint above in steps."""
    eye = viewpoint_of(points)
    away = points - eye
    far = np.linalg.norm(away, axis=1)[:, None]
    q = quantum * spacing
    return eye + away / far * np.round(far / q) * q


def float32_far(rng, points, spacing, quantum):
    """Rounded to 32 bits so far from the origin that a step of y is this long, and one of x an eighth of it, as of UTM coordinates."""
    unit = spacing / (0.5 / quantum)  # 32 bits make steps of 0.5 at 4 to 8 million
    far = points / unit + [6e5, 5.4e6, 0]
    return far.astype(np.float32).astype(float)


def plate_before_wall(rng, count):
    """What a depth camera at the origin sees of a round plate before a wall, in spacings of the plate."""
    side = math.isqrt(count)
    at = (np.stack(np.meshgrid(np.arange(side), np.arange(side), indexing="ij"), 2).reshape(-1, 2) - side / 2 + 0.5
          + 0.15 * rng.normal(size=(side * side, 2)))
    on_plate = np.hypot(*at.T) < side / 4
    far = 2.0 * side
    ray = np.column_stack([at / far, np.ones(len(at))])
    return ray * np.where(on_plate, far, far + 12)[:, None]


def flying_pixels(rng, points, spacing, share):
    """Between the plate's rim and the wall, on rays from the camera. A share of the points."""
    at = points[:, :2] / points[:, 2:]
    depth = points[:, 2].min()
    plate = points[:, 2] < depth + 1
    radius = np.hypot(*at[plate].T).max()
    angle = rng.uniform(0, 2 * np.pi, count_of(points, share))
    ray = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.ones(len(angle))])
    return with_added(points, ray * (depth + 12 * rng.uniform(0.1, 0.9, (len(angle), 1))))


ADDED = {
    "outliers in the box": (in_box, [0.005, 0.01, 0.02, 0.05]),
    "outliers within 5 spacings": (near, [0.005, 0.01]),
    "tail": (tail, [5, 20]),
    "line through the surface": (line_across, [60]),
    "group 8 spacings off": (group(8), [10, 20]),
    "group 1e6 spacings off": (group(1e6), [10, 20]),
}
FLYING = {"flying pixels": (flying_pixels, [0.005, 0.01, 0.03])}
MOVED = {
    "steps along an axis": (steps_of_axis, [0.25, 0.5, 1, 2, 4]),
    "steps along the ray": (steps_of_ray, [0.5, 1, 2, 4]),
    "steps of all axes": (steps_of_all, [0.1, 0.25, 0.5]),
    "float32 far from the origin": (float32_far, [0.25, 0.5]),
}


def layers(rng, first, second, spacing, gap):
    """Another sample of the same surface, moved up."""
    return np.vstack([first, second + [0, 0, gap * spacing]])


def random_cube(rng, count):
    return rng.random((count, 3))


def shredded(rng, count):
    """Strips of a frame of a depth camera, each at a depth of its own."""
    side = math.isqrt(count)
    x, y = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    depth = np.repeat(rng.uniform(0, 20, side // 4 + 1), 4)[:side]
    z = depth[:, None] + rng.uniform(0, 6, (side, side)) * (rng.random((side, side)) < 0.5)
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()])


def leaves(rng, count):
    """Discs of about twenty points, anywhere in a ball."""
    each = 20
    number = max(1, count // each)
    centres = directions(rng, number) * (count ** (1 / 3) * rng.random((number, 1)) ** (1 / 3))
    points = []
    for centre in centres:
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        angle, radius = rng.uniform(0, 2 * np.pi, each), 0.8 * np.sqrt(rng.random(each))
        points.append(centre + np.column_stack([radius * np.cos(angle), radius * np.sin(angle), 0.05 * rng.normal(size=each)]) @ turn)
    return np.vstack(points)


HOPELESS = {"random points in a cube": random_cube, "shredded frame": shredded, "leaves of a tree": leaves}
LAYERS = [0.5, 1, 1.5, 2, 2.5, 3]
