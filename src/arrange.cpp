// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/arrange.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <numeric>
#include <tuple>

#include "first_touch.h"
#include "parallel.h"
#include "rimline/unfilled.h"

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
  void add(const Box& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
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

// Puts the ids of the points that are finite into places, and those that are not apart, in order. Returns the
// box of the first.
Box put_finite(Points input, UnfilledVector<Place>& places, std::vector<Index>& not_finite, const Run& run) {
  constexpr std::size_t block = 16384;
  struct Part {
    Box box;
    bool all_finite = true;
  };
  std::vector<Part> parts((input.size() + block - 1) / block);
  places.resize(input.size());
  parallel_tasks(parts.size(), Stage::Arrange, run, [&](std::size_t k) {
    for (std::size_t i = k * block; i < std::min(input.size(), (k + 1) * block); ++i) {
      places[i].id = static_cast<Index>(i);
      if (is_finite(input[i])) {
        parts[k].box.add(input[i]);
      } else {
        parts[k].all_finite = false;
      }
    }
  });
  run.check_cancel();
  Box box;
  bool all_finite = true;
  for (const Part& part : parts) {
    box.add(part.box);
    all_finite = all_finite && part.all_finite;
  }
  if (all_finite) return box;
  std::size_t kept = 0;
  for (const Place& place : places) {
    if (is_finite(input[place.id])) {
      places[kept++] = place;
    } else {
      not_finite.push_back(place.id);
    }
  }
  places.resize(kept);
  return box;
}

// Sorts by code, then by coordinates, then by id: into cells by the highest bits that differ first, then all
// cells at once.
void sort_along_curve(UnfilledVector<Place>& places, Points points, const Run& run) {
  constexpr int bits = 11;  // counters that fit a first-level cache
  std::uint64_t differing = 0;
  for (const Place& place : places) differing |= place.code ^ places[0].code;
  const int shift = std::max(0, static_cast<int>(std::bit_width(differing)) - bits);
  const auto cell_of = [&](const Place& p) { return (p.code >> shift) & ((1U << bits) - 1); };
  std::vector<std::size_t> next((1U << bits) + 1, 0);
  for (const Place& place : places) ++next[cell_of(place) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::size_t> start = next;
  UnfilledVector<Place> sorted(places.size());
  for (const Place& place : places) sorted[next[cell_of(place)]++] = place;
  const auto before = [&](const Place& a, const Place& b) {
    if (a.code != b.code) return a.code < b.code;
    const Point &p = points[a.id], &q = points[b.id];
    return std::tie(p.x, p.y, p.z, a.id) < std::tie(q.x, q.y, q.z, b.id);
  };
  parallel_tasks(start.size() - 1, Stage::Arrange, run, [&](std::size_t c) {
    tbb::parallel_sort(sorted.begin() + start[c], sorted.begin() + start[c + 1], before);  // may be nearly all
  });
  run.check_cancel();
  places.swap(sorted);
}

// Moves the ids of the points i for which is_out(i), asked in order, to `left_out`, which ascends then.
template <class IsOut>
void leave_out(Arrangement& arrangement, std::vector<Index>& left_out, const IsOut& is_out) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < arrangement.points.size(); ++i) {
    if (is_out(i)) {
      left_out.push_back(arrangement.ids[i]);
    } else {
      arrangement.points[kept] = arrangement.points[i];
      arrangement.ids[kept++] = arrangement.ids[i];
    }
  }
  arrangement.points.resize(kept);
  arrangement.ids.resize(kept);
  std::sort(left_out.begin(), left_out.end());
}

// Reads the points in the order of their places; of those that coincide only the first stays.
void take_distinct(const UnfilledVector<Place>& places, Points input, Arrangement& result, const Run& run) {
  resize_together(result.points, places.size(), run);
  resize_together(result.ids, places.size(), run);
  std::atomic<bool> all_distinct = true;
  const auto repeats = [&](std::size_t i) {
    return i > 0 && places[i].code == places[i - 1].code && input[places[i].id] == input[places[i - 1].id];
  };
  parallel_for_each(places.size(), Stage::Arrange, run, [&](Index i) {
    result.points[i] = input[places[i].id] - result.origin;
    result.ids[i] = places[i].id;
    if (repeats(i)) all_distinct = false;
  });
  if (!all_distinct) leave_out(result, result.duplicates, repeats);
}

template <class List>
bool contains(const List& list, Index id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

bool are_mutual(const Neighbours& neighbours, Index a, Index b) { return contains(neighbours.of(b), a); }

// Whether mutual neighbours join a point to `enough` points, itself one of them.
bool reaches(const Neighbours& neighbours, Index point, int enough) {
  std::vector<Index> group{point};
  for (std::size_t at = 0; at < group.size() && group.size() < static_cast<std::size_t>(enough); ++at) {
    for (const Index j : neighbours.of(group[at])) {
      if (!contains(group, j) && are_mutual(neighbours, group[at], j)) group.push_back(j);
    }
  }
  return group.size() >= static_cast<std::size_t>(enough);
}

}  // namespace

Arrangement arrange(Points input, const Run& run) {
  run.progress(Stage::Arrange, 0, input.size());
  if (input.size() >= static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    throw Error(ErrorCode::OutOfMemory, "more points than ids: at most 2,147,483,646 can be taken");
  }
  Arrangement result;
  UnfilledVector<Place> places;
  const Box box = put_finite(input, places, result.not_finite, run);
  if (places.empty()) throw Error(ErrorCode::TooFewPoints, "no point has finite coordinates");
  result.origin = box.centre();

  constexpr double cells = (1 << 21) - 1;
  const double scale = box.extent() > 0 ? cells / box.extent() : 0;
  parallel_for_each(places.size(), Stage::Arrange, run,
                    [&](Index i) { places[i].code = morton_code(input[places[i].id], box.low, scale); });
  sort_along_curve(places, input, run);
  take_distinct(places, input, result, run);
  return result;
}

bool leave_out_stray(Arrangement& arrangement, const Neighbours& neighbours, const Run& run,
                     int least_group) {
  const auto count = static_cast<std::size_t>(neighbours.size());
  if (count < static_cast<std::size_t>(least_group)) return false;
  constexpr std::size_t block = 16384;
  std::vector<char> is_large(count);  // a byte each: blocks are written at the same time
  std::atomic<bool> all_large = true;
  parallel_tasks((count + block - 1) / block, Stage::Neighbours, run, [&](std::size_t k) {
    const auto begin = static_cast<Index>(k * block);
    const auto end = static_cast<Index>(std::min(count, (k + 1) * block));
    for (Index i = begin; i < end; ++i) {
      // Most points have a mutual neighbour that came before them.
      const auto list = neighbours.of(i);
      is_large[i] = std::any_of(list.begin(), list.end(), [&](Index j) {
        return j >= begin && j < i && is_large[j] && are_mutual(neighbours, i, j);
      });
      if (!is_large[i]) is_large[i] = reaches(neighbours, i, least_group);
      if (!is_large[i]) all_large = false;
    }
  });
  run.check_cancel();
  if (all_large) return false;
  leave_out(arrangement, arrangement.stray, [&](std::size_t i) { return !is_large[i]; });
  return true;
}

}  // namespace rimline
