// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flip.h"

#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "mesh/cotangent.h"

namespace rimline {
namespace {

class Flipper {
 public:
  Flipper(Points points, Triangulation& mesh, const Run& run,
          const std::function<bool(Index, Index)>& may_join)
      : may_join_(may_join),
        points_(points),
        mesh_(mesh),
        run_(run),
        queued_(mesh.triangles.size(), 0),
        settled_(mesh.triangles.size(), 0) {}

  std::size_t flip_all() {
    find_settled();
    queue_.reserve(mesh_.triangles.size());
    for (Index t = 0; t < mesh_.size(); ++t) {
      queued_[t] = 1;
      queue_.push_back(t);
    }
    std::size_t flips = 0;
    // Flips in space need not terminate as those in the plane do; far fewer flips than this are ever needed.
    const std::size_t most = 50 * mesh_.triangles.size();
    for (std::size_t at = 0; at < queue_.size() && flips < most; ++at) {
      if (at % 65536 == 0) run_.check_cancel();
      const Index t = queue_[at];
      queued_[t] = 0;
      if (settled_[t]) continue;
      for (int c = 0; c < 3; ++c) {
        if (wants_flip(t, c) && flip(t, c)) {
          ++flips;
          break;
        }
      }
    }
    return flips;
  }

 private:
  // Most triangles of a good start need no flip. All are tested in parallel here; the queue tests those again
  // that need one, and those that were changed, or whose neighbour was, by a flip.
  void find_settled() {
    constexpr std::size_t few = 4096;  // not worth a second thread
    if (mesh_.triangles.size() < few) return;
    parallel_for_each(mesh_.triangles.size(), Stage::Refine, run_, [&](Index t) {
      settled_[t] = !wants_flip(t, 0) && !wants_flip(t, 1) && !wants_flip(t, 2);
    });
  }

  void push(Index t) {
    settled_[t] = 0;
    if (queued_[t]) return;
    queued_[t] = 1;
    queue_.push_back(t);
  }

  bool wants_flip(Index t, int c) const {
    constexpr double tie = 1e-9;  // tolerance of the cotangents' sum: squares keep their diagonal
    const Index other = mesh_.adjacent[t][c];
    if (other == none) return false;
    const Triangle& v = mesh_.triangles[t];
    const Index apex = mesh_.triangles[other][mesh_.corner_across(other, t)];
    const Point a = points_[v[next(c)]], b = points_[v[previous(c)]];
    return cotangent(points_[v[c]], a, b) + cotangent(points_[apex], a, b) < -tie;
  }

  // Whether an edge joins corner `c` of triangle t to vertex `w`: walks around the corner, both ways where
  // the boundary is met.
  bool joined(Index t, int c, Index w) const {
    const Index v = mesh_.triangles[t][c];
    for (const bool forward : {true, false}) {
      Index at = t;
      while (true) {
        const int k = mesh_.corner_of(at, v);
        const Triangle& x = mesh_.triangles[at];
        if (x[next(k)] == w || x[previous(k)] == w) return true;
        at = mesh_.adjacent[at][forward ? next(k) : previous(k)];
        if (at == t) return false;
        if (at == none) break;
      }
    }
    return false;
  }

  // Whether the two triangles along p q, in place of those along a b, would face away from each other while
  // those do not.
  bool folds(Index p, Index a, Index q, Index b) const {
    const Point x = points_[p], y = points_[a], z = points_[q], w = points_[b];
    const auto facing = [](Point e, Point f, Point g, Point h) { return dot(cross(e, f), cross(g, h)); };
    return facing(y - x, z - x, w - z, x - z) < 0 && facing(y - x, w - x, w - z, y - z) >= 0;
  }

  // Replaces the edge opposite to corner c of t by the other diagonal of its two triangles.
  bool flip(Index t, int c) {
    const Index other = mesh_.adjacent[t][c];
    const int d = mesh_.corner_across(other, t);
    const Index p = mesh_.triangles[t][c], q = mesh_.triangles[other][d];
    if (p == q || joined(t, c, q)) return false;
    if (may_join_ && !may_join_(p, q)) return false;
    const Index a = mesh_.triangles[t][next(c)], b = mesh_.triangles[t][previous(c)];
    if (folds(p, a, q, b)) return false;
    const Index beyond_a = mesh_.adjacent[t][next(c)];         // across the edge b p
    const Index beyond_b = mesh_.adjacent[t][previous(c)];     // across the edge p a
    const Index other_a = mesh_.adjacent[other][previous(d)];  // across the edge q b
    const Index other_b = mesh_.adjacent[other][next(d)];      // across the edge a q
    mesh_.triangles[t] = {p, a, q};
    mesh_.adjacent[t] = {other_b, other, beyond_b};
    mesh_.triangles[other] = {q, b, p};
    mesh_.adjacent[other] = {beyond_a, t, other_a};
    relink(other_b, other, t);
    relink(beyond_a, t, other);
    push(t);
    push(other);
    for (const Index near : {beyond_a, beyond_b, other_a, other_b}) {
      if (near != none) push(near);
    }
    return true;
  }

  void relink(Index triangle, Index before, Index after) {
    if (triangle != none) mesh_.adjacent[triangle][mesh_.corner_across(triangle, before)] = after;
  }

  const std::function<bool(Index, Index)>& may_join_;
  Points points_;
  Triangulation& mesh_;
  const Run& run_;
  std::vector<char> queued_;
  std::vector<char> settled_;
  std::vector<Index> queue_;
};

}  // namespace

std::size_t flip_edges(Points points, Triangulation& mesh, const Run& run,
                       const std::function<bool(Index, Index)>& may_join) {
  return Flipper(points, mesh, run, may_join).flip_all();
}

}  // namespace rimline
