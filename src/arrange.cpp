// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/arrange.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
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

struct Place {
  std::uint64_t code;
  Point point;
  Index id;

  friend bool operator<(const Place& a, const Place& b) {
    return std::tie(a.code, a.point.x, a.point.y, a.point.z, a.id) <
           std::tie(b.code, b.point.x, b.point.y, b.point.z, b.id);
  }
};

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
      places.push_back({0, input[i], i});
    } else {
      result.not_finite.push_back(i);
    }
  }
  if (places.empty()) throw Error(ErrorCode::TooFewPoints, "no point has finite coordinates");
  result.origin = box.centre();

  constexpr double cells = (1 << 21) - 1;
  const double scale = box.extent() > 0 ? cells / box.extent() : 0;
  parallel_for_each(places.size(), Stage::Arrange, run,
                    [&](Index i) { places[i].code = morton_code(places[i].point, box.low, scale); });
  tbb::task_arena(thread_count(run)).execute([&] { tbb::parallel_sort(places.begin(), places.end()); });
  run.check_cancel();

  result.points.reserve(places.size());
  result.ids.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0 && places[i].point == places[i - 1].point) {
      result.duplicates.push_back(places[i].id);
    } else {
      result.points.push_back(places[i].point - result.origin);
      result.ids.push_back(places[i].id);
    }
  }
  std::sort(result.duplicates.begin(), result.duplicates.end());
  return result;
}

bool leave_out_stray(Arrangement& arrangement, const Neighbours& neighbours, int least_group) {
  const Index count = neighbours.size();
  UnionFind groups(count);
  for (Index i = 0; i < count; ++i) {
    for (const Index j : neighbours.of(i)) {
      if (i < j && groups.find(i) != groups.find(j) && are_mutual(neighbours, i, j)) groups.join(i, j);
    }
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
