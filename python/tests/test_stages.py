# SPDX-License-Identifier: GPL-3.0-or-later
"""Every stage alone: together they are the whole method."""
from __future__ import annotations

import numpy as np
import pytest
import rimline


def test_stage_by_stage_gives_the_loops_of_the_whole(cap: rimline.Sample) -> None:
    arrangement = rimline.arrange(cap.points)
    neighbours = rimline.find_neighbours(arrangement.points, 40)
    arrangement = rimline.leave_out_stray(arrangement, neighbours)
    scores = rimline.score_boundary(arrangement.points, neighbours)
    survey = rimline.find_boundary_loops(arrangement.points, neighbours, scores)
    whole = rimline.boundary(cap.points)
    assert len(survey.loops) == len(whole.loops) == 1
    assert set(arrangement.ids[survey.loops[0].points]) == set(whole.loops[0].points)
    assert np.array_equal(survey.probability, whole.probability[arrangement.ids])  # type: ignore[index]
    assert np.array_equal(survey.label, whole.label[arrangement.ids])  # type: ignore[index]

    surface = rimline.refine_surface(arrangement.points, neighbours, survey.loops, survey.triangles)
    mesh = rimline.reconstruct(cap.points)
    edges = rimline.edge_agreement(arrangement.ids[surface.triangles], mesh.faces)
    assert edges > 0.99
    told = rimline.measure_mesh(
        arrangement.points, surface.triangles, rimline.local_spacing(arrangement.points, neighbours), surface.uv
    )
    assert told["euler"] == 1 and told["uv_flips"] == 0
    patch = rimline.refine_patch(arrangement.points, neighbours, survey.loops, domain="square")
    assert patch.domain == "square"
    assert len(patch.triangles) == len(surface.triangles)


def test_repr_tells_the_story_in_a_line(cap: rimline.Sample) -> None:
    with_nan = np.vstack([cap.points, np.full((1, 3), np.nan)])
    arrangement = rimline.arrange(with_nan)
    count = f"{len(cap.points):,} points"
    assert repr(arrangement) == f"<rimline.Arrangement: {count}, 1 left out>"
    neighbours = rimline.find_neighbours(arrangement.points, 40)
    assert repr(neighbours) == f"<rimline.Neighbours: 40 of each of {count}>"
    scores = rimline.score_boundary(arrangement.points, neighbours)
    assert repr(scores) == f"<rimline.BoundaryScores: {count}, {np.count_nonzero(scores.candidate):,} candidates>"
    survey = rimline.find_boundary_loops(arrangement.points, neighbours, scores)
    assert repr(survey) == f"<rimline.BoundaryLoops: 1 loop, {len(survey.triangles):,} triangles>"
    surface = rimline.refine_surface(arrangement.points, neighbours, survey.loops, survey.triangles)
    assert repr(surface) == f"<rimline.Surface: {len(surface.triangles):,} triangles, 1 loop, 0 points left out>"
    assert np.array_equal(surface.loops[0].points, survey.loops[0].points)
    assert repr(cap) == f"<rimline.Sample: {count}, 1 true loop>"


def test_numbers_of_stages_are_checked(cap: rimline.Sample) -> None:
    for wrong in (2.5, "5", True):
        with pytest.raises(TypeError, match="k must be an integer"):
            rimline.find_neighbours(cap.points, wrong)  # type: ignore[arg-type]
        with pytest.raises(TypeError, match="n must be an integer"):
            rimline.sample("flat-disc", wrong)  # type: ignore[arg-type]
    for call in (lambda: rimline.sample("flat-disc", -5), lambda: rimline.estimate_memory(-1),
                 lambda: rimline.estimate_memory(10**30)):
        with pytest.raises(rimline.Error, match="must lie between"):
            call()


def test_the_stages_of_the_paper(cap: rimline.Sample) -> None:
    points = rimline.arrange(cap.points).points
    neighbours = rimline.find_neighbours(points, 40)
    scores = rimline.score_boundary(points, neighbours, preset="paper")
    found = rimline.find_genetic_loop(points, neighbours, scores, generations=20)
    circle = rimline.circle_by_chord_length(points, found.loop.points)
    assert np.allclose(np.linalg.norm(circle, axis=1), 1)
    flat = rimline.map_to_disc(points, neighbours, found.loop.points)
    assert np.linalg.norm(flat.uv, axis=1).max() <= 1 + 1e-12
    triangles = rimline.delaunay(flat.uv)
    turned, _ = rimline.orient_mesh(points, triangles, up=(0, 0, -1))
    assert sorted(map(tuple, np.sort(turned))) == sorted(map(tuple, np.sort(triangles)))
    assert rimline.fitness(found.winner, scores, preset="paper") > 0
    whole, of_triangles, of_points = rimline.measure_distortion(points, triangles, flat.uv)
    assert len(of_triangles.angle) == len(triangles) and len(of_points.angle) == len(points)
    assert whole["stretch_l2"] >= 1


def test_neighbours_are_the_nearest() -> None:
    points = np.random.default_rng(3).random((200, 3))
    distances = np.linalg.norm(points[:, None] - points[None], axis=2)
    expected = np.argsort(distances, axis=1)[:, 1:6]
    assert np.array_equal(rimline.find_neighbours(points, 5).ids, expected)


def test_delaunay_of_a_square_is_two_triangles() -> None:
    triangles = rimline.delaunay(np.array([[0, 0], [1, 0], [1, 1], [0, 1.01]]))
    assert triangles.shape == (2, 3) and triangles.dtype == np.int32


def test_length_of_a_square() -> None:
    square = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0.0]])
    assert rimline.loop_length(square, [0, 1, 2, 3]) == 8


def test_self_intersections_of_two_triangles_that_cross() -> None:
    points = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.4, 0.4, -1], [0.5, 0.4, 1], [0.4, 0.5, 1]]
    assert rimline.find_self_intersections(points, [[0, 1, 2], [3, 4, 5]]).tolist() == [[0, 1]]


def test_distance_of_parallel_triangles() -> None:
    flat = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0.0]])
    told = rimline.surface_distance(flat + [0, 0, 0.25], [[0, 1, 2]], flat, [[0, 1, 2]])
    assert told == {"mean": 0.25, "rms": 0.25, "most": 0.25}


def test_scores_and_memory() -> None:
    assert rimline.p_value(0.0) == 1
    assert rimline.score(2.5, "log") == 2.5
    assert rimline.score(np.log(4), "printed") == pytest.approx(4)
    assert rimline.summarize_spacing([1.0, 2.0, 3.0])["mean"] == 2
    few, many = rimline.estimate_memory(1000), rimline.estimate_memory(10**6)
    assert all(many[stage] >= few[stage] > 0 for stage in few)


def test_stages_refuse_what_would_break_them(cap: rimline.Sample) -> None:
    points = cap.points
    neighbours = rimline.find_neighbours(points, 40)
    scores = rimline.score_boundary(points, neighbours)
    broken = points.copy()
    broken[3] = np.nan
    twice = points.copy()
    twice[3] = twice[4]
    few = rimline.find_neighbours(points[:100], 40)
    with pytest.raises(ValueError, match="finite"):
        rimline.find_neighbours(broken, 5)
    with pytest.raises(ValueError, match="distinct"):
        rimline.find_boundary_loops(twice, rimline.find_neighbours(twice, 40), scores)
    with pytest.raises(ValueError, match="neighbours"):
        rimline.score_boundary(points, few)
    with pytest.raises(ValueError, match="scores"):
        rimline.find_boundary_loops(points[:100], few, scores)
    with pytest.raises(rimline.Error, match="k is 0"):
        rimline.find_neighbours(points, 0)
    with pytest.raises(ValueError, match="id"):
        rimline.find_self_intersections(points, [[0, 1, 10**6]])
    with pytest.raises(ValueError, match="twice"):
        rimline.orient_mesh(points, [[0, 1, 1]])
    with pytest.raises(rimline.Error, match="id"):
        rimline.circle_by_chord_length(points, [0, 1, -7])
    with pytest.raises(ValueError, match="finite"):
        rimline.delaunay(np.array([[0, np.nan], [1, 1], [2, 0]]))
