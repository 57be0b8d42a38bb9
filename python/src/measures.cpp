// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of meshes, and what a run will take.
#include <cmath>

#include "arrays.h"
#include "call.h"
#include "checks.h"
#include "distortion.h"
#include "loops.h"
#include "parts.h"
#include "rimline/measure.h"
#include "rimline/memory.h"

namespace rimline::python {
namespace {

// Points and triangles over them, checked.
struct Mesh {
  Points points;
  std::vector<Triangle> triangles;

  Mesh(const PointRows& rows, const TriangleRows& ids)
      : points(as_points(rows)), triangles(as_triangles(ids)) {
    check_triangles(triangles, points.size());
    for (const Triangle& t : triangles) {
      for (const Index v : t) {
        if (!is_finite(points[v])) throw nb::value_error("points of triangles must be finite");
      }
    }
  }
};

Dict as_dict(const DistortionSummary& d) {
  Dict made;
  made["angle_mean"] = d.angle_mean;
  made["angle_most"] = d.angle_most;
  made["area_least"] = d.area_least;
  made["area_most"] = d.area_most;
  made["area_mean_log"] = d.area_mean_log;
  made["stretch_l2"] = d.stretch_l2;
  made["stretch_linf"] = d.stretch_linf;
  return made;
}

Dict as_dict(const MeshSummary& mesh) {
  Dict made;
  made["triangles"] = mesh.triangles;
  made["points_used"] = mesh.points_used;
  made["edges"] = mesh.edges;
  made["euler"] = mesh.euler;
  made["components"] = mesh.components;
  made["boundary_loops"] = mesh.boundary_loops;
  made["boundary_edges"] = mesh.boundary_edges;
  made["nonmanifold_edges"] = mesh.nonmanifold_edges;
  made["nonmanifold_vertices"] = mesh.nonmanifold_vertices;
  made["area"] = mesh.area;
  made["long_edges"] = mesh.long_edges;
  made["uv_flips"] = mesh.uv_flips;
  made["mean_angle_distortion"] = mesh.mean_angle_distortion;
  return made;
}

Dict measure_mesh_of(const PointRows& points, const TriangleRows& ids, const List<double>& spacing,
                     const UvRows& uv, const RunArguments& run) {
  const Mesh mesh(points, ids);
  check_size(spacing.shape(0), points.shape(0), "spacing");
  if (uv.shape(0) > 0) check_size(uv.shape(0), points.shape(0), "uv");
  return as_dict(call(run, [&](const Run& r) {
    return measure_mesh(mesh.points, mesh.triangles, as_span(spacing), as_uv(uv), r);
  }));
}

// Summary, values of the triangles, values of the points.
Several measure_distortion_of(const PointRows& points, const TriangleRows& ids, const UvRows& uv,
                              const RunArguments& run) {
  const Mesh mesh(points, ids);
  check_size(uv.shape(0), points.shape(0), "uv");
  Distortion found = call(run, [&](const Run& r) {
    return measure_distortion(mesh.points, mesh.triangles, as_uv(uv), {}, 1, r);
  });
  return nb::make_tuple(as_dict(found.whole), distortion_values(std::move(found.triangle)),
                        distortion_values(std::move(found.point)));
}

auto find_self_intersections_of(const PointRows& points, const TriangleRows& ids, const RunArguments& run) {
  const Mesh mesh(points, ids);
  return give(
      call(run, [&](const Run& r) { return find_self_intersections(mesh.points, mesh.triangles, r); }));
}

double edge_agreement_of(const TriangleRows& a, const TriangleRows& b) {
  return edge_agreement(as_triangles(a), as_triangles(b));
}

Dict distance_of(const PointRows& points, const TriangleRows& ids, const PointRows& other_points,
                 const TriangleRows& other_ids, const RunArguments& run) {
  const Mesh from(points, ids), to(other_points, other_ids);
  const DistanceSummary found = call(run, [&](const Run& r) {
    return SurfaceDistance(to.points, to.triangles).from(from.points, from.triangles, r);
  });
  Dict made;
  made["mean"] = found.mean;
  made["rms"] = found.rms;
  made["most"] = found.most;
  return made;
}

Dict summarize_spacing_of(const List<double>& spacing) {
  const auto values = as_span(spacing);
  const SpacingSummary found = summarize_spacing({values.begin(), values.end()});
  Dict made;
  made["mean"] = found.mean;
  made["least"] = found.least;
  made["most"] = found.most;
  made["low"] = found.low;
  made["high"] = found.high;
  return made;
}

Dict estimate_memory_of(std::size_t points, const Options& options) {
  Dict made;
  for (const StageMemory& stage : estimate_memory(points, options)) made[name(stage.stage)] = stage.bytes;
  return made;
}

}  // namespace

Dict distortion_values(Distortion::Values values) {
  Dict made;
  made["angle"] = give(std::move(values.angle));
  made["area"] = give(std::move(values.area));
  made["stretch"] = give(std::move(values.stretch));
  made["max_stretch"] = give(std::move(values.max_stretch));
  return made;
}

void add_measures(nb::module_& m) {
  m.def("measure_mesh", &measure_mesh_of, nb::arg("points"), nb::arg("triangles"), nb::arg("spacing"),
        nb::arg("uv"), nb::arg("run"));
  m.def("measure_distortion", &measure_distortion_of, nb::arg("points"), nb::arg("triangles"), nb::arg("uv"),
        nb::arg("run"));
  m.def("find_self_intersections", &find_self_intersections_of, nb::arg("points"), nb::arg("triangles"),
        nb::arg("run"));
  m.def("edge_agreement", &edge_agreement_of, nb::arg("a"), nb::arg("b"));
  m.def("surface_distance", &distance_of, nb::arg("points"), nb::arg("triangles"), nb::arg("other_points"),
        nb::arg("other_triangles"), nb::arg("run"));
  m.def("summarize_spacing", &summarize_spacing_of, nb::arg("spacing"));
  m.def("estimate_memory", &estimate_memory_of, nb::arg("points"), nb::arg("options"));
}

}  // namespace rimline::python
