// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/leaf_search.h"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace rimline {
namespace {

// How much farther the leaf looks than the one before had to: more finds more points in vain, less sends
// more points to search alone. Measured; it changes no result.
constexpr double slack = 1.1;

// More gathered points than this many times k are a sign that the radius is too large.
constexpr std::size_t most_gathered = 32;

// Moves in sorting what should be nearly sorted, for each point, before that is given up.
constexpr std::size_t most_moves = 8;

// Buckets of the squared distance within the radius.
constexpr std::size_t buckets = 64;

// The error of the single precision in radii: where it is more (the leaf is that much larger than the
// radius), distances are not compared in single precision.
constexpr double most_margin = 0.125 / buckets;

// Squares of lengths in between neither overflow nor lose digits.
constexpr double least_radius = 1e-140, most_radius = 1e140;

}  // namespace

LeafSearch::LeafSearch(const KdTree& tree, int k) : tree_(tree), k_(static_cast<std::size_t>(k)) {}

void LeafSearch::search(std::size_t leaf, Neighbours& result) {
  const std::size_t node = tree_.leaf_node(leaf);
  bool gathered = gather(node);
  double most = 0;
  for (std::size_t place = tree_.begin(node); place < tree_.end(node); ++place) {
    if (!gathered || !search_gathered(place)) {
      search_tree(place);
      // The rest of the leaf needs about as much.
      const double needed = slack * std::sqrt(found_[k_ - 1].squared);
      radius_ = gathered ? std::max(radius_, needed) : needed;
      gathered = gather(node);
    }
    most = std::max(most, found_[k_ - 1].squared);
    write(place, result);
  }
  radius_ = slack * std::sqrt(most);
}

// Collects the points of all leaves within the radius of this one. False where the radius is of no use.
bool LeafSearch::gather(std::size_t own) {
  const Bounds& leaf = tree_.bounds(own);
  if (!(radius_ > least_radius && radius_ < most_radius)) return false;
  places_.clear();
  stack_.assign(1, 1);
  while (!stack_.empty()) {
    const std::size_t node = stack_.back();
    stack_.pop_back();
    if (squared_gap(tree_.bounds(node), leaf) > radius_ * radius_) continue;
    if (!tree_.is_leaf(node)) {
      stack_.push_back(2 * node + 1);
      stack_.push_back(2 * node);
      continue;
    }
    const std::size_t first = tree_.begin(node), count = places_.size();
    if (count > most_gathered * (k_ + 8)) return false;
    if (node == own) self_ = count, first_ = first;
    places_.resize(count + tree_.end(node) - first);
    std::iota(places_.begin() + count, places_.end(), static_cast<Index>(first));
  }
  const Point centre = 0.5 * leaf.low + 0.5 * leaf.high;
  const double scale = 1 / radius_;
  const std::size_t count = places_.size();
  x_.resize(count), y_.resize(count), z_.resize(count);
  squared_.resize(count), room_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    x_[i] = static_cast<float>((tree_.x[places_[i]] - centre.x) * scale);
    y_[i] = static_cast<float>((tree_.y[places_[i]] - centre.y) * scale);
    z_[i] = static_cast<float>((tree_.z[places_[i]] - centre.z) * scale);
  }
  // A point of the leaf has coordinates up to `half` radii, one within the radius of it up to half + 1. Each
  // is rounded once and their difference once, by 2^-24 of their size: 16 times that leaves room for the
  // three axes and the sum.
  const double half = norm(leaf.high - leaf.low) * scale;
  const double margin = 0x1p-20 * (half + 1);
  limit_ = static_cast<float>((1 + margin) * (1 + margin));
  return margin < most_margin;
}

// The gathered points within the radius, and some that rounding lets pass; without the point itself.
void LeafSearch::pass(std::size_t place) {
  const std::size_t self = self_ + place - first_;
  const float x = x_[self], y = y_[self], z = z_[self];
  const std::size_t count = places_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = x_[i] - x, dy = y_[i] - y, dz = z_[i] - z;
    squared_[i] = dx * dx + dy * dy + dz * dz;
  }
  squared_[self] = std::numeric_limits<float>::infinity();
  std::size_t passed = 0;
  for (std::size_t i = 0; i < count; ++i) {
    room_[passed] = static_cast<Index>(i);
    passed += squared_[i] <= limit_;
  }
  passed_ = {room_.data(), passed};
}

bool LeafSearch::search_gathered(std::size_t place) {
  pass(place);
  if (passed_.size() < k_) return false;
  keep_nearest();
  const Point point = tree_.point(place);
  for (Found& found : found_) found.squared = squared_distance(tree_.point(found.place), point);
  sort_found();
  // Only within the radius nothing was missed.
  return found_[k_ - 1].squared <= radius_ * radius_;
}

// Copies at least the k nearest of those that passed to `found_`, nearly sorted: by buckets of the squared
// distance in single precision, which points of a surface fill evenly.
void LeafSearch::keep_nearest() {
  const float scale = static_cast<float>(buckets);
  const auto bucket = [&](Index i) { return static_cast<std::size_t>(squared_[i] * scale); };
  std::array<Index, buckets + 3> start{};
  for (const Index i : passed_) ++start[bucket(i)];
  std::size_t kept = 0, end = 0;
  const auto take_bucket = [&] { kept += std::exchange(start[end++], static_cast<Index>(kept)); };
  while (kept < k_) take_bucket();
  // The margin is far less than a bucket, so one more has all whose exact distance may be among the least.
  take_bucket();
  found_.resize(passed_.size());
  start[end] = static_cast<Index>(kept);  // all others, which go
  for (const Index i : passed_) found_[start[std::min(bucket(i), end)]++].place = places_[i];
  found_.resize(kept);
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
  visit(1, place);
  std::sort_heap(found_.begin(), found_.end(),
                 [this](const Found& a, const Found& b) { return before(a, b); });
}

// Keeps the k best in a heap with the worst on top. Nodes as far as the worst are visited: ties.
void LeafSearch::visit(std::size_t node, std::size_t place) {
  const Point point = tree_.point(place);
  const auto order = [this](const Found& a, const Found& b) { return before(a, b); };
  if (!tree_.is_leaf(node)) {
    std::size_t child[2] = {2 * node, 2 * node + 1};
    double far[2];
    for (const int i : {0, 1}) far[i] = squared_gap(tree_.bounds(child[i]), {point, point});
    const int nearer = far[1] < far[0];
    for (const int i : {nearer, 1 - nearer}) {
      if (found_.size() < k_ || far[i] <= found_.front().squared) visit(child[i], place);
    }
    return;
  }
  for (std::size_t other = tree_.begin(node); other < tree_.end(node); ++other) {
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
  for (std::size_t j = 0; j < k_; ++j) result.ids[slot + j] = tree_.id[found_[j].place];
}

}  // namespace rimline
