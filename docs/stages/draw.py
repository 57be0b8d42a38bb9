# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws arrange.svg and neighbours.svg beside this file; needs the Python package.

    python docs/stages/draw.py
"""
from __future__ import annotations

import pathlib

import numpy as np
import rimline

SIZE, INSET = 330, 16
FOLDER = pathlib.Path(__file__).parent


def panel(points: np.ndarray, left: int) -> np.ndarray:
    """Pixels of points in the plane; y points down in a picture."""
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    scale = (SIZE - 2 * INSET) / (high - low).max()
    place = INSET + scale * (points[:, :2] - low)
    return np.column_stack([left + place[:, 0], SIZE - place[:, 1]])


def line(places: np.ndarray, colour: str, width: float) -> str:
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"/>'


def dot(place: np.ndarray, colour: str, radius: float) -> str:
    return f'<circle cx="{place[0]:.1f}" cy="{place[1]:.1f}" r="{radius}" fill="{colour}"/>'


def write(name: str, panels: int, parts: list[str]) -> None:
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{panels * SIZE}" height="{SIZE}">'
    background = '<rect width="100%" height="100%" fill="white"/>'
    (FOLDER / name).write_text("\n".join([head, background, *parts, "</svg>"]) + "\n")


def draw_arrange() -> None:
    """Left: the points in the order of the input; right: along the Morton curve."""
    points = rimline.sample("bumpy-square", 500).points
    arranged = rimline.arrange(points).points
    parts = []
    for left, ordered in ((0, points), (SIZE, arranged)):
        places = panel(np.asarray(ordered), left)
        parts.append(line(places, "#9bb3d0", 0.8))
        parts += [dot(place, "#1f3b63", 1.6) for place in places]
    write("arrange.svg", 2, parts)


def draw_neighbours() -> None:
    """Three points with their 40 nearest: inside, at the boundary, and where the density changes."""
    points = np.asarray(rimline.sample("bumpy-square", 1500, sampling="density-step").points)
    places = panel(points, 0)
    lists = np.asarray(rimline.find_neighbours(points, 40).ids).reshape(len(points), 40)
    parts = [dot(place, "#b9bec6", 1.6) for place in places]
    wanted = np.array([[0.2, 0.5], [0.8, 0.03], [0.52, 0.75]]) * SIZE
    for place, colour in zip(wanted, ("#c0392b", "#1f6fb2", "#2d8a4e")):
        nearest = int(np.argmin(((places - [place[0], SIZE - place[1]]) ** 2).sum(axis=1)))
        parts += [line(places[[nearest, other]], colour, 0.6) for other in lists[nearest]]
        parts += [dot(places[other], colour, 2.2) for other in lists[nearest]]
        parts.append(dot(places[nearest], "black", 3.2))
    write("neighbours.svg", 1, parts)


draw_arrange()
draw_neighbours()
