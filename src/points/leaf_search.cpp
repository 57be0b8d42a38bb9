// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/leaf_search.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "base/multiversioning.h"

#ifdef RIMLINE_AVX512
#include <immintrin.h>
#endif

namespace rimline {
namespace {

// Factors by which the radius of the last leaf, and of the last point, is enlarged for the next. Smaller ones
// cause more second searches, larger ones gather more points in vain. Measured; they change no result.
constexpr double leaf_slack = 1.15, point_slack = 1.08;

// More gathered points than this many times k are a sign that the radius is too large.
constexpr std::size_t most_gathered = 32;

// Moves per point after which insertion sort of a nearly sorted list is given up.
constexpr std::size_t most_moves = 8;

// The error of the single precision in radii: where it is more (the leaf is that much larger than the
// radius), distances are not compared in single precision.
constexpr double most_margin = 0x1p-9;

// Squares of lengths in between neither overflow nor lose digits.
constexpr double least_radius = 1e-140, most_radius = 1e140;

// Width of the vector loops over gathered points and keys; their arrays are padded by as many.
constexpr std::size_t at_once = 16;
using Numbers = std::int32_t __attribute__((vector_size(at_once * sizeof(std::int32_t))));

// How many keys the lowest bits can tell apart.
constexpr std::size_t most_keys = 256;

// Coordinates of the tree's places in runs [begin, end), from a centre and scaled.
RIMLINE_WIDE void gather_runs(const double* from, const std::vector<std::size_t>& runs, double centre,
                              double scale, float* to) {
  for (std::size_t r = 0; r < runs.size(); r += 2) {
    for (std::size_t i = runs[r]; i < runs[r + 1]; ++i)
      *to++ = static_cast<float>((from[i] - centre) * scale);
  }
}

// The gathered points, in single precision, and their places in the tree.
struct Gathered {
  const float *x, *y, *z;
  const Index* places;
  std::size_t count;
};

#ifdef RIMLINE_AVX512
RIMLINE_AVX512 std::size_t pass(const Gathered& from, float x, float y, float z, float limit, Index* passed,
                                std::int32_t* bits) {
  const __m512 at_x = _mm512_set1_ps(x), at_y = _mm512_set1_ps(y), at_z = _mm512_set1_ps(z);
  std::size_t count = 0;
  for (std::size_t i = 0; i < from.count; i += at_once) {
    const __m512 dx = _mm512_sub_ps(_mm512_loadu_ps(from.x + i), at_x);
    const __m512 dy = _mm512_sub_ps(_mm512_loadu_ps(from.y + i), at_y);
    const __m512 dz = _mm512_sub_ps(_mm512_loadu_ps(from.z + i), at_z);
    const __m512 xy = _mm512_add_ps(_mm512_mul_ps(dx, dx), _mm512_mul_ps(dy, dy));
    const __m512 squared = _mm512_add_ps(xy, _mm512_mul_ps(dz, dz));
    const __mmask16 within = _mm512_cmp_ps_mask(squared, _mm512_set1_ps(limit), _CMP_LE_OQ);
    const __m512i places = _mm512_loadu_si512(from.places + i);
    _mm512_storeu_si512(passed + count, _mm512_maskz_compress_epi32(within, places));
    _mm512_storeu_ps(bits + count, _mm512_maskz_compress_ps(within, squared));
    count += static_cast<std::size_t>(std::popcount(static_cast<unsigned>(within)));
  }
  return count;
}
#endif

// Those within the limit, a squared distance from (x, y, z), and the bits of their squared distances.
RIMLINE_OTHERS std::size_t pass(const Gathered& from, float x, float y, float z, float limit, Index* passed,
                                std::int32_t* bits) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < from.count; ++i) {
    const float dx = from.x[i] - x, dy = from.y[i] - y, dz = from.z[i] - z;
    const float squared = dx * dx + dy * dy + dz * dz;
    passed[count] = from.places[i];
    bits[count] = std::bit_cast<std::int32_t>(squared);
    count += squared <= limit;
  }
  return count;
}

// Writes the places in the order of the bits of their squared distances, but for the lowest bits. The rank of
// a key, all of which differ, is the number of those below it: no branch depends on any. Keys have room for
// `at_once` more, `ordered` for one.
RIMLINE_WIDE void order_by_rank(std::int32_t* keys, const Index* places, std::size_t count, Index* ordered) {
  // The order of numbers that are not negative is that of their bits; the lowest make them differ.
  constexpr std::int32_t lowest = most_keys - 1;
  for (std::size_t j = 0; j < count; ++j) keys[j] = (keys[j] & ~lowest) | static_cast<std::int32_t>(j);
  std::fill_n(keys + count, at_once, std::numeric_limits<std::int32_t>::max());
  for (std::size_t first = 0; first < count; first += at_once) {
    Numbers own, sum{};
    std::memcpy(&own, keys + first, sizeof(own));
    for (std::size_t j = 0; j < count; ++j) sum -= keys[j] < own;  // -1 where true
    std::int32_t rank[at_once];
    std::memcpy(rank, &sum, sizeof(rank));
    for (std::size_t l = 0; l < at_once; ++l) ordered[rank[l]] = places[first + l];
  }
}

// Squared distances of places from a point.
RIMLINE_WIDE void square_distances(const KdTree& tree, const Index* places, std::size_t count, Point from,
                                   double* squared) {
  const double *x = tree.x.data(), *y = tree.y.data(), *z = tree.z.data();
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = x[places[i]] - from.x, dy = y[places[i]] - from.y, dz = z[places[i]] - from.z;
    squared[i] = dx * dx + dy * dy + dz * dz;
  }
}

RIMLINE_WIDE bool ascend(const double* values, std::size_t count) {
  int wrong = 0;
  for (std::size_t i = 1; i < count; ++i) wrong |= !(values[i - 1] < values[i]);
  return wrong == 0;
}

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

LeafSearch::LeafSearch(const KdTree& tree, int k) : tree_(tree), k_(static_cast<std::size_t>(k)) {}

void LeafSearch::search(std::size_t leaf, Neighbours& result) {
  const std::size_t own = tree_.leaf_node(leaf);
  const KdTree::Node& node = tree_.node(own);
  bool gathered = gather(own);
  double most = 0;
  for (std::size_t place = node.begin; place < node.end; ++place) {
    if (!gathered || !search_gathered(place)) {
      search_tree(place);
      // The rest of the leaf needs about as much.
      const double needed = leaf_slack * std::sqrt(squared_[k_ - 1]);
      radius_ = gathered ? std::max(radius_, needed) : needed;
      gathered = gather(own);
    }
    most = std::max(most, squared_[k_ - 1]);
    write(place, result);
  }
  radius_ = leaf_slack * std::sqrt(most);
}

// Collects the points of all leaves within the radius of this one. False where the radius is of no use.
bool LeafSearch::gather(std::size_t own) {
  const Bounds& leaf = tree_.node(own).bounds;
  if (!(radius_ > least_radius && radius_ < most_radius)) return false;
  runs_.clear();
  std::size_t count = 0;
  stack_.assign(1, KdTree::root);
  while (!stack_.empty()) {
    const std::size_t at = stack_.back();
    stack_.pop_back();
    const KdTree::Node& node = tree_.node(at);
    if (squared_gap(node.bounds, leaf) > radius_ * radius_) continue;
    if (!node.is_leaf()) {
      stack_.push_back(node.child + 1);
      stack_.push_back(node.child);
      continue;
    }
    if (count > most_gathered * (k_ + 8)) return false;
    const std::size_t first = node.begin, last = node.end;
    if (at == own) self_ = count, first_ = first;
    if (!runs_.empty() && runs_.back() == first) {
      runs_.back() = last;
    } else {
      runs_.insert(runs_.end(), {first, last});
    }
    count += last - first;
  }
  places_.clear();
  for (std::size_t r = 0; r < runs_.size(); r += 2) {
    for (std::size_t i = runs_[r]; i < runs_[r + 1]; ++i) places_.push_back(static_cast<Index>(i));
  }
  places_.resize(count + at_once, 0);
  const Point centre = 0.5 * leaf.low + 0.5 * leaf.high;
  const double scale = 1 / radius_;
  for (auto* coordinate : {&x_, &y_, &z_}) coordinate->assign(count + at_once, infinity);
  passed_.resize(count + at_once), keys_.resize(count + at_once);
  gather_runs(tree_.x.data(), runs_, centre.x, scale, x_.data());
  gather_runs(tree_.y.data(), runs_, centre.y, scale, y_.data());
  gather_runs(tree_.z.data(), runs_, centre.z, scale, z_.data());
  // A point of the leaf has coordinates up to `half` radii, one within the radius of it up to half + 1. Each
  // is rounded once and their difference once, by 2^-24 of their size: 16 times that leaves room for the
  // three axes and the sum.
  const double half = norm(leaf.high - leaf.low) * scale;
  margin_ = 0x1p-20 * (half + 1);
  reach_ = 1;
  return margin_ < most_margin;
}

// A point needs about the radius of the one before it: less to sort than for the radius of the leaf.
bool LeafSearch::search_gathered(std::size_t place) {
  if (!search_within(reach_, place) && (reach_ == 1 || !search_within(1, place))) return false;
  reach_ = std::min(1.0, point_slack * std::sqrt(squared_[k_ - 1]) / radius_);
  return true;
}

// Whether the k nearest are within reach, at most 1 radius. Then they are the first that are found.
bool LeafSearch::search_within(double reach, std::size_t place) {
  const std::size_t self = self_ + place - first_;
  const float limit = static_cast<float>((reach + margin_) * (reach + margin_));
  const float x = std::exchange(x_[self], infinity);  // no neighbour of itself
  const std::size_t count = pass({x_.data(), y_.data(), z_.data(), places_.data(), places_.size() - at_once},
                                 x, y_[self], z_[self], limit, passed_.data(), keys_.data());
  x_[self] = x;
  if (count < k_) return false;
  sort_passed(count, tree_.point(place));
  // Only within reach nothing was missed.
  return squared_[k_ - 1] <= reach * reach * (radius_ * radius_);
}

void LeafSearch::sort_passed(std::size_t count, Point point) {
  nearest_.resize(count + 1);
  squared_.resize(count);
  if (count <= most_keys) {
    order_by_rank(keys_.data(), passed_.data(), count, nearest_.data());
  } else {
    std::copy_n(passed_.begin(), count, nearest_.begin());
  }
  square_distances(tree_, nearest_.data(), count, point, squared_.data());
  if (ascend(squared_.data(), count)) return;
  found_.resize(count);
  for (std::size_t i = 0; i < count; ++i) found_[i] = {squared_[i], nearest_[i]};
  sort_found();
  take_found();
}

void LeafSearch::take_found() {
  nearest_.resize(found_.size());
  squared_.resize(found_.size());
  for (std::size_t i = 0; i < found_.size(); ++i)
    squared_[i] = found_[i].squared, nearest_[i] = found_[i].place;
}

void LeafSearch::sort_found() {
  std::size_t moves = 0;
  for (std::size_t i = 1; i < found_.size(); ++i) {
    const Found found = found_[i];
    std::size_t to = i;
    for (; to > 0 && before(found, found_[to - 1]); --to) found_[to] = found_[to - 1];
    found_[to] = found;
    moves += i - to;
    if (moves > most_moves * found_.size()) {
      return std::sort(found_.begin(), found_.end(),
                       [this](const Found& a, const Found& b) { return before(a, b); });
    }
  }
}

void LeafSearch::search_tree(std::size_t place) {
  found_.clear();
  visit(KdTree::root, place);
  std::sort_heap(found_.begin(), found_.end(),
                 [this](const Found& a, const Found& b) { return before(a, b); });
  take_found();
}

// Keeps the k best in a heap with the worst on top. Nodes as far as the worst are visited: ties.
void LeafSearch::visit(std::size_t at, std::size_t place) {
  const KdTree::Node& node = tree_.node(at);
  const Point point = tree_.point(place);
  const auto order = [this](const Found& a, const Found& b) { return before(a, b); };
  if (!node.is_leaf()) {
    const std::size_t child[2] = {node.child, node.child + std::size_t{1}};
    double far[2];
    for (const int i : {0, 1}) far[i] = squared_gap(tree_.node(child[i]).bounds, {point, point});
    const int nearer = far[1] < far[0];
    for (const int i : {nearer, 1 - nearer}) {
      if (found_.size() < k_ || far[i] <= found_.front().squared) visit(child[i], place);
    }
    return;
  }
  for (std::size_t other = node.begin; other < node.end; ++other) {
    const Found found{squared_distance(tree_.point(other), point), static_cast<Index>(other)};
    if (other == place || (found_.size() == k_ && !before(found, found_.front()))) continue;
    if (found_.size() == k_) {
      std::pop_heap(found_.begin(), found_.end(), order);
      found_.back() = found;
    } else {
      found_.push_back(found);
    }
    std::push_heap(found_.begin(), found_.end(), order);
  }
}

bool LeafSearch::before(const Found& a, const Found& b) const {
  if (a.squared != b.squared) return a.squared < b.squared;
  const Point p = tree_.point(a.place), q = tree_.point(b.place);
  return std::tie(p.x, p.y, p.z, tree_.id[a.place]) < std::tie(q.x, q.y, q.z, tree_.id[b.place]);
}

void LeafSearch::write(std::size_t place, Neighbours& result) const {
  const std::size_t slot = static_cast<std::size_t>(tree_.id[place]) * k_;
  for (std::size_t j = 0; j < k_; ++j) result.ids[slot + j] = tree_.id[nearest_[j]];
}

}  // namespace rimline
