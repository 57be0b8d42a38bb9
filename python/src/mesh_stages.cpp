// SPDX-License-Identifier: GPL-3.0-or-later
// The stages from the loops to the mesh, each alone.
#include <nanobind/stl/string.h>

#include <cmath>
#include <string>

#include "arrays.h"
#include "call.h"
#include "checks.h"
#include "loops.h"
#include "members.h"
#include "parts.h"
#include "rimline/delaunay.h"
#include "rimline/map_to_disc.h"
#include "rimline/refine_surface.h"
#include "story.h"

namespace rimline::python {
namespace {

auto circle_by_chord_length_of(const PointRows& points, const List<Index>& loop) {
  check_finite(as_points(points));
  check_ids(as_span(loop), points.shape(0), "loop");
  return give(circle_by_chord_length(as_points(points), as_span(loop)));
}

DiscMap map_to_disc_of(const PointRows& points, const Neighbours& neighbours, const List<Index>& loop,
                       const Options& options, const RunArguments& run) {
  check_distinct(as_points(points), neighbours);
  check_ids(as_span(loop), points.shape(0), "loop");
  return call(run, [&](const Run& r) {
    return map_to_disc(as_points(points), neighbours, as_span(loop), options.map, r);
  });
}

auto delaunay_of(const UvRows& uv, const RunArguments& run) {
  for (const UV p : as_uv(uv)) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v)) throw nb::value_error("uv must be finite");
  }
  return give(call(run, [&](const Run& r) { return delaunay(as_uv(uv), r); }));
}

// The triangles as they face then, and whether they were turned.
Several orient_mesh_of(const PointRows& points, const TriangleRows& rows, const PointRows& normals,
                       const Options& options) {
  std::vector<Triangle> triangles = as_triangles(rows);
  check_triangles(triangles, points.shape(0));
  if (normals.shape(0) > 0) check_size(normals.shape(0), points.shape(0), "normals");
  const bool turned = orient_mesh(as_points(points), triangles, as_points(normals), options.mesh.up);
  return nb::make_tuple(give(std::move(triangles)), turned);
}

RefineOptions refine_options(const Options& options, bool leave_beside) {
  return {.domain = options.map.domain,
          .corners = options.map.corners,
          .rounds = options.mesh.refine_rounds,
          .residual = options.map.residual,
          .leave_beside = leave_beside,
          .handles = options.mesh.handles,
          .holes = options.mesh.holes,
          .fill_points = options.mesh.fill_points};
}

Patch refine_patch_of(const PointRows& points, const Neighbours& neighbours, const Items& given,
                      const Options& options, const RunArguments& run) {
  check_distinct(as_points(points), neighbours);
  const std::vector<Loop> loops = loops_from_python(given, points.shape(0));
  if (loops.empty()) throw Error(ErrorCode::NoClosedLoop, "a patch has at least one loop; none is given");
  return call(run, [&](const Run& r) {
    return refine_patch(as_points(points), neighbours, loops, refine_options(options, false), r);
  });
}

Surface refine_surface_of(const PointRows& points, const Neighbours& neighbours, const Items& given,
                          const TriangleRows& rows, bool leave_beside, const Options& options,
                          const RunArguments& run) {
  check_distinct(as_points(points), neighbours);
  const std::vector<Loop> loops = loops_from_python(given, points.shape(0));
  const std::vector<Triangle> triangles = as_triangles(rows);
  check_triangles(triangles, points.shape(0));
  return call(run, [&](const Run& r) {
    return refine_surface(as_points(points), neighbours, loops, triangles,
                          refine_options(options, leave_beside), r);
  });
}

}  // namespace

void add_mesh_stages(nb::module_& m) {
  nb::class_<MapSummary>(m, "MapSummary")
      .def_ro("unknowns", &MapSummary::unknowns)
      .def_ro("iterations", &MapSummary::iterations)
      .def_ro("residual", &MapSummary::residual);
  nb::class_<DiscMap>(m, "DiscMap")
      .def("__repr__", [](const DiscMap& d) { return story("DiscMap", counted(d.uv.size(), "point")); })
      .def_prop_ro("uv", &Member<&DiscMap::uv>::view)
      .def_ro("summary", &DiscMap::summary);
  nb::class_<Patch>(m, "Patch")
      .def("__repr__",
           [](const Patch& p) {
             return story("Patch", counted(p.triangles.size(), "triangle"),
                          fmt::format("domain {}", name(p.domain)));
           })
      .def_prop_ro("triangles", &Member<&Patch::triangles>::view)
      .def_prop_ro("uv", &Member<&Patch::uv>::view)
      .def_prop_ro("added", &Member<&Patch::added>::view)
      .def_prop_ro("domain", [](const Patch& p) { return name(p.domain); })
      .def_ro("map", &Patch::map)
      .def_ro("uv_flips", &Patch::uv_flips)
      .def_ro("evened", &Patch::evened);
  nb::class_<Surface>(m, "Surface")
      .def("__repr__",
           [](const Surface& s) {
             return story("Surface", counted(s.triangles.size(), "triangle"), counted(s.loops.size(), "loop"),
                          fmt::format("{} points left out", s.left_out.size()));
           })
      .def_prop_ro(
          "loops", [](const Surface& s) { return loops_to_python(s.loops); },
          nb::sig("def loops(self) -> list[rimline._loops.Loop]"))
      .def_prop_ro("triangles", &Member<&Surface::triangles>::view)
      .def_prop_ro("triangle_patch", &Member<&Surface::triangle_patch>::view)
      .def_prop_ro("added", &Member<&Surface::added>::view)
      .def_prop_ro("uv", &Member<&Surface::uv>::view)
      .def_prop_ro("patch", &Member<&Surface::patch>::view)
      .def_prop_ro("left_out", &Member<&Surface::left_out>::view);
  m.def("circle_by_chord_length", &circle_by_chord_length_of, nb::arg("points"), nb::arg("loop"));
  m.def("map_to_disc", &map_to_disc_of, nb::arg("points"), nb::arg("neighbours"), nb::arg("loop"),
        nb::arg("options"), nb::arg("run"));
  m.def("delaunay", &delaunay_of, nb::arg("uv"), nb::arg("run"));
  m.def("orient_mesh", &orient_mesh_of, nb::arg("points"), nb::arg("triangles"), nb::arg("normals"),
        nb::arg("options"));
  m.def("refine_patch", &refine_patch_of, nb::arg("points"), nb::arg("neighbours"), nb::arg("loops"),
        nb::arg("options"), nb::arg("run"));
  m.def("refine_surface", &refine_surface_of, nb::arg("points"), nb::arg("neighbours"), nb::arg("loops"),
        nb::arg("surface_triangles"), nb::arg("leave_beside"), nb::arg("options"), nb::arg("run"));
}

}  // namespace rimline::python
