// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/final_map.h"

#include <optional>
#include <utility>

#include "base/domain_traits.h"
#include "map/conformal_descent.h"
#include "map/domain.h"
#include "map/embed.h"
#include "map/free_map.h"
#include "map/outline_crossings.h"

namespace rimline {
namespace {

std::vector<UV> of_points(Points points, const std::vector<UV>& uv) {
  return {uv.begin(), uv.begin() + static_cast<std::ptrdiff_t>(points.size())};
}

// Maps to the outline given by `uv`.
FinalMap map_to_outline(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                        const RefineOptions& options, std::vector<UV> uv, const Run& run) {
  constexpr int repairs = 8;
  const Embedding embedding = embed(points, mesh, loops, options.residual, repairs, uv, run);
  return {of_points(points, uv), traits(options.domain).released ? Domain::Disc : options.domain,
          embedding.map, embedding.flips, embedding.evened};
}

void lay_out(Points points, const Triangulation& mesh, const std::vector<Loop>& loops, FinalMap& map) {
  map.kind = Domain::Free;
  lay_level(points, loops.front().points, map.uv);
  scale_to_area(points, mesh, map.uv);
}

// Least squares, which may flip triangles where the mesh folds, make them nearly flat in uv, or cross the
// outline: none where it does.
std::optional<FinalMap> map_freely(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                                   const Run& run) {
  constexpr double flat = 1.05, little = 1e-3;
  for (const double least : {0.0, little}) {  // the second bound leaves no inner edge without weight
    FinalMap map;
    map.summary = free_map(points, mesh, loops.front().points, least, map.uv, run);
    if (!flipped_triangles(mesh.triangles, map.uv, run).empty()) continue;
    if (!crossing_points(loops, map.uv).empty() || conformal_distortion(points, mesh, map.uv) > flat)
      return {};
    lay_out(points, mesh, loops, map);
    return map;
  }
  return {};
}

}  // namespace

FinalMap final_map(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                   const RefineOptions& options, std::vector<UV> uv, const Run& run) {
  if (traits(options.domain).released) {
    if (auto map = map_freely(points, mesh, loops, run)) return std::move(*map);
  } else if (traits(options.domain).outline == Outline::Box) {
    place_outline(points, loops.front().points, options.domain, options.corners, uv);
  }
  FinalMap map = map_to_outline(points, mesh, loops, options, std::move(uv), run);
  if (!traits(options.domain).released) return map;
  // Starts from the disc's map, which has no flips and no crossings, and keeps it so.
  if (map.flips == 0 && relax_conformally(points, mesh, loops, {}, map.uv, run) > 0) {
    lay_out(points, mesh, loops, map);
  } else {
    scale_to_area(points, mesh, map.uv);
  }
  return map;
}

}  // namespace rimline
