// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/propose.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <queue>
#include <tuple>

#include "base/model.h"
#include "base/parallel.h"
#include "base/prefault.h"
#include "base/vec.h"
#include "surface/triangle_order.h"

namespace rimline {
namespace {

struct Proposal {
  Triangle triangle;
  int votes;
  double size;  // circumradius over spacing

  auto rank() const { return std::tuple(-votes, size); }
};

// The size of a triangle: its circumradius over the largest spacing at its corners.
double over_spacing(double radius, const Triangle& t, const std::vector<double>& spacing) {
  return radius / std::max({spacing[t[0]], spacing[t[1]], spacing[t[2]]});
}

constexpr std::uint32_t nowhere = ~std::uint32_t{0};

// The index in a star of the corner between a and b, in either order.
std::uint32_t corner_between(Star star, Index a, Index b) {
  constexpr std::size_t most = 32;  // [layout]
  const std::size_t count = star.size();
  std::uint32_t is_a = 0;  // a bit for each place
  for (std::size_t i = 0; i < std::min(count, most); ++i) {
    is_a |= static_cast<std::uint32_t>(star[i] == a) << i;
  }
  if (is_a == 0 && count <= most) return nowhere;
  if ((is_a & (is_a - 1)) == 0 && count > 2 && count <= most) {
    const std::size_t at = static_cast<std::size_t>(std::countr_zero(is_a));
    const std::size_t before = at == 0 ? count - 1 : at - 1, after = at + 1 == count ? 0 : at + 1;
    if (star[after] == b) return static_cast<std::uint32_t>(at);
    return star[before] == b ? static_cast<std::uint32_t>(before) : nowhere;
  }
  for (std::size_t i = 0; i < count; ++i) {  // two or fewer in the star, or too many, or one of them twice
    const Index x = star[i], y = star[next_in(i, count)];
    if ((x == a && y == b) || (x == b && y == a)) return static_cast<std::uint32_t>(i);
  }
  return nowhere;
}

// A triangle that is in the stars of all its corners, and its index in each.
struct Agreed {
  Triangle triangle;
  std::array<std::uint32_t, 3> places;
  double radius;
};

// Triangles that the stars of a block of points are the first to name.
struct Row {
  std::vector<Agreed> agreed;
  std::vector<Proposal> rest;
};

constexpr std::size_t points_in_row = 4096;    // [speed]
constexpr std::size_t tries_per_look = 65536;  // triangles between two looks at the stop flag [speed]

// Reads the triangles of all stars in two rounds. Most triangles are in the stars of all their corners, which
// the corner of least id establishes for all three, so that the second round need not test them again.
class StarReader {
 public:
  StarReader(Points points, const Stars& stars, const std::vector<double>& spacing, double largest,
             const Run& run)
      : points_(points), stars_(stars), spacing_(spacing), largest_(largest) {
    resize_together(is_read_, stars.start(stars.size()), run);
  }

  std::vector<Row> read(const Run& run) {
    std::vector<Row> rows((stars_.size() + points_in_row - 1) / points_in_row);
    const auto for_each_star = [&](const auto& body) {
      parallel_tasks(rows.size(), Stage::Survey, run, [&](std::size_t r) {
        const std::size_t end = std::min(stars_.size(), (r + 1) * points_in_row);
        for (std::size_t v = r * points_in_row; v < end; ++v) body(static_cast<Index>(v), rows[r]);
      });
      run.check_cancel();
    };
    for (Row& row : rows)
      row.agreed.reserve(9 * points_in_row / 4);  // a surface has two triangles a point [speed]
    for_each_star([&](Index v, Row& row) { read_agreed(v, row.agreed); });
    for_each_star([&](Index v, Row& row) { read_rest(v, row.rest); });
    return rows;
  }

 private:
  void read_agreed(Index v, std::vector<Agreed>& agreed) {
    const Star star = stars_[v];
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Index a = star[i], b = star[next_in(i, star.size())];
      if (a < v || b < v) continue;  // `none` is below all
      const std::uint32_t in_a = corner_between(stars_[a], v, b);
      if (in_a == nowhere) continue;
      const std::uint32_t in_b = corner_between(stars_[b], v, a);
      if (in_b == nowhere) continue;
      for (const std::size_t at : {stars_.start(v) + i, stars_.start(a) + in_a, stars_.start(b) + in_b})
        is_read_[at] = 1;  // no other triangle has this corner
      const double radius = circumradius(points_[v], points_[a], points_[b]);
      if (over_spacing(radius, {v, a, b}, spacing_) <= largest_)
        agreed.push_back({{v, a, b}, {static_cast<std::uint32_t>(i), in_a, in_b}, radius});
    }
  }

  void read_rest(Index v, std::vector<Proposal>& rest) const {
    const Star star = stars_[v];
    for (std::size_t i = 0; i < star.size(); ++i) {
      if (is_read_[stars_.start(v) + i]) continue;
      const Index a = star[i], b = star[next_in(i, star.size())];
      if (a == none || b == none) continue;
      const bool by_a = corner_between(stars_[a], v, b) != nowhere;
      const bool by_b = corner_between(stars_[b], v, a) != nowhere;
      if ((by_a && a < v) || (by_b && b < v)) continue;  // that corner names it, too
      const double radius = circumradius(points_[v], points_[a], points_[b]);
      const double s = over_spacing(radius, {v, a, b}, spacing_);
      if (s <= largest_) rest.push_back({{v, a, b}, 1 + by_a + by_b, s});
    }
  }

  Points points_;
  const Stars& stars_;
  const std::vector<double>& spacing_;
  double largest_;
  std::vector<std::uint8_t> is_read_;  // of each corner of the stars
};

// The set of the triangles that all corners agree on, in the order of the blocks.
void take_agreed(TriangleSet& set, const Stars& stars, std::vector<Row>& rows, const Run& run) {
  std::vector<std::size_t> start{0};
  std::size_t more = 0;  // triangles that may follow: the rest, and ears
  for (const Row& row : rows) {
    start.push_back(start.back() + row.agreed.size());
    more += row.rest.size();
  }
  more += start.back() / 16;  // [speed]
  std::vector<Triangle> triangles;
  std::vector<double> radii;
  resize_together(triangles, start.back(), run, more);
  resize_together(radii, start.back(), run, more);
  TriangleSet::AtVertices at(stars, run);
  parallel_tasks(rows.size(), Stage::Survey, run, [&](std::size_t r) {
    std::size_t id = start[r];
    for (const Agreed& x : rows[r].agreed) {
      triangles[id] = x.triangle;
      radii[id] = x.radius;
      for (int i = 0; i < 3; ++i) at.put(x.triangle[i], x.places[i], static_cast<Index>(id));
      ++id;
    }
    rows[r].agreed = {};
  });
  run.check_cancel();
  set.start_with(std::move(triangles), std::move(radii), std::move(at), run);
}

class Proposer {
 public:
  Proposer(TriangleSet& set, const std::vector<double>& spacing, double largest)
      : set_(set), spacing_(spacing), largest_(largest) {}

  double size(const Triangle& t) const {
    const Points p = set_.points();
    return over_spacing(circumradius(p[t[0]], p[t[1]], p[t[2]]), t, spacing_);
  }

  void take_fitting(std::vector<Proposal> rest, const Run& run) {
    Arena(run).execute([&] {
      tbb::parallel_sort(
          rest.begin(), rest.end(), [is_before = TriangleOrder(set_.points())](const auto& x, const auto& y) {
            return x.rank() != y.rank() ? x.rank() < y.rank() : is_before(x.triangle, y.triangle);
          });
    });
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (i % tries_per_look == 0) run.check_cancel();
      const Proposal& p = rest[i];
      if (set_.can_add(p.triangle)) set_.add(p.triangle);
    }
  }

  void fill_missing_ears(const Run& run) {
    const auto at_rim =
        parallel_gather<Index>(set_.size(), Stage::Survey, run, [&](Index t, std::vector<Index>& found) {
          if (set_.is_at_rim(t)) found.push_back(t);
        });
    for (const Index t : at_rim) offer_at(t);
    for (std::size_t looks = 0; !queue_.empty(); ++looks) {
      if (looks % tries_per_look == 0) run.check_cancel();
      const Triangle triangle = queue_.top().second;
      queue_.pop();
      if (!set_.can_add(triangle)) continue;
      set_.add(triangle);
      offer_at(set_.size() - 1);
    }
  }

 private:
  using Ear = std::pair<double, Triangle>;  // size first

  // Offers the ears at both ends of each rim edge of a triangle.
  void offer_at(Index t) {
    const Triangle triangle = set_.triangle(t);
    for (int i = 0; i < 3; ++i) {
      const Index a = triangle[i], b = triangle[next_in(i, 3)];
      if (set_.across(t, i) != none) continue;
      offer(t, a, b);
      offer(t, b, a);
    }
  }
  // The ear at b between rim edge ab and the next rim edge around b.
  void offer(Index t, Index a, Index b) {
    Index at = a;
    for (Index next = t; next != none; next = set_.across(next, b, at)) {
      at = set_.apex(next, b, at);
      t = next;
    }
    if (at == a) return;
    const Triangle triangle{b, std::min(a, at), std::max(a, at)};
    const double s = size(triangle);
    if (s <= largest_) queue_.push({s, triangle});
  }

  TriangleSet& set_;
  const std::vector<double>& spacing_;
  double largest_;
  // The smallest on top; ties by position.
  struct IsBehind {
    TriangleOrder is_before;
    bool operator()(const Ear& a, const Ear& b) const {
      return a.first != b.first ? a.first > b.first : is_before(b.second, a.second);
    }
  };
  std::priority_queue<Ear, std::vector<Ear>, IsBehind> queue_{IsBehind{TriangleOrder(set_.points())}};
};

}  // namespace

TriangleSet propose_surface(Points points, const std::vector<Frame>& frames, const Stars& stars,
                            const std::vector<double>& spacing, double largest, const Run& run) {
  TriangleSet set(points, frames);
  std::vector<Row> rows = StarReader(points, stars, spacing, largest, run).read(run);
  take_agreed(set, stars, rows, run);
  std::vector<Proposal> rest;
  for (const Row& row : rows) rest.insert(rest.end(), row.rest.begin(), row.rest.end());
  Proposer proposer(set, spacing, largest);
  proposer.take_fitting(std::move(rest), run);
  run.check_cancel();
  proposer.fill_missing_ears(run);
  return set;
}

TriangleSet propose_surface(const Samples& samples, const Run& run) {
  const Stars stars = find_stars(samples.points, samples.neighbours, samples.spacing, samples.frames, run);
  return propose_surface(samples.points, samples.frames, stars, samples.spacing, model::proposed_largest,
                         run);
}

TriangleSet with_missing_ears(TriangleSet set, const std::vector<double>& spacing, double largest,
                              const Run& run) {
  Proposer(set, spacing, largest).fill_missing_ears(run);
  return set;
}

}  // namespace rimline
