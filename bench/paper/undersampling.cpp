// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/undersampling.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

#include "base/union_find.h"
#include "rimline/io.h"
#include "rimline/pipeline.h"

namespace rimline::bench {
namespace {

using Json = nlohmann::ordered_json;

// The rim that each vertex of a mesh lies on, by one of its points; `none` inside.
std::vector<Index> rims_of(const MeshFile& mesh) {
  std::map<std::pair<Index, Index>, int> count;
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) ++count[std::minmax(t[c], t[(c + 1) % 3])];
  }
  UnionFind joined(mesh.cloud.points.size());
  std::vector<Index> rim(mesh.cloud.points.size(), none);
  for (const auto& [ends, triangles] : count) {
    if (triangles != 1) continue;
    joined.join(ends.first, ends.second);
    rim[ends.first] = rim[ends.second] = 0;
  }
  for (Index v = 0; v < static_cast<Index>(rim.size()); ++v) {
    if (rim[v] != none) rim[v] = joined.find(v);
  }
  return rim;
}

}  // namespace

Json measure_undersampling(const PointSet& set, const BoundaryScores& scores) {
  if (set.creases.empty()) return nullptr;
  std::vector<Index> everything(set.points.size()), all, flagged;
  std::iota(everything.begin(), everything.end(), 0);
  const std::vector<char> at_rim = near(set, everything, set.rim);
  for (const Index i : everything) {
    if (at_rim[i] != 0) continue;
    all.push_back(i);
    if (scores.candidate[i] != 0) flagged.push_back(i);
  }
  std::size_t found = 0;
  for (const Index i : set.creases) found += scores.candidate[i];
  return {{"undersampled", flagged.size()},
          {"on_creases", share_near(set, flagged, set.creases)},
          {"creases", share_near(set, all, set.creases)},
          {"found", static_cast<double>(found) / static_cast<double>(set.creases.size())}};
}

Json measure_windows(const std::string& path, const std::string& truth) {
  if (truth.empty() || !std::filesystem::exists(truth)) return nullptr;
  const MeshFile mesh = read_mesh(truth, {});
  const Cloud cloud = read_cloud(path, {});
  if (mesh.cloud.points != cloud.points) return nullptr;
  const std::vector<Index> rim = rims_of(mesh);
  std::map<Index, std::size_t> size, fills;
  for (const Index r : rim) {
    if (r != none) ++size[r];
  }
  const ReconstructResult result = reconstruct(cloud.points, preset_options(Preset::Paper), {});
  for (const auto& [a, b, c] : result.triangles) {
    if (rim[a] != none && rim[a] == rim[b] && rim[b] == rim[c]) ++fills[rim[a]];
  }
  const auto outer = std::max_element(size.begin(), size.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  std::size_t filled = 0;
  for (const auto& [r, count] : size) filled += r != outer->first && fills[r] > 0;
  const MeshSummary& made = result.boundary.report.mesh;
  return {{"holes", size.size() - 1},      {"filled", filled},
          {"euler", made.euler},           {"loops", made.boundary_loops},
          {"long_edges", made.long_edges}, {"triangles", made.triangles}};
}

}  // namespace rimline::bench
