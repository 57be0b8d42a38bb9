// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/repair.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/vec.h"
#include "mesh/close_ring.h"
#include "mesh/components.h"
#include "mesh/insert.h"

namespace rimline {
namespace {

constexpr std::size_t largest_gap = 200;   // points of its ring: an eighth of a second to close
constexpr std::size_t least_covered = 99;  // percent of the points; with fewer a map is needed

// The open edges of a mesh that leave each vertex. Triangles lie on their left.
struct Rim {
  std::vector<Index> next, triangle;  // per vertex; none inside
  std::vector<Index> pinched;         // vertices that more than one open edge leaves

  Rim(const Triangulation& mesh, std::size_t vertices) : next(vertices, none), triangle(vertices, none) {
    for (Index t = 0; t < mesh.size(); ++t) {
      for (int c = 0; c < 3; ++c) {
        if (mesh.adjacent[t][c] != none) continue;
        const Index from = mesh.triangles[t][rimline::next(c)], to = mesh.triangles[t][previous(c)];
        if (next[from] != none) pinched.push_back(from);
        next[from] = to;
        triangle[from] = t;
      }
    }
  }
};

class Mender {
 public:
  Mender(Points points, const std::vector<Loop>& loops, std::vector<Triangle> triangles)
      : points_(points),
        loops_(loops),
        loop_next_(points.size(), none),
        mesh_(triangulation_of(std::move(triangles), static_cast<Index>(points.size()))) {
    for (const Loop& loop : loops) {
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        loop_next_[loop.points[i]] = loop.points[next_in(i, loop.points.size())];
    }
  }

  bool mend() { return is_manifold() && cut_pinches() && keep_sheet() && close_gaps(); }
  Triangulation take() { return std::move(mesh_); }

 private:
  // Whether the triangles are an oriented manifold: no edge has three triangles, or two that run along it
  // in the same direction.
  bool is_manifold() const {
    for (Index t = 0; t < mesh_.size(); ++t) {
      for (const Index other : mesh_.adjacent[t]) {
        if (other == none) continue;
        const std::array<Index, 3>& back = mesh_.adjacent[other];
        if (back[0] != t && back[1] != t && back[2] != t) return false;
      }
    }
    return true;
  }

  // Leaves one fan at each vertex. Removing a fan can leave two at another vertex, so that the test is
  // repeated.
  bool cut_pinches() {
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<Index> pinched = Rim(mesh_, points_.size()).pinched;
      if (pinched.empty()) return true;
      std::sort(pinched.begin(), pinched.end());
      pinched.erase(std::unique(pinched.begin(), pinched.end()), pinched.end());
      std::map<Index, std::vector<Index>> stars;
      for (const Index v : pinched) stars[v];
      for (Index t = 0; t < mesh_.size(); ++t) {
        for (const Index v : mesh_.triangles[t]) {
          if (std::binary_search(pinched.begin(), pinched.end(), v)) stars[v].push_back(t);
        }
      }
      std::vector<char> keep(mesh_.triangles.size(), 1);
      for (const auto& [v, star] : stars) drop_lesser_fans(v, star, keep);
      keep_only(keep);
    }
    return false;
  }

  // Keeps the fan with the loop's edge, else the largest; the first of equal ones.
  void drop_lesser_fans(Index vertex, std::vector<Index> star, std::vector<char>& keep) const {
    std::vector<std::vector<Index>> fans;
    std::size_t best = 0;
    bool at_loop = false;
    while (!star.empty()) {
      fans.push_back(fan_at(vertex, star.front()));
      std::erase_if(star, [&](Index t) { return std::ranges::count(fans.back(), t) > 0; });
      const bool here = std::ranges::any_of(fans.back(), [&](Index t) {
        const int c = mesh_.corner_of(t, vertex);
        return mesh_.adjacent[t][previous(c)] == none && mesh_.triangles[t][next(c)] == loop_next_[vertex];
      });
      if (here || (!at_loop && fans.back().size() > fans[best].size())) best = fans.size() - 1;
      at_loop = at_loop || here;
    }
    for (std::size_t f = 0; f < fans.size(); ++f) {
      for (const Index t : fans[f]) {
        if (f != best) keep[t] = 0;
      }
    }
  }

  std::vector<Index> fan_at(Index vertex, Index first) const {
    std::vector<Index> fan{first};
    for (const bool forward : {true, false}) {
      for (Index at = first;;) {
        const int c = mesh_.corner_of(at, vertex);
        at = mesh_.adjacent[at][forward ? next(c) : previous(c)];
        if (at == first) return fan;
        if (at == none) break;
        fan.push_back(at);
      }
    }
    return fan;
  }

  // Keeps the edge-connected component of the first loop.
  bool keep_sheet() {
    const Rim rim(mesh_, points_.size());
    for (const Loop& loop : loops_) {
      for (const Index v : loop.points) {
        if (rim.next[v] != loop_next_[v]) return false;
      }
    }
    const Components components = find_components(mesh_);
    if (components.count() == 1) return true;
    const Index kept = components.of_triangle[rim.triangle[loops_.front().points.front()]];
    std::vector<char> is_kept(mesh_.triangles.size());
    for (std::size_t t = 0; t < is_kept.size(); ++t) is_kept[t] = components.of_triangle[t] == kept;
    keep_only(is_kept);
    return true;
  }

  void keep_only(const std::vector<char>& keep) {
    std::vector<Index> number(keep.size(), none);
    Index count = 0;
    for (std::size_t t = 0; t < keep.size(); ++t) {
      if (keep[t]) number[t] = count++;
    }
    for (std::size_t t = 0; t < keep.size(); ++t) {
      if (!keep[t]) continue;
      mesh_.triangles[number[t]] = mesh_.triangles[t];
      for (int c = 0; c < 3; ++c) {
        const Index other = mesh_.adjacent[t][c];
        mesh_.adjacent[number[t]][c] = other == none ? none : number[other];
      }
    }
    mesh_.triangles.resize(count);
    mesh_.adjacent.resize(count);
  }

  bool close_gaps() {
    Rim rim(mesh_, points_.size());
    for (const Loop& loop : loops_) {  // fails for a loop of a removed part
      for (const Index v : loop.points) {
        if (rim.next[v] != loop_next_[v]) return false;
      }
    }
    for (Index v = 0; v < static_cast<Index>(points_.size()); ++v) {
      if (rim.next[v] == none || loop_next_[v] != none) continue;
      std::vector<Index> ring;
      for (Index at = v; at != none && ring.size() <= largest_gap; at = rim.next[at]) {
        if (at == v && !ring.empty()) break;
        ring.push_back(at);
      }
      if (ring.size() > largest_gap || !close_gap(ring, rim)) return false;
      for (const Index at : ring) rim.next[at] = none;
    }
    return true;
  }

  bool close_gap(std::vector<Index> ring, const Rim& rim) {
    std::reverse(ring.begin(), ring.end());  // the gap on its left
    std::map<Index, std::vector<Index>> joined;
    for (const Index v : ring) joined[v] = neighbours_of(v, rim.triangle[v]);
    const std::vector<Triangle> filling = close_ring(points_, ring, [&](Index a, Index b) {
      const std::vector<Index>& others = joined[a];
      return std::find(others.begin(), others.end(), b) != others.end();
    });
    if (filling.empty()) return false;
    std::map<std::pair<Index, Index>, Index> triangle_at;  // of each directed edge
    for (const Index v : ring) triangle_at[{v, rim.next[v]}] = rim.triangle[v];
    for (const Triangle& x : filling) {
      for (int c = 0; c < 3; ++c) triangle_at[{x[next(c)], x[previous(c)]}] = mesh_.size();
      mesh_.triangles.push_back(x);
      mesh_.adjacent.push_back({none, none, none});
    }
    for (Index t = mesh_.size() - static_cast<Index>(filling.size()); t < mesh_.size(); ++t) {
      for (int c = 0; c < 3; ++c) {
        const Index from = mesh_.triangles[t][next(c)], to = mesh_.triangles[t][previous(c)];
        const Index other = triangle_at.at({to, from});
        mesh_.adjacent[t][c] = other;
        for (int d = 0; d < 3; ++d) {
          if (mesh_.triangles[other][next(d)] == to && mesh_.triangles[other][previous(d)] == from)
            mesh_.adjacent[other][d] = t;
        }
      }
    }
    return true;
  }

  std::vector<Index> neighbours_of(Index vertex, Index triangle) const {
    std::vector<Index> others;
    for (const Index t : fan_at(vertex, triangle)) {
      const int c = mesh_.corner_of(t, vertex);
      others.push_back(mesh_.triangles[t][next(c)]);
      others.push_back(mesh_.triangles[t][previous(c)]);
    }
    return others;
  }

  Points points_;
  const std::vector<Loop>& loops_;
  std::vector<Index> loop_next_;  // along the loops; none elsewhere
  Triangulation mesh_;
};

std::size_t count_covered(const Triangulation& mesh, std::size_t vertices) {
  std::vector<char> covered(vertices, 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) covered[v] = 1;
  }
  return static_cast<std::size_t>(std::count(covered.begin(), covered.end(), 1));
}

// Euler's number of a disc with holes that has all points, with E = (3 F + boundary) / 2. Where vertices have
// more than one fan it is less.
bool is_disc_with_holes(const Triangulation& mesh, std::size_t vertices, const std::vector<Loop>& loops) {
  std::size_t rim = 0;
  for (const Loop& loop : loops) rim += loop.points.size();
  return 2 * vertices + 2 * loops.size() == mesh.triangles.size() + rim + 4;
}

}  // namespace

std::optional<Triangulation> mesh_of_survey(Points points, const Neighbours& neighbours,
                                            const std::vector<Loop>& loops, std::vector<Triangle> triangles) {
  if (triangles.empty()) return {};
  Mender mender(points, loops, std::move(triangles));
  if (!mender.mend()) return {};
  Triangulation mesh = mender.take();
  if (100 * count_covered(mesh, points.size()) < least_covered * points.size()) return {};
  if (!insert_missing(points, neighbours, mesh).empty()) return {};
  if (!is_disc_with_holes(mesh, points.size(), loops)) return {};
  return mesh;
}

}  // namespace rimline
