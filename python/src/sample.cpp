// SPDX-License-Identifier: GPL-3.0-or-later
// Analytic surfaces with their exact boundary, and the camera of the tool's pictures.
#include "rimline/sample.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "arrays.h"
#include "call.h"
#include "loops.h"
#include "names.h"
#include "parts.h"
#include "view.h"

namespace rimline::python {
namespace {

using Triple = std::array<double, 3>;

// Points, boundary, near_boundary, loops.
Several sample_of(const std::string& shape, std::size_t n, const std::string& sampling, double noise,
                  const RunArguments& run) {
  SampleOptions options;
  options.shape = value_of<Shape>("shape", shape);
  options.sampling = value_of<Sampling>("sampling", sampling);
  options.n = n;
  options.noise = noise;
  Sample made = call(run, [&](const Run& r) { return sample(options, r); });
  return nb::make_tuple(give(std::move(made.points)), give(std::move(made.boundary)),
                        give(std::move(made.near_boundary)), loops_to_python(std::move(made.loops)));
}

// The rows of a rotation: to the right, up and toward the eye.
std::array<Triple, 3> choose_view_of(const PointRows& points, const Items& given, Triple front,
                                     std::optional<Triple> up) {
  const auto as_point = [](const Triple& t) { return Point{t[0], t[1], t[2]}; };
  const auto as_triple = [](Point p) { return Triple{p.x, p.y, p.z}; };
  std::optional<Point> upright;
  if (up) upright = as_point(*up);
  const cli::View view = cli::choose_view(as_points(points), loops_from_python(given, points.shape(0)),
                                          as_point(front), upright);
  return {as_triple(view.right), as_triple(view.up), as_triple(view.toward)};
}

}  // namespace

void add_sample(nb::module_& m) {
  m.def("sample", &sample_of, nb::arg("shape"), nb::arg("n"), nb::arg("sampling"), nb::arg("noise"),
        nb::arg("run"));
  m.def("shapes", &names_of<Shape>);
  m.def("samplings", &names_of<Sampling>);
  m.def("choose_view", &choose_view_of, nb::arg("points"), nb::arg("loops"), nb::arg("front"),
        nb::arg("up").none());
}

}  // namespace rimline::python
