// SPDX-License-Identifier: GPL-3.0-or-later
// The method from end to end. Results are dictionaries under the names of the C++ members; the package makes
// its objects of them (python/rimline/_results.py).
#include "rimline/pipeline.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "arrays.h"
#include "call.h"
#include "distortion.h"
#include "loops.h"
#include "parts.h"

namespace rimline::python {
namespace {

std::vector<Point> copied(const PointRows& rows) {
  const Points points = as_points(rows);
  return {points.begin(), points.end()};
}

Given given_of(const Dict& arguments, std::size_t point_count) {
  Given given;
  if (arguments.contains("normals")) given.normals = copied(nb::cast<PointRows>(arguments["normals"]));
  if (arguments.contains("raster"))
    given.raster = raster_of(nb::cast<Dict>(arguments["raster"]), point_count);
  if (arguments.contains("loops")) {
    given.loops = loops_from_python(nb::cast<nb::list>(arguments["loops"]), point_count);
  }
  if (arguments.contains("reference")) {
    const auto [name, points, triangles] =
        nb::cast<std::tuple<std::string, PointRows, TriangleRows>>(arguments["reference"]);
    given.reference = {name, copied(points), as_triangles(triangles)};
    for (const Triangle& t : given.reference.triangles)
      check_ids(t, points.shape(0), "a triangle of the reference");
  }
  return given;
}

// Nothing where the preset does not give it.
template <class Vector>
void put_if_any(Dict& made, const char* name, Vector&& values) {
  if (values.empty()) {
    made[name] = nb::none();
  } else {
    made[name] = give(std::forward<Vector>(values));
  }
}

void put_labels(Dict& made, const std::vector<PointLabel>& label) {
  std::vector<std::uint8_t> numbers(label.size());
  std::ranges::transform(label, numbers.begin(), [](PointLabel l) { return static_cast<std::uint8_t>(l); });
  put_if_any(made, "label", std::move(numbers));
}

void put_boundary(Dict& made, BoundaryResult result) {
  made["boundary"] = give(std::move(result.boundary));
  made["loop"] = give(std::move(result.loop));
  made["candidate"] = give(std::move(result.candidate));
  made["p_value"] = give(std::move(result.p_value));
  made["score"] = give(std::move(result.score));
  put_if_any(made, "boundary_probability", std::move(result.boundary_probability));
  put_labels(made, result.label);
  made["report"] = to_json(result.report);
  made["loops"] = loops_to_python(std::move(result.loops));
}

Dict find_boundary_of(const PointRows& points, const Options& options, const RunArguments& run,
                      const Dict& arguments) {
  const Given given = given_of(arguments, points.shape(0));
  Dict made;
  put_boundary(made,
               call(run, [&](const Run& r) { return find_boundary(as_points(points), options, r, given); }));
  return made;
}

Dict parameterize_of(const PointRows& points, const Options& options, const RunArguments& run,
                     const Dict& arguments) {
  const Given given = given_of(arguments, points.shape(0));
  auto result = call(run, [&](const Run& r) { return parameterize(as_points(points), options, r, given); });
  Dict made;
  put_boundary(made, std::move(result.boundary));
  made["uv"] = give(std::move(result.uv));
  return made;
}

Dict reconstruct_of(const PointRows& points, const Options& options, const RunArguments& run,
                    const Dict& arguments) {
  const Given given = given_of(arguments, points.shape(0));
  auto result = call(run, [&](const Run& r) { return reconstruct(as_points(points), options, r, given); });
  Dict made;
  put_boundary(made, std::move(result.boundary));
  made["uv"] = give(std::move(result.uv));
  made["added"] = give(std::move(result.added));
  made["triangles"] = give(std::move(result.triangles));
  put_if_any(made, "seam_uv", std::move(result.seams.uv));
  put_if_any(made, "seam_point", std::move(result.seams.point));
  put_if_any(made, "corners", std::move(result.seams.corners));
  put_if_any(made, "chart", std::move(result.chart));
  put_if_any(made, "patch", std::move(result.patch));
  put_if_any(made, "filled", std::move(result.filled));
  made["distortion"] = distortion_values(std::move(result.distortion.point));
  made["triangle_distortion"] = distortion_values(std::move(result.distortion.triangle));
  return made;
}

}  // namespace

void add_pipeline(nb::module_& m) {
  nb::enum_<PointLabel>(m, "PointLabel", nb::is_arithmetic())
      .value("Interior", PointLabel::Interior)
      .value("Boundary", PointLabel::Boundary)
      .value("Undersampled", PointLabel::Undersampled)
      .value("Crease", PointLabel::Crease)
      .value("Stray", PointLabel::Stray);
  m.def("find_boundary", &find_boundary_of, nb::arg("points"), nb::arg("options"), nb::arg("run"),
        nb::arg("given"));
  m.def("parameterize", &parameterize_of, nb::arg("points"), nb::arg("options"), nb::arg("run"),
        nb::arg("given"));
  m.def("reconstruct", &reconstruct_of, nb::arg("points"), nb::arg("options"), nb::arg("run"),
        nb::arg("given"));
}

}  // namespace rimline::python
