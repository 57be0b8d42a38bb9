// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.h"

#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "base/vec.h"

namespace rimline {
namespace {

Point normal_of(Points points, const Triangle& t) { return triangle_normal(points, t); }

bool folded(Point a, Point b) {
  const double d = dot(a, b);
  return d < 0 && d * d > 0.25 * dot(a, a) * dot(b, b);
}

// Each edge counts at the later of its triangles.
EdgeQuality quality_of(Points points, const Triangulation& mesh, std::span<const double> spacing, Index begin,
                       Index end) {
  EdgeQuality quality;
  for (Index t = begin; t < end; ++t) {
    const Triangle& v = mesh.triangles[t];
    const Point normal = normal_of(points, v);
    for (int c = 0; c < 3; ++c) {
      const Index other = mesh.adjacent[t][c];
      if (other == none || other > t) continue;
      const Index a = v[next(c)], b = v[previous(c)];
      const double length = distance(points[a], points[b]);
      quality.length += length;
      if (length > 3 * std::max(spacing[a], spacing[b]) ||
          folded(normal, normal_of(points, mesh.triangles[other])))
        ++quality.bad;
    }
  }
  return quality;
}

}  // namespace

EdgeQuality edge_quality(Points points, const Triangulation& mesh, std::span<const double> spacing,
                         const Run& run) {
  constexpr Index slice = 8192;  // of the sums: it does not depend on the number of threads
  std::vector<EdgeQuality> slices((mesh.triangles.size() + slice - 1) / slice);
  parallel_tasks(slices.size(), Stage::Refine, run, [&](std::size_t k) {
    const Index begin = static_cast<Index>(k) * slice;
    slices[k] = quality_of(points, mesh, spacing, begin, std::min(mesh.size(), begin + slice));
  });
  EdgeQuality all;
  for (const EdgeQuality& part : slices) {
    all.length += part.length;
    all.bad += part.bad;
  }
  return all;
}

}  // namespace rimline
