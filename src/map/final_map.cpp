// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/final_map.h"

#include <optional>
#include <utility>

#include "base/domain_traits.h"
#include "map/domain.h"
#include "map/embed.h"
#include "map/free_map.h"
#include "rimline/map_by_charts.h"

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

// As map_by_charts() does in one chart; none where it has none.
std::optional<FinalMap> map_freely(Points points, const Triangulation& mesh, double residual,
                                   const Run& run) {
  const ChartedMap charted = map_by_charts(points, mesh.triangles, {.charts = 1, .residual = residual}, run);
  if (charted.charts != 1 || charted.uv.size() > points.size()) return {};
  FinalMap map;
  map.uv.resize(points.size());
  for (std::size_t i = 0; i < charted.uv.size(); ++i) map.uv[charted.vertex[i]] = charted.uv[i];
  map.kind = charted.kind;
  map.summary = charted.summary;
  return map;
}

}  // namespace

FinalMap final_map(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                   const RefineOptions& options, std::vector<UV> uv, const Run& run) {
  const DomainTraits domain = traits(options.domain);
  if (domain.released) {
    if (auto map = map_freely(points, mesh, options.residual, run)) return std::move(*map);
  } else if (domain.outline == Outline::Box) {
    place_outline(points, loops.front().points, options.domain, options.corners, uv);
  }
  FinalMap map = map_to_outline(points, mesh, loops, options, std::move(uv), run);
  if (domain.released) scale_to_area(points, mesh, map.uv);
  return map;
}

}  // namespace rimline
