// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/fitness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/model.h"
#include "base/parallel.h"

namespace rimline {

FanCorners::FanCorners(const TriangleSet& set, std::span<const Index> vertices, const Run& run)
    : first_fan_{0} {
  constexpr std::size_t in_part = 1024;  // vertices [speed]
  std::vector<std::optional<FanCorners>> parts((vertices.size() + in_part - 1) / in_part);
  parallel_tasks(parts.size(), Stage::Loops, run, [&](std::size_t k) {
    const std::size_t first = k * in_part;
    parts[k] = FanCorners(set, vertices.subspan(first, std::min(in_part, vertices.size() - first)));
  });
  run.check_cancel();
  for (const auto& part : parts) append(*part);
}

FanCorners::FanCorners(const TriangleSet& set, std::span<const Index> vertices) : first_fan_{0} {
  for (const Index v : vertices) {
    add_vertex(set, v);
    first_fan_.push_back(static_cast<std::uint32_t>(fans_.size()));
  }
}

void FanCorners::append(const FanCorners& other) {
  const auto fans = static_cast<std::uint32_t>(fans_.size());
  const auto corners = static_cast<std::uint32_t>(corners_.size());
  for (std::size_t v = 1; v < other.first_fan_.size(); ++v) first_fan_.push_back(fans + other.first_fan_[v]);
  for (const Fan& fan : other.fans_) fans_.push_back({corners + fan.first, corners + fan.last, fan.closed});
  corners_.insert(corners_.end(), other.corners_.begin(), other.corners_.end());
}

void FanCorners::add_vertex(const TriangleSet& set, Index vertex) {
  std::vector<Index> left(set.star(vertex).begin(), set.star(vertex).end());
  const auto others = [&](Index t, Index(&pair)[2]) {
    int count = 0;
    for (const Index v : set.triangle(t)) {
      if (v != vertex) pair[count++] = v;
    }
  };
  for (const bool closed : {false, true}) {  // open fans start at a free edge; the rest are closed
    for (std::size_t i = 0; i < left.size();) {
      Index pair[2];
      others(left[i], pair);
      const bool free0 = set.across(left[i], vertex, pair[0]) == none;
      const bool free1 = set.across(left[i], vertex, pair[1]) == none;
      if (closed || free0 || free1) {
        add_fan(set, vertex, left[i], free1 && !free0 ? pair[1] : pair[0], closed, left);
        i = 0;
      } else {
        ++i;
      }
    }
  }
}

void FanCorners::add_fan(const TriangleSet& set, Index vertex, Index t, Index from, bool closed,
                         std::vector<Index>& left) {
  const Frame& frame = set.frames()[vertex];
  const auto direction = [&](Index v) {
    const Point d = set.points()[v] - set.points()[vertex];
    return static_cast<float>(std::atan2(dot(d, frame.v), dot(d, frame.u)));
  };
  Fan fan{static_cast<std::uint32_t>(corners_.size()), 0, closed};
  while (t != none) {
    const auto at = std::find(left.begin(), left.end(), t);
    if (at == left.end()) break;
    left.erase(at);
    const Index to = set.apex(t, vertex, from);
    corners_.push_back({t, direction(from), direction(to)});
    t = set.across(t, vertex, to);
    from = to;
  }
  fan.last = static_cast<std::uint32_t>(corners_.size());
  fans_.push_back(fan);
}

double FanCorners::cost(std::size_t slot, const Selection& selected, const FitnessWeights& w,
                        double even) const {
  const Turns t = turns(slot, selected);
  return (w.slight + even * w.even_slight) * t.slight + (w.moderate + even * w.even_moderate) * t.moderate +
         (w.sharp + even * w.even_sharp) * t.sharp + w.pinch * t.pinches + w.isolated * t.isolated;
}

FanCorners::Turns FanCorners::turns(std::size_t slot, const Selection& selected) const {
  Turns sum;
  int fans = 0;
  for (std::uint32_t f = first_fan_[slot]; f < first_fan_[slot + 1]; ++f) {
    const Fan& fan = fans_[f];
    const std::uint32_t size = fan.last - fan.first;
    std::uint32_t begin = 0;  // for closed fans: a corner after a gap
    if (fan.closed) {
      while (begin < size && selected[corners_[fan.first + begin].triangle]) ++begin;
      if (begin == size) {
        ++fans;
        continue;
      }
    }
    const auto corner_at = [&](std::uint32_t i) -> const Corner& {  // cyclic; faster than a remainder
      return corners_[fan.first + (begin + i < size ? begin + i : begin + i - size)];
    };
    float from = 0;
    bool open = false;
    for (std::uint32_t i = 0; i < size; ++i) {
      const Corner& corner = corner_at(i);
      if (!selected[corner.triangle]) {
        open = false;
        continue;
      }
      if (!open) {
        open = true;
        ++fans;
        from = corner.from;
      }
      const bool ends = i + 1 == size || !selected[corner_at(i + 1).triangle];
      if (!ends) continue;
      // Both are angles in (-pi, pi], so this is the exact remainder modulo 2 pi.
      double between = std::abs(static_cast<double>(from - corner.to));
      if (between > std::numbers::pi) between = std::abs(between - 2 * std::numbers::pi);
      const double turning = std::numbers::pi - between;
      sum.slight += std::min(turning, model::turn_slight);
      sum.moderate += std::min(turning, model::turn_moderate);
      sum.sharp += turning;
    }
  }
  if (fans == 0) {
    sum.isolated = first_fan_[slot] != first_fan_[slot + 1];
  } else {
    sum.pinches = fans - 1;
  }
  return sum;
}

}  // namespace rimline
