// SPDX-License-Identifier: GPL-3.0-or-later
// The Voronoi cell of a point in its tangent plane, cut by one bisector after another.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "rimline/points.h"

namespace rimline {

// Corners are relative to the point, each with the neighbour whose bisector is the side that leaves it. Each
// coordinate is an array, so that a bisector is compared with several corners at once.
class VoronoiCell {
 public:
  VoronoiCell() { reserve(few); }

  // A square.
  void reset(double half_width) {
    count_ = 4;
    constexpr double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    for (int i = 0; i < 4; ++i) now_.put(i, half_width * x[i], half_width * y[i], none);
    radius_squared_ = 2 * half_width * half_width;
  }

  // Whether no point at this squared distance or beyond can cut the cell any more.
  bool is_settled(double squared_distance) const { return squared_distance > 4 * radius_squared_; }

  // The neighbour beyond each side, counter-clockwise; `none` where the cell is open.
  std::span<const Index> sides() const { return {now_.side.data(), count_}; }
  double side_length(std::size_t side) const {
    const std::size_t end = next_in(side, count_);
    const double x = now_.x[end] - now_.x[side], y = now_.y[end] - now_.y[side];
    return std::sqrt(x * x + y * y);
  }
  bool is_closed() const { return std::ranges::find(sides(), none) == sides().end(); }

  // Keeps a x + b y <= c.
  void cut(double a, double b, double c, Index side) {
    if (count_ > few) return cut_many(a, b, c, side);
    std::uint32_t beyond = 0;  // a bit for each corner that goes
    for (std::size_t i = 0; i < count_; ++i) {
      beyond_[i] = a * now_.x[i] + b * now_.y[i] - c;
      beyond |= static_cast<std::uint32_t>(beyond_[i] > 0) << i;
    }
    if (beyond == 0) return;
    const std::uint32_t all = (std::uint32_t{1} << count_) - 1;
    const std::uint32_t before = beyond << 1 | beyond >> (count_ - 1);  // the bit of the corner before each
    const std::uint32_t first = beyond & ~before & all, kept = before & ~beyond & all;
    // Consecutive corners are cut off; rounding can bend a side, so that all are, or several runs.
    if (first != 0 && (first & (first - 1)) == 0) {
      cut_row(static_cast<std::size_t>(std::countr_zero(first)),
              static_cast<std::size_t>(std::countr_zero(kept)), side);
    } else {
      clip(side);
    }
  }

 private:
  static constexpr std::size_t few = 16;  // corners of nearly all cells [speed]

  struct Corners {
    std::vector<double> x, y;
    std::vector<Index> side;

    void put(std::size_t i, double at_x, double at_y, Index leaving) {
      x[i] = at_x, y[i] = at_y, side[i] = leaving;
    }
    // Moves corners to another position: always the same number, which avoids a loop of unknown length.
    void move(std::size_t from, std::size_t to) {
      move_few(x.data() + from, x.data() + to);
      move_few(y.data() + from, y.data() + to);
      move_few(side.data() + from, side.data() + to);
    }
    template <class Item>
    static void move_few(const Item* from, Item* to) {
      Item items[few];
      std::memcpy(items, from, sizeof(items));
      std::memcpy(to, items, sizeof(items));
    }
  };
  struct Corner {
    double x, y;
  };

  // Where the bisector meets the side from corner i to corner j.
  Corner meet(std::size_t i, std::size_t j) const {
    const double t = beyond_[i] / (beyond_[i] - beyond_[j]);
    return {now_.x[i] + t * (now_.x[j] - now_.x[i]), now_.y[i] + t * (now_.y[j] - now_.y[i])};
  }

  // Cuts off the corners from `first` to the one before `kept`, by way of corner 0 where `kept` is not above.
  void cut_row(std::size_t first, std::size_t kept, Index side) {
    const std::size_t before = first == 0 ? count_ - 1 : first - 1, last = kept == 0 ? count_ - 1 : kept - 1;
    const Corner in = meet(before, first), out = meet(last, kept);
    const Index out_side = now_.side[last];
    if (first < kept) {
      const std::size_t row = kept - first;
      if (first == 0) {  // both new corners lie between the last one and the first that is kept
        now_.move(kept, 1);
        now_.put(0, out.x, out.y, out_side);
        now_.put(count_ - row + 1, in.x, in.y, side);
      } else {
        now_.move(kept, first + 2);
        now_.put(first, in.x, in.y, side);
        now_.put(first + 1, out.x, out.y, out_side);
      }
      count_ = count_ - row + 2;
    } else {
      now_.move(kept, kept == 0 ? 0 : 1);
      if (kept != 0) now_.put(0, out.x, out.y, out_side);
      count_ = first - kept + 2;
      if (kept == 0) {
        now_.put(count_ - 2, in.x, in.y, side);
        now_.put(count_ - 1, out.x, out.y, out_side);
      } else {
        now_.put(count_ - 1, in.x, in.y, side);
      }
    }
    reserve(count_);
    measure();
  }

  // The same as cut(), for any number of corners.
  void cut_many(double a, double b, double c, Index side) {
    double farthest = a * now_.x[0] + b * now_.y[0] - c;
    for (std::size_t i = 0; i < count_; ++i) {
      beyond_[i] = a * now_.x[i] + b * now_.y[i] - c;
      farthest = std::max(farthest, beyond_[i]);
    }
    if (farthest > 0) clip(side);
  }

  // The general case: any set of corners is cut off.
  void clip(Index side) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t j = next_in(i, count_);
      if (beyond_[i] <= 0) next_.put(next++, now_.x[i], now_.y[i], now_.side[i]);
      if ((beyond_[i] <= 0) == (beyond_[j] <= 0)) continue;
      const Corner corner = meet(i, j);
      next_.put(next++, corner.x, corner.y, beyond_[i] <= 0 ? side : now_.side[i]);
    }
    count_ = next;
    std::swap(now_, next_);
    reserve(count_);
    measure();
  }

  // Reserves room for any cut of so many corners: where rounding bends sides it may add half as many.
  void reserve(std::size_t count) {
    if (beyond_.size() >= 2 * count + few) return;
    beyond_.resize(4 * count + few);
    for (Corners* corners : {&now_, &next_}) {
      corners->x.resize(beyond_.size());
      corners->y.resize(beyond_.size());
      corners->side.resize(beyond_.size());
    }
  }
  void measure() {
    radius_squared_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      radius_squared_ = std::max(radius_squared_, now_.x[i] * now_.x[i] + now_.y[i] * now_.y[i]);
    }
  }

  std::size_t count_ = 0;
  Corners now_, next_;
  std::vector<double> beyond_;
  double radius_squared_ = 0;
};

}  // namespace rimline
