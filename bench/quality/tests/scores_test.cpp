// SPDX-License-Identifier: GPL-3.0-or-later
// Scores of things small enough to be counted by hand.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "local/frame.h"
#include "local/star.h"
#include "quality/analytic.h"
#include "quality/arcs.h"
#include "quality/crossings.h"
#include "quality/fans.h"
#include "quality/loop_score.h"
#include "quality/mesh_score.h"
#include "quality/pages.h"
#include "quality/reliability.h"
#include "quality/results.h"
#include "quality/runner.h"
#include "quality/self_intersections.h"
#include "quality/sound.h"
#include "quality/uv_score.h"

namespace rimline::bench {
namespace {

constexpr Index side = 7;  // a flat grid of side x side points, one apart

Index at(Index x, Index y) { return y * side + x; }

std::vector<Triangle> grid_mesh() {
  std::vector<Triangle> mesh;
  for (Index y = 0; y + 1 < side; ++y) {
    for (Index x = 0; x + 1 < side; ++x) {
      mesh.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      mesh.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return mesh;
}

std::vector<Index> outline() {
  std::vector<Index> loop;
  for (Index i = 0; i + 1 < side; ++i) loop.push_back(at(i, 0));
  for (Index i = 0; i + 1 < side; ++i) loop.push_back(at(side - 1, i));
  for (Index i = 0; i + 1 < side; ++i) loop.push_back(at(side - 1 - i, side - 1));
  for (Index i = 0; i + 1 < side; ++i) loop.push_back(at(0, side - 1 - i));
  return loop;
}

Case grid_case() {
  Case c;
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x) {
      c.points.push_back({static_cast<double>(x), static_cast<double>(y), 0});
      c.boundary.push_back(x == 0 || y == 0 || x == side - 1 || y == side - 1);
    }
  }
  c.rim = c.boundary;
  c.has_loops = true;
  c.loops = {edges_of_loop(outline())};
  c.mesh = grid_mesh();
  c.flipped = c.mesh;
  measure_spacing(c);
  return c;
}

TEST_CASE("the true loop scores one everywhere, from any start and in either direction") {
  const Case c = grid_case();
  auto loop = outline();
  std::rotate(loop.begin(), loop.begin() + 5, loop.end());
  for (int turn = 0; turn < 2; ++turn) {
    Metrics m = score_loops(c, {loop});
    for (const char* name :
         {"points_f1", "points_f1_within_one_spacing", "rim_points_f1", "edges_f1", "loops_right",
          "loops_exact", "all_exact", "length_over_truth", "longest_loop_1", "longest_within_1", "simple"}) {
      CAPTURE(name);
      CHECK(m.at(name) == 1);
    }
    CHECK(m.at("crossings") == 0);
    CHECK(m.at("length") == doctest::Approx(4 * (side - 1)));
    std::reverse(loop.begin(), loop.end());
  }
}

TEST_CASE("a loop that cuts one corner loses one point and two edges of 24, and adds an edge") {
  const Case c = grid_case();
  auto loop = outline();
  loop.erase(loop.begin());  // the corner (0, 0)
  const Metrics m = score_loops(c, {loop});
  CHECK(m.at("points_precision") == 1);
  CHECK(m.at("points_recall") == doctest::Approx(23.0 / 24));
  CHECK(m.at("edges_precision") == doctest::Approx(22.0 / 23));
  CHECK(m.at("edges_recall") == doctest::Approx(22.0 / 24));
  CHECK(m.at("loops_right") == 1);
  CHECK(m.at("loops_exact") == 0);
  CHECK(m.at("points_f1_within_one_spacing") == 1);
  CHECK(m.at("length_over_truth") == doctest::Approx((22 + std::sqrt(2.0)) / 24));
}

TEST_CASE("points that are not asked count neither for nor against") {
  Case c = grid_case();
  c.boundary[at(3, 3)] = 2;
  auto found = outline();
  found.push_back(at(3, 3));
  CHECK(score_points(c, found).at("points_f1") == 1);
  found.push_back(at(2, 2));
  CHECK(score_points(c, found).at("points_precision") == doctest::Approx(24.0 / 25));
}

TEST_CASE("nothing found scores zero, and is right where nothing is true") {
  Case c = grid_case();
  CHECK(score_loops(c, {}).at("points_f1") == 0);
  CHECK(score_loops(c, {}).at("edges_f1") == 0);
  c.boundary.assign(c.points.size(), 0);
  c.rim = c.boundary;
  c.loops.clear();
  CHECK(score_loops(c, {}).at("points_f1") == 1);
  CHECK(score_loops(c, {}).at("loops_right") == 1);
}

TEST_CASE("a bow tie crosses itself once, seen from any side, and a square does not") {
  Case c = grid_case();
  const std::vector<Index> bow{at(1, 1), at(5, 5), at(5, 1), at(1, 5)};
  const std::vector<Index> square{at(1, 1), at(5, 1), at(5, 5), at(1, 5)};
  CHECK(count_crossings(c, edges_of_loop(bow)) == 1);
  CHECK(count_crossings(c, edges_of_loop(square)) == 0);
  for (Point& p : c.points) p = {p.z, p.x, p.y};
  measure_spacing(c);
  CHECK(count_crossings(c, edges_of_loop(bow)) == 1);
}

TEST_CASE("edges that pass over one another farther than a spacing do not cross") {
  Case c = grid_case();
  for (const Index lift : {at(5, 1), at(1, 5)}) c.points[lift].z = 30;
  const std::vector<Index> bow{at(1, 1), at(5, 5), at(5, 1), at(1, 5)};
  CHECK(count_crossings(c, edges_of_loop(bow)) == 0);
}

TEST_CASE("two loops that share a point are one piece, apart they are two") {
  const auto a = edges_of_loop(std::vector<Index>{0, 1, 2}), b = edges_of_loop(std::vector<Index>{2, 3, 4}),
             d = edges_of_loop(std::vector<Index>{5, 6, 7});
  EdgeSet touching = a;
  touching.insert(touching.end(), b.begin(), b.end());
  EdgeSet apart = a;
  apart.insert(apart.end(), d.begin(), d.end());
  CHECK(connected_pieces(make_set(touching)).size() == 1);
  CHECK(connected_pieces(make_set(apart)).size() == 2);
}

TEST_CASE("the mesh of a square has the numbers of a disc") {
  const Case c = grid_case();
  const Metrics m = score_mesh(c, c.mesh, {});
  CHECK(m.at("euler") == 1);
  CHECK(m.at("components") == 1);
  CHECK(m.at("boundary_loops") == 1);
  CHECK(m.at("points_used") == 1);
  CHECK(m.at("topology_right") == 1);
  CHECK(m.at("edges_agree") == 1);
  CHECK(m.at("boundary_edges_f1") == 1);
  CHECK(m.at("boundary_points_f1") == 1);
  CHECK(m.at("area_over_truth") == doctest::Approx(1));
  CHECK(m.at("orientation_conflicts") == 0);
  CHECK(m.at("nonmanifold_vertices") == 0);
  CHECK(m.at("self_intersections") == 0);
  CHECK(m.at("boundary_degree_two") == 1);
  CHECK(area_of(c.points, c.mesh) == doctest::Approx((side - 1) * (side - 1)));
  CHECK(score_rim(c.mesh, {outline()}).at("boundary_is_loops") == 1);
  CHECK(score_rim(c.mesh, {outline(), {0, 1, 2}}).at("boundary_is_loops") == 0);
}

TEST_CASE("a missing triangle in the middle is a hole, and its rim is a second loop") {
  const Case c = grid_case();
  std::vector<Triangle> mesh = c.mesh;
  mesh.erase(mesh.begin() + 2 * (3 * (side - 1) + 3));
  const Metrics m = score_mesh(c, mesh, {});
  CHECK(m.at("euler") == 0);
  CHECK(m.at("boundary_loops") == 2);
  CHECK(m.at("topology_right") == 0);
}

TEST_CASE("a third triangle at an edge, a turned one and two fans at a vertex are each counted") {
  Case c = grid_case();
  c.points.push_back({3, 3, 1});
  c.boundary.push_back(0);
  c.spacing.push_back(1);
  c.mesh.clear();
  const Index top = side * side;
  std::vector<Triangle> mesh = grid_mesh();
  mesh.push_back({at(2, 2), at(3, 2), top});
  CHECK(score_mesh(c, mesh, {}).at("nonmanifold_edges") == 1);
  mesh = grid_mesh();
  Triangle& inner = mesh[2 * (3 * (side - 1) + 3)];  // its three neighbours each see it wrong
  std::swap(inner[1], inner[2]);
  CHECK(score_mesh(c, mesh, {}).at("orientation_conflicts") == 3);
  CHECK(count_nonmanifold_vertices({{0, 1, 2}, {0, 3, 4}}) == 1);
  CHECK(count_nonmanifold_vertices({{0, 1, 2}, {0, 2, 3}}) == 0);
}

TEST_CASE("overlong edges are those of more than three spacings") {
  Case c = grid_case();
  c.mesh.clear();
  c.flipped.clear();
  // Two triangles with one inner edge: across five cells it is long, across two it is not.
  CHECK(score_mesh(c, {{at(0, 0), at(5, 0), at(0, 1)}, {at(5, 0), at(5, 1), at(0, 1)}}, {})
            .at("edges_longer_than_3_spacings") == 1);
  CHECK(score_mesh(c, {{at(0, 0), at(2, 0), at(0, 1)}, {at(2, 0), at(2, 1), at(0, 1)}}, {})
            .at("edges_longer_than_3_spacings") == 0);
}

TEST_CASE("triangles that cut through one another, fold back or lie double are found, neighbours are not") {
  const std::vector<Point> p{{0, 0, 0},     {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1},
                             {0.5, 0.5, 1}, {3, 3, 0}, {1, 1, 0}};
  CHECK(count_self_intersections(p, {{0, 1, 2}, {3, 4, 5}}) == 1);  // a blade through the face
  CHECK(count_self_intersections(p, {{0, 1, 2}, {0, 3, 4}}) == 1);  // from a common corner
  CHECK(count_self_intersections(p, {{0, 1, 2}, {1, 5, 2}}) == 0);  // neighbours over an edge
  CHECK(count_self_intersections(p, {{0, 1, 2}, {0, 6, 1}}) == 1);  // folded back over it
  CHECK(count_self_intersections(p, {{0, 1, 2}, {1, 2, 0}}) == 1);  // the same twice
  CHECK(count_self_intersections(p, {{0, 1, 2}, {0, 3, 1}}) == 0);  // a wing below
}

TEST_CASE("the identity has no angle error and no flip; mirrored as a whole it still has none") {
  const Case c = grid_case();
  std::vector<UV> uv;
  for (const Point& p : c.points) uv.push_back({p.x, p.y});
  CHECK(score_uv(c.points, c.mesh, uv).at("uv_flipped_triangles") == 0);
  CHECK(score_uv(c.points, c.mesh, uv).at("uv_mean_angle_error_rad") == doctest::Approx(0));
  for (UV& p : uv) p.u = -p.u;
  CHECK(score_uv(c.points, c.mesh, uv).at("uv_flipped_triangles") == 0);
  uv[at(3, 3)] = {100, 100};
  CHECK(score_uv(c.points, c.mesh, uv).at("uv_flipped_triangles") > 0);
}

TEST_CASE("stretching the plane by two turns the right angle's halves into atan 2 and atan 1/2") {
  const std::vector<Point> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<UV> uv{{0, 0}, {2, 0}, {0, 1}};
  const double turned = std::numbers::pi / 4 - std::atan(0.5);
  CHECK(score_uv(p, {{0, 1, 2}}, uv).at("uv_mean_angle_error_rad") == doctest::Approx(2 * turned / 3));
}

TEST_CASE("probabilities that are the truth have Brier score 0, the best constant gains nothing") {
  const std::vector<std::uint8_t> truth{1, 0, 0, 0, 2};
  const std::vector<float> perfect{1, 0, 0, 0, 0.5f}, constant{0.25f, 0.25f, 0.25f, 0.25f, 0.5f};
  CHECK(measure_reliability(perfect, truth).brier() == 0);
  CHECK(measure_reliability(perfect, truth).gain() == 1);
  CHECK(measure_reliability(constant, truth).gain() == doctest::Approx(0));
  CHECK(measure_reliability(perfect, truth).points() == 4);
  CHECK(measure_reliability(constant, truth).bins[2].boundary == 1);
}

TEST_CASE("boundary points without a probability are neither high nor low") {
  const std::vector<std::uint8_t> truth{1, 1, 1, 0};
  const std::vector<float> p{0.7f, 0.05f, std::nanf(""), 0};
  CHECK(score_probability(p, truth).at("boundary_probability_half") == doctest::Approx(1.0 / 3));
  CHECK(score_probability(p, truth).at("boundary_probability_low") == doctest::Approx(1.0 / 3));
}

TEST_CASE("a right mesh of a square is sound, one with a bridge, a hole or a lost strip is not") {
  Case c = grid_case();
  auto surface = std::make_shared<TrueSurface>();
  for (int y = 0; y <= 4 * (side - 1); ++y) {
    for (int x = 0; x <= 4 * (side - 1); ++x) surface->points.push_back({x / 4.0, y / 4.0, 0});
  }
  surface->area = (side - 1) * (side - 1);
  surface->euler = 1;
  surface->loops = 1;
  c.surface = surface;
  const auto sound = [&](const std::vector<Triangle>& mesh) {
    return score_soundness(c, mesh, score_mesh(c, mesh, {}));
  };
  CHECK(sound(c.mesh).at("sound") == 1);
  auto holed = c.mesh;
  holed.erase(holed.begin() + 40);
  CHECK(sound(holed).at("sound_topology") == 0);
  auto short_mesh = c.mesh;
  short_mesh.resize(short_mesh.size() - 3 * 2 * (side - 1));  // three rows less
  CHECK(sound(short_mesh).at("sound_area") == 0);
  CHECK(sound(short_mesh).at("sound_distance") == 0);
  CHECK(sound({}).at("sound") == 0);
  Case lifted = c;
  for (const Index id : {at(3, 3)}) lifted.points[id].z = 5;
  CHECK(score_soundness(lifted, c.mesh, score_mesh(lifted, c.mesh, {})).at("farthest_from_surface") > 2);
}

TEST_CASE("a case is drawn alike whichever others are, and rows do not depend on the number of jobs") {
  AnalyticPlan few;
  few.draws = 1;
  few.sizes = {1000};
  few.noises = {0.2};
  AnalyticPlan more = few;
  more.draws = 2;
  more.noises = {0, 0.2};
  const auto some = analytic_cases(few), all = analytic_cases(more);
  for (const CaseName& name : some) {
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const auto& o) { return o.text() == name.text(); });
    REQUIRE(same != all.end());
    CHECK(same->seed == name.seed);
  }
  Plan plan;
  plan.verbose = false;
  plan.cases = {some.begin(), some.begin() + 4};
  Method none{"nothing", "nothing", true, false, true, [](const Case&, bool) { return Outcome{}; }};
  plan.methods = {none};
  plan.jobs = 1;
  const auto one = run_plan(plan);
  plan.jobs = 3;
  const auto three = run_plan(plan);
  REQUIRE(one.size() == 4);
  REQUIRE(three.size() == 4);
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].name.text() == three[i].name.text());
    CHECK(one[i].loops == three[i].loops);
  }
}

TEST_CASE("the arcs of a flat grid with a hole close into its outline and the hole's rim") {
  Case c = grid_case();
  std::vector<Point> kept;  // without the middle point: the hole has eight points around it
  std::vector<Index> id_in(c.points.size(), none);
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    if (static_cast<Index>(i) == at(3, 3)) continue;
    id_in[i] = static_cast<Index>(kept.size());
    kept.push_back(c.points[i] + Point{1e-3 * std::sin(7.0 * i), 1e-3 * std::cos(5.0 * i), 0});
  }
  Run run;
  run.threads = 1;
  const auto neighbours = find_neighbours(kept, 16, run);
  const auto spacing = local_spacing(kept, neighbours);
  const auto frames = fit_frames(kept, neighbours, run);
  const auto stars = find_stars(kept, neighbours, spacing, frames, run);
  const LoopIds loops = closed_arcs(mutual_edges(kept, stars, std::vector<double>(kept.size(), 0.55)));
  std::vector<Index> expected;
  for (const Index id : outline()) expected.push_back(id_in[id]);
  CHECK(std::any_of(loops.begin(), loops.end(),
                    [&](const auto& loop) { return edges_of_loop(loop) == edges_of_loop(expected); }));
}

TEST_CASE("edges that end nowhere or branch are no closed arc") {
  const std::vector<Index> square{0, 1, 2, 3};
  EdgeSet edges = edges_of_loop(square);
  CHECK(closed_arcs(edges).size() == 1);
  CHECK(edges_of_loop(closed_arcs(edges)[0]) == edges);
  EdgeSet branched = edges;
  branched.push_back(Edge::of(2, 9));
  CHECK(closed_arcs(make_set(branched)).empty());
  edges.pop_back();
  CHECK(closed_arcs(edges).empty());
}

TEST_CASE("results come back from their file as they were, and rows of other methods can be kept") {
  Results results;
  results.titles = {{"default", "rimline"}, {"other", "another"}};
  results.runs = {{"command", "1.0", "abc", "2026-01-01", 7, {"default", "other"}}};
  Reliability reliability;
  reliability.add(0.93, true);
  reliability.add(0.93, false);
  const CaseName name{"analytic", "pipe", "grid", 0.2, 1000, 3, 0xfedcba9876543210};
  results.rows = {{name, "default", "", "no disc", 0.5, {{"points_f1", 0.25}}, {{"euler", -3}}, reliability},
                  {name, "other", "crashed", "", 0.5, {{"points_f1", 0.5}}, {}, {}}};
  const std::string path = (std::filesystem::temp_directory_path() / "rimline_quality_results.json").string();
  write_results(path, results);
  const Results back = read_results(path);
  std::filesystem::remove(path);
  REQUIRE(back.rows.size() == 2);
  CHECK(back.titles == results.titles);
  CHECK(back.rows[0].name.text() == name.text());
  CHECK(back.rows[0].name.seed == name.seed);
  CHECK(back.rows[0].loops == results.rows[0].loops);
  CHECK(back.rows[0].mesh == results.rows[0].mesh);
  CHECK(back.rows[0].mesh_error == "no disc");
  CHECK(back.rows[0].reliability->bins[9].boundary == 1);
  CHECK(back.rows[0].reliability->brier() == reliability.brier());
  CHECK(back.rows[1].error == "crashed");
  CHECK(quality_page(back) == quality_page(results));

  Results again;
  again.titles = {{"default", "rimline"}};
  again.rows = {results.rows[0]};
  keep_other_methods(again, back);
  REQUIRE(again.rows.size() == 2);
  CHECK(again.rows[1].method == "other");
  CHECK(again.runs[0].methods == std::vector<std::string>{"other"});
}

}  // namespace
}  // namespace rimline::bench
