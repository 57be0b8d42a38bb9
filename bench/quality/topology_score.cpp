// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/topology_score.h"

#include <algorithm>

#include "rimline/boundary_loops.h"
#include "rimline/sample.h"

namespace rimline::bench {
namespace {

bool says(const Outcome& outcome, const char* word) {
  return (outcome.error + " " + outcome.mesh_error).find(word) != std::string::npos;
}

// The word that a refusal of the shape must have; nullptr for the pipe, which is an annulus.
const char* word_for(const std::string& shape) {
  if (shape == name(Shape::ClosedSphere)) return "closed";
  if (shape == name(Shape::TorusMinusCap)) return "handle";
  if (shape == name(Shape::MoebiusStrip)) return "orient";
  return nullptr;
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
  const auto loops = connected_pieces(boundary_of(edges_of_mesh(outcome.mesh))).size();
  const char* word = word_for(c.name.shape);
  const bool named = !accepted && word != nullptr && says(outcome, word);
  const bool right = word == nullptr ? accepted && loops == 2 : named;
  return {{"accepted", accepted}, {"named", named}, {"verdict_right", right}};
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
