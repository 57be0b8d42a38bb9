// SPDX-License-Identifier: GPL-3.0-or-later
// Stream compaction: keeps some of many items, in their order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/prefault.h"
#include "rimline/unfilled.h"

namespace rimline {

// The kept items, in their order. The marks (zero: not kept) must outlive this object and must not change.
class KeptItems {
 public:
  KeptItems(const std::vector<std::uint8_t>& kept, Stage stage, const Run& run)
      : kept_(kept),
        stage_(stage),
        run_(run.without_progress()),
        start_((kept.size() + grain - 1) / grain + 1, 0) {
    each_slice([&](std::size_t s, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) start_[s + 1] += kept_[i] != 0;
    });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
  }

  std::size_t size() const { return start_.back(); }
  bool is_all() const { return size() == kept_.size(); }

  template <class Item>
  std::vector<Item> of(const std::vector<Item>& items) const {
    std::vector<Item> selected;
    resize_together(selected, size(), run_);
    each_slice([&](std::size_t s, std::size_t first, std::size_t last) {
      std::size_t to = start_[s];
      for (std::size_t i = first; i < last; ++i) {
        if (kept_[i]) selected[to++] = items[i];
      }
    });
    return selected;
  }

  // The index of each item among the kept ones, or `none`.
  UnfilledVector<Index> places() const {
    UnfilledVector<Index> place(kept_.size());
    each_slice([&](std::size_t s, std::size_t first, std::size_t last) {
      auto next = static_cast<Index>(start_[s]);
      for (std::size_t i = first; i < last; ++i) {
        place[i] = kept_[i] ? next : none;
        next += kept_[i] != 0;
      }
    });
    return place;
  }

 private:
  static constexpr std::size_t grain = 16384;  // items in one slice

  template <class Body>
  void each_slice(const Body& body) const {
    parallel_tasks(start_.size() - 1, stage_, run_,
                   [&](std::size_t s) { body(s, s * grain, std::min(kept_.size(), (s + 1) * grain)); });
    run_.check_cancel();
  }

  const std::vector<std::uint8_t>& kept_;
  Stage stage_;
  Run run_;
  std::vector<std::size_t> start_;  // index of each slice's first item among the kept ones
};

}  // namespace rimline
