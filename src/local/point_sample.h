// SPDX-License-Identifier: GPL-3.0-or-later
// A random sample of the points that depends on their coordinates alone, so that samples of parts can be
// merged.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The order in which points enter a sample: by a hash of their coordinates, ties by the coordinates.
struct SampleKey {
  std::uint64_t hash = 0;
  Point at;

  friend bool operator<(const SampleKey& a, const SampleKey& b) {
    return std::tie(a.hash, a.at.x, a.at.y, a.at.z) < std::tie(b.hash, b.at.x, b.at.y, b.at.z);
  }
};

// The `most` points of least key, ascending, or all where there are fewer; ties by id.
std::vector<Index> choose_sample(Points points, std::size_t most, const Run& run);

SampleKey sample_key(Point point);

// Measurements at the points of least key of a part, or of the whole: a bottom-k sketch (Cohen & Kaplan
// 2007). The merged samples of disjoint parts are the sample of the whole.
template <class Value>
struct PointSample {
  std::size_t most = 0;
  std::vector<std::pair<SampleKey, Value>> items;  // ascending by key, `most` of them or fewer

  PointSample& operator+=(const PointSample& other) {
    items.insert(items.end(), other.items.begin(), other.items.end());
    std::sort(items.begin(), items.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    items.resize(std::min(items.size(), most));
    return *this;
  }
};

}  // namespace rimline
