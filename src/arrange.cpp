// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/arrange.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <tuple>

#include "parallel.h"
#include "union_find.h"

namespace rimline {
namespace {

struct Box {
  Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
            std::numeric_limits<double>::max()};
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
             std::numeric_limits<double>::lowest()};

  void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  // Halves first: the sum of two ends may overflow.
  Point centre() const { return 0.5 * low + 0.5 * high; }
  double extent() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

// Spreads the low 21 bits of a number so that two zero bits follow each.
std::uint64_t spread_bits(std::uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  bits = (bits | bits << 2) & 0x1249249249249249;
  return bits;
}

// Where a point lies on the curve, with 21 bits an axis.
std::uint64_t morton_code(Point p, Point low, double scale) {
  const auto cell = [scale](double offset) { return static_cast<std::uint64_t>(offset * scale); };
  return spread_bits(cell(p.x - low.x)) | spread_bits(cell(p.y - low.y)) << 1 |
         spread_bits(cell(p.z - low.z)) << 2;
}

// A point on its way to its place on the curve.
struct Place {
  std::uint64_t code;
  Index id;
};

// Sorts by code, in passes over groups of bits from the least to the most significant. Passes in which all
// have the same bits are left out.
void sort_by_code(std::vector<Place>& places) {
  constexpr int bits = 11, passes = 6;  // 63 bits of the code, and counters that fit a first-level cache
  constexpr std::size_t mask = (1 << bits) - 1;
  std::vector<std::array<Index, mask + 1>> count(passes);
  for (const Place& place : places) {
    for (int pass = 0; pass < passes; ++pass) ++count[pass][place.code >> (pass * bits) & mask];
  }
  std::vector<Place> sorted(places.size());
  for (int pass = 0; pass < passes; ++pass) {
    const int shift = pass * bits;
    std::array<Index, mask + 1>& start = count[pass];
    if (start[places[0].code >> shift & mask] == static_cast<Index>(places.size())) continue;
    std::exclusive_scan(start.begin(), start.end(), start.begin(), Index{0});
    for (const Place& place : places) sorted[start[place.code >> shift & mask]++] = place;
    places.swap(sorted);
  }
}

// Sorts the points of each cell by their coordinates, then by id.
void sort_within_cells(std::vector<Place>& places, Points points) {
  for (auto first = places.begin(); first != places.end();) {
    auto last = first + 1;
    while (last != places.end() && last->code == first->code) ++last;
    if (last - first > 1) {
      std::sort(first, last, [&](const Place& a, const Place& b) {
        const Point &p = points[a.id], &q = points[b.id];
        return std::tie(p.x, p.y, p.z, a.id) < std::tie(q.x, q.y, q.z, b.id);
      });
    }
    first = last;
  }
}

bool are_mutual(const Neighbours& neighbours, Index a, Index b) {
  const auto list = neighbours.of(b);
  return std::find(list.begin(), list.end(), a) != list.end();
}

}  // namespace

Arrangement arrange(Points input, const Run& run) {
  run.progress(Stage::Arrange, 0, input.size());
  if (input.size() >= static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    throw Error(ErrorCode::OutOfMemory, "more points than ids: at most 2,147,483,646 can be taken");
  }
  Arrangement result;
  Box box;
  std::vector<Place> places;
  places.reserve(input.size());
  for (Index i = 0; i < static_cast<Index>(input.size()); ++i) {
    if (is_finite(input[i])) {
      box.add(input[i]);
      places.push_back({0, i});
    } else {
      result.not_finite.push_back(i);
    }
  }
  if (places.empty()) throw Error(ErrorCode::TooFewPoints, "no point has finite coordinates");
  result.origin = box.centre();

  constexpr double cells = (1 << 21) - 1;
  const double scale = box.extent() > 0 ? cells / box.extent() : 0;
  parallel_for_each(places.size(), Stage::Arrange, run,
                    [&](Index i) { places[i].code = morton_code(input[places[i].id], box.low, scale); });
  sort_by_code(places);
  run.check_cancel();
  sort_within_cells(places, input);

  result.points.reserve(places.size());
  result.ids.reserve(places.size());
  for (const Place& place : places) {
    const Point point = input[place.id];
    if (!result.ids.empty() && point == input[result.ids.back()]) {
      result.duplicates.push_back(place.id);
    } else {
      result.points.push_back(point - result.origin);
      result.ids.push_back(place.id);
    }
  }
  std::sort(result.duplicates.begin(), result.duplicates.end());
  return result;
}

bool leave_out_stray(Arrangement& arrangement, const Neighbours& neighbours, const Run& run,
                     int least_group) {
  const Index count = neighbours.size();
  UnionFind groups(count);
  const auto join_mutual = [&](Index i, int nearest) {
    for (const Index j : neighbours.of(i, nearest)) {
      if (groups.find(i) != groups.find(j) && are_mutual(neighbours, i, j)) groups.join(i, j);
    }
  };
  // A few neighbours gather nearly all points into large groups. Whatever else could make a small group grow
  // starts at one of its points, as mutual pairs are in both lists. Blocks of points may gather at the same
  // time, as their groups share no point; then come the few pairs of points of two blocks.
  const int few = std::min(3, neighbours.k);
  constexpr std::size_t block = 16384;
  struct Pair {
    Index a, b;
  };
  const auto points = static_cast<std::size_t>(count);
  std::vector<std::vector<Pair>> across((points + block - 1) / block);
  parallel_tasks(across.size(), Stage::Neighbours, run, [&](std::size_t k) {
    const Index begin = static_cast<Index>(k * block);
    const Index end = static_cast<Index>(std::min(points, (k + 1) * block));
    for (Index i = begin; i < end; ++i) {
      for (const Index j : neighbours.of(i, few)) {
        if (j < begin || j >= end) {
          across[k].push_back({i, j});
        } else if (groups.find(i) != groups.find(j) && are_mutual(neighbours, i, j)) {
          groups.join(i, j);
        }
      }
    }
  });
  run.check_cancel();
  for (const auto& pairs : across) {
    for (const auto& [i, j] : pairs) {
      if (groups.find(i) != groups.find(j) && are_mutual(neighbours, i, j)) groups.join(i, j);
    }
  }
  for (Index i = 0; i < count; ++i) {
    if (groups.size_of(i) < least_group) join_mutual(i, neighbours.k);
  }
  std::size_t kept = 0;
  for (Index i = 0; i < count; ++i) {
    if (groups.size_of(i) < least_group && count >= least_group) {
      arrangement.stray.push_back(arrangement.ids[i]);
    } else {
      arrangement.points[kept] = arrangement.points[i];
      arrangement.ids[kept++] = arrangement.ids[i];
    }
  }
  arrangement.points.resize(kept);
  arrangement.ids.resize(kept);
  std::sort(arrangement.stray.begin(), arrangement.stray.end());
  return kept < static_cast<std::size_t>(count);
}

}  // namespace rimline
