// SPDX-License-Identifier: GPL-3.0-or-later
// The stages up to the loops, each alone.
#include <nanobind/stl/string.h>

#include <algorithm>
#include <string>

#include "arrays.h"
#include "call.h"
#include "checks.h"
#include "loops.h"
#include "members.h"
#include "names.h"
#include "parts.h"
#include "rimline/arrange.h"
#include "rimline/boundary_loops.h"
#include "rimline/find_genetic_loop.h"
#include "story.h"

namespace rimline::python {
namespace {

Arrangement arrange_of(const PointRows& points, const RunArguments& run) {
  return call(run, [&](const Run& r) { return arrange(as_points(points), r); });
}

// A new arrangement: arrays over the old one stay as they are.
Arrangement leave_out_stray_of(const Arrangement& arrangement, const Neighbours& neighbours, int least_group,
                               const RunArguments& run) {
  check_neighbours(arrangement.points, neighbours);
  Arrangement left = arrangement;
  call(run, [&](const Run& r) { return leave_out_stray(left, neighbours, r, least_group); });
  return left;
}

Neighbours find_neighbours_of(const PointRows& points, int k, const RunArguments& run) {
  check_finite(as_points(points));
  if (k < 1) throw Error(ErrorCode::BadOption, fmt::format("k is {}; it must be at least 1", k));
  return call(run, [&](const Run& r) { return find_neighbours(as_points(points), k, r); });
}

Array<const Index, -1, -1> ids_of(const Neighbours& neighbours) {
  return {neighbours.ids.data(),
          {static_cast<std::size_t>(neighbours.size()), static_cast<std::size_t>(neighbours.k)},
          nb::find(neighbours)};
}

auto local_spacing_of(const PointRows& points, const Neighbours& neighbours, const RunArguments& run) {
  check_neighbours(as_points(points), neighbours);
  return give(call(run, [&](const Run& r) { return local_spacing(as_points(points), neighbours, r); }));
}

BoundaryScores score_boundary_of(const PointRows& points, const Neighbours& neighbours,
                                 const Options& options, const RunArguments& run) {
  check_neighbours(as_points(points), neighbours);
  return call(
      run, [&](const Run& r) { return score_boundary(as_points(points), neighbours, options.boundary, r); });
}

double score_of(double log_score, const std::string& form) {
  LoopOptions options;
  options.score_form = value_of<ScoreForm>("form", form);
  return score(log_score, options);
}

void check_scores(Points points, const Neighbours& neighbours, const BoundaryScores& scores) {
  check_distinct(points, neighbours);
  check_size(scores.log_score.size(), points.size(), "scores");
}

BoundaryLoops find_boundary_loops_of(const PointRows& points, const Neighbours& neighbours,
                                     const BoundaryScores& scores, const Options& options,
                                     const RunArguments& run) {
  check_scores(as_points(points), neighbours, scores);
  return call(run, [&](const Run& r) {
    return find_boundary_loops(as_points(points), neighbours, scores, options.boundary_loops,
                               options.loops.length_exponent, r);
  });
}

Array<const std::uint8_t, -1> labels_of(const BoundaryLoops& survey) {
  static_assert(sizeof(PointLabel) == 1);
  return {
      reinterpret_cast<const std::uint8_t*>(survey.label.data()), {survey.label.size()}, nb::find(survey)};
}

GeneticLoop find_genetic_loop_of(const PointRows& points, const Neighbours& neighbours,
                                 const BoundaryScores& scores, const Options& options,
                                 const RunArguments& run) {
  check_scores(as_points(points), neighbours, scores);
  return call(run, [&](const Run& r) {
    return find_genetic_loop(as_points(points), neighbours, scores, options.loops, r);
  });
}

double fitness_of(const List<Index>& ids, const BoundaryScores& scores, const Options& options) {
  check_ids(as_span(ids), scores.log_score.size(), "ids");
  return fitness(as_span(ids), scores, options.loops);
}

double loop_length_of(const PointRows& points, const List<Index>& loop) {
  check_ids(as_span(loop), points.shape(0), "loop");
  return loop_length(as_points(points), as_span(loop));
}

std::string story_of(const Arrangement& a) {
  return story("Arrangement", counted(a.points.size(), "point"),
               fmt::format("{} left out", a.not_finite.size() + a.duplicates.size() + a.stray.size()));
}

std::string story_of(const Neighbours& n) {
  return story("Neighbours", fmt::format("{} of each of {}", n.k, counted(n.size(), "point")));
}

std::string story_of(const BoundaryScores& s) {
  return story("BoundaryScores", counted(s.log_score.size(), "point"),
               counted(static_cast<std::size_t>(std::ranges::count(s.candidate, 1)), "candidate"));
}

std::string story_of(const BoundaryLoops& b) {
  return story("BoundaryLoops", counted(b.loops.size(), "loop"), counted(b.triangles.size(), "triangle"));
}

std::string story_of(const GeneticLoop& g) {
  return story("GeneticLoop", counted(g.loop.points.size(), "point"));
}

template <class Stage>
std::string repr(const Stage& stage) {
  return story_of(stage);
}

void add_types(nb::module_& m) {
  nb::class_<Arrangement>(m, "Arrangement")
      .def("__repr__", &repr<Arrangement>)
      .def_prop_ro("points", &Member<&Arrangement::points>::view)
      .def_prop_ro("ids", &Member<&Arrangement::ids>::view)
      .def_prop_ro(
          "origin",
          [](const Arrangement& a) -> Several { return nb::make_tuple(a.origin.x, a.origin.y, a.origin.z); })
      .def_prop_ro("not_finite", &Member<&Arrangement::not_finite>::view)
      .def_prop_ro("duplicates", &Member<&Arrangement::duplicates>::view)
      .def_prop_ro("stray", &Member<&Arrangement::stray>::view);
  nb::class_<Neighbours>(m, "Neighbours")
      .def("__repr__", &repr<Neighbours>)
      .def_ro("k", &Neighbours::k)
      .def_prop_ro("ids", &ids_of);
  nb::class_<BoundaryScores>(m, "BoundaryScores")
      .def("__repr__", &repr<BoundaryScores>)
      .def_prop_ro("log_score", &Member<&BoundaryScores::log_score>::view)
      .def_prop_ro("candidate", &Member<&BoundaryScores::candidate>::view)
      .def_prop_ro("delta", &Member<&BoundaryScores::delta>::view);
  nb::class_<BoundaryLoops>(m, "BoundaryLoops")
      .def("__repr__", &repr<BoundaryLoops>)
      .def_prop_ro(
          "loops", [](const BoundaryLoops& b) { return loops_to_python(b.loops); },
          nb::sig("def loops(self) -> list[rimline._loops.Loop]"))
      .def_prop_ro("probability", &Member<&BoundaryLoops::probability>::view)
      .def_prop_ro("label", &labels_of)
      .def_prop_ro("triangles", &Member<&BoundaryLoops::triangles>::view)
      .def_ro("range_scan", &BoundaryLoops::range_scan);
  nb::class_<GeneticLoop>(m, "GeneticLoop")
      .def("__repr__", &repr<GeneticLoop>)
      .def_prop_ro(
          "loop", [](const GeneticLoop& g) { return nb::object(loops_to_python({g.loop})[0]); },
          nb::sig("def loop(self) -> rimline._loops.Loop"))
      .def_prop_ro("winner", &Member<&GeneticLoop::winner>::view);
}

}  // namespace

void add_boundary_stages(nb::module_& m) {
  add_types(m);
  m.def("arrange", &arrange_of, nb::arg("points"), nb::arg("run"));
  m.def("leave_out_stray", &leave_out_stray_of, nb::arg("arrangement"), nb::arg("neighbours"),
        nb::arg("least_group"), nb::arg("run"));
  m.def("find_neighbours", &find_neighbours_of, nb::arg("points"), nb::arg("k"), nb::arg("run"));
  m.def("local_spacing", &local_spacing_of, nb::arg("points"), nb::arg("neighbours"), nb::arg("run"));
  m.def("score_boundary", &score_boundary_of, nb::arg("points"), nb::arg("neighbours"), nb::arg("options"),
        nb::arg("run"));
  m.def("p_value", &p_value, nb::arg("log_score"));
  m.def("score", &score_of, nb::arg("log_score"), nb::arg("form"));
  m.def("find_boundary_loops", &find_boundary_loops_of, nb::arg("points"), nb::arg("neighbours"),
        nb::arg("scores"), nb::arg("options"), nb::arg("run"));
  m.def("find_genetic_loop", &find_genetic_loop_of, nb::arg("points"), nb::arg("neighbours"),
        nb::arg("scores"), nb::arg("options"), nb::arg("run"));
  m.def("fitness", &fitness_of, nb::arg("ids"), nb::arg("scores"), nb::arg("options"));
  m.def("loop_length", &loop_length_of, nb::arg("points"), nb::arg("loop"));
}

}  // namespace rimline::python
