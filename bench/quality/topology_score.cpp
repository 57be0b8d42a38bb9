// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/topology_score.h"

#include <algorithm>

#include "rimline/boundary_loops.h"
#include "rimline/sample.h"

namespace rimline::bench {
namespace {

struct Shown {
  long long euler;
  std::size_t loops;
};

// Of the shapes of the group "topology".
Shown shown_by(const std::string& shape) {
  if (shape == name(Shape::ClosedSphere)) return {2, 0};
  if (shape == name(Shape::TorusMinusCap)) return {-1, 1};
  if (shape == name(Shape::MoebiusStrip)) return {0, 1};
  return {0, 2};  // the pipe, an annulus
}

long long euler_of(const std::vector<Triangle>& mesh, std::size_t edges) {
  std::vector<Index> used;
  for (const Triangle& t : mesh) used.insert(used.end(), t.begin(), t.end());
  std::ranges::sort(used);
  const auto last = std::unique(used.begin(), used.end());
  return (last - used.begin()) - static_cast<long long>(edges) + static_cast<long long>(mesh.size());
}

bool is_labelled(const EdgeSet& loop, const std::vector<std::uint8_t>& label) {
  constexpr double most_of_them = 0.8;
  std::size_t undersampled = 0;  // over both ends of every edge: each point of a simple loop twice
  for (const Edge& e : loop) {
    for (const Index id : {e.a, e.b}) undersampled += label[id] == static_cast<int>(PointLabel::Undersampled);
  }
  return static_cast<double>(undersampled) >= most_of_them * 2 * static_cast<double>(loop.size());
}

}  // namespace

Metrics score_verdict(const Case& c, const Outcome& outcome) {
  const bool accepted = !outcome.mesh.empty();
  const MeshEdges edges = edges_of_mesh(outcome.mesh);
  const Shown shown = shown_by(c.name.shape);
  const bool right = accepted && connected_pieces(boundary_of(edges)).size() == shown.loops &&
                     euler_of(outcome.mesh, edges.edges.size()) == shown.euler;
  return {{"accepted", accepted}, {"verdict_right", right}};
}

Metrics score_labels(const Case& c, const Outcome& outcome) {
  if (!c.has_loops) return {};
  std::size_t good = 0;
  for (const EdgeSet& loop : c.loops) {
    const bool covered = std::any_of(outcome.loops.begin(), outcome.loops.end(),
                                     [&](const auto& found) { return is_covered(c, loop, found); });
    good += covered || is_labelled(loop, outcome.label);
  }
  return {{"loops_found_or_labelled", static_cast<double>(good)}};
}

}  // namespace rimline::bench
