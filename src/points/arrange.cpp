// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/arrange.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "base/prefault.h"
#include "points/far_points.h"
#include "rimline/unfilled.h"

namespace rimline {
namespace {

// A point on its way to its place on the curve.
struct Place {
  std::uint64_t code;
  Index id;
};

// The box of the points that are finite. Names those that are not, in order.
PointBox find_box(Points input, std::vector<Index>& not_finite, const Run& run) {
  constexpr std::size_t block = 16384;
  struct Part {
    PointBox box;
    bool all_finite = true;
  };
  std::vector<Part> parts((input.size() + block - 1) / block);
  parallel_tasks(parts.size(), Stage::Arrange, run, [&](std::size_t k) {
    for (std::size_t i = k * block; i < std::min(input.size(), (k + 1) * block); ++i) {
      if (is_finite(input[i])) {
        parts[k].box.add(input[i]);
      } else {
        parts[k].all_finite = false;
      }
    }
  });
  run.check_cancel();
  PointBox box;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    box.add(parts[k].box);
    if (parts[k].all_finite) continue;
    for (std::size_t i = k * block; i < std::min(input.size(), (k + 1) * block); ++i) {
      if (!is_finite(input[i])) not_finite.push_back(static_cast<Index>(i));
    }
  }
  return box;
}

// Points on their way, in the cells that the highest bits of their codes make.
struct Cells {
  static constexpr int bits = 13;  // counters that fit a second-level cache
  static constexpr std::size_t count = std::size_t{1} << bits;
  int shift;                       // a cell is a code without so many of its lowest bits
  UnfilledVector<Place> places;    // cell by cell, by id in each
  std::vector<std::size_t> first;  // of each cell, and the end of the last
};

// Names the finite points that the box does not have, in order, and makes it the box of those that it has.
void leave_out_far(Points input, PointBox& box, std::vector<Index>& far) {
  const PointBox limits = std::exchange(box, PointBox{});
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (limits.has(input[i])) {
      box.add(input[i]);
    } else if (is_finite(input[i])) {
      far.push_back(static_cast<Index>(i));
    }
  }
}

// Puts the points that the box has into their cells. Each block of them is counted first, and so knows where
// in each cell it has to write.
Cells put_in_cells(Points input, const MortonCurve& curve, const PointBox& box, const Run& run) {
  Cells cells;
  cells.shift = std::max(0, static_cast<int>(std::bit_width(curve.code(box.high))) - Cells::bits);
  const std::size_t blocks = std::clamp<std::size_t>(input.size() / 32768, 1, 64);
  const auto read_block = [&](std::size_t k, const auto& body) {
    for (std::size_t i = input.size() * k / blocks; i < input.size() * (k + 1) / blocks; ++i) {
      if (!box.has(input[i])) continue;  // not finite, or far
      const std::uint64_t code = curve.code(input[i]);
      body(Place{code, static_cast<Index>(i)}, code >> cells.shift);
    }
  };
  std::vector<std::uint32_t> next(blocks * Cells::count);  // of each block: numbers, then places
  parallel_tasks(blocks, Stage::Arrange, run, [&](std::size_t k) {
    read_block(k, [counts = &next[k * Cells::count]](Place, std::size_t cell) { ++counts[cell]; });
  });
  run.check_cancel();
  cells.first.resize(Cells::count + 1);
  for (std::size_t i = 0; i < next.size(); ++i) cells.first[i % Cells::count + 1] += next[i];
  std::partial_sum(cells.first.begin(), cells.first.end(), cells.first.begin());
  std::vector<std::size_t> at = cells.first;
  for (std::size_t i = 0; i < next.size(); ++i) {
    const std::uint32_t number = next[i];
    next[i] = static_cast<std::uint32_t>(at[i % Cells::count]);
    at[i % Cells::count] += number;
  }
  cells.places.resize(cells.first.back());
  parallel_tasks(blocks, Stage::Arrange, run, [&](std::size_t k) {
    read_block(k, [&, places = &next[k * Cells::count]](Place place, std::size_t cell) {
      cells.places[places[cell]++] = place;
    });
  });
  run.check_cancel();
  return cells;
}

// Sorts a cell by code, then by coordinates, then by id.
void sort_cell(std::span<Place> places, int shift, Points points) {
  constexpr std::size_t few = 512, many = std::size_t{1} << 20;
  const auto before = [&](const Place& a, const Place& b) {
    if (a.code != b.code) return a.code < b.code;
    const Point &p = points[a.id], &q = points[b.id];
    return std::tie(p.x, p.y, p.z, a.id) < std::tie(q.x, q.y, q.z, b.id);
  };
  if (places.size() < few) return std::sort(places.begin(), places.end(), before);
  if (places.size() > many) return tbb::parallel_sort(places.begin(), places.end(), before);  // nearly all
  // By the next two digits, after which few points are left together.
  constexpr int digit = 11;
  UnfilledVector<Place> other(places.size());
  const int lowest = std::max(0, shift - 2 * digit);
  const auto pass = [](std::span<const Place> from, std::span<Place> to, int by) {
    const auto digit_of = [by](const Place& p) { return (p.code >> by) & ((1U << digit) - 1); };
    std::array<std::uint32_t, (1U << digit) + 1> next{};
    for (const Place& place : from) ++next[digit_of(place) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const Place& place : from) to[next[digit_of(place)]++] = place;
  };
  pass(places, other, lowest);
  pass(other, places, lowest + digit);
  for (auto first = places.begin(); first != places.end();) {
    const auto last = std::find_if(first + 1, places.end(),
                                   [&](const Place& p) { return p.code >> lowest != first->code >> lowest; });
    if (last - first > 1) std::sort(first, last, before);
    first = last;
  }
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

// Sorts the cells and reads the points in this order; of those that coincide only the first stays.
void take_distinct(Cells& cells, Points input, Arrangement& result, const Run& run) {
  resize_together(result.points, cells.places.size(), run);
  resize_together(result.ids, cells.places.size(), run);
  std::atomic<bool> all_distinct = true;
  const auto repeats = [&](std::size_t i) {
    return i > 0 && input[cells.places[i].id] == input[cells.places[i - 1].id];
  };
  parallel_tasks(Cells::count, Stage::Arrange, run, [&](std::size_t c) {
    const std::size_t first = cells.first[c], last = cells.first[c + 1];
    sort_cell({&cells.places[0] + first, last - first}, cells.shift, input);
    for (std::size_t i = first; i < last; ++i) {
      result.points[i] = input[cells.places[i].id] - result.origin;
      result.ids[i] = cells.places[i].id;
      if (i > first && repeats(i)) all_distinct = false;
    }
  });
  run.check_cancel();
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
  PointBox box = find_box(input, result.not_finite, run);
  if (result.not_finite.size() == input.size()) {
    throw Error(ErrorCode::TooFewPoints, "no point has finite coordinates");
  }
  if (const auto near = box_without_far_points(input, box, run)) {
    box = *near;
    leave_out_far(input, box, result.stray);
  }
  result.origin = box.centre();
  Cells cells = put_in_cells(input, MortonCurve(box), box, run);
  take_distinct(cells, input, result, run);
  return result;
}

void leave_out(Arrangement& arrangement, const std::vector<Index>& places) {
  auto next = places.begin();
  leave_out(arrangement, arrangement.stray, [&](std::size_t i) {
    if (next == places.end() || static_cast<std::size_t>(*next) != i) return false;
    ++next;
    return true;
  });
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
