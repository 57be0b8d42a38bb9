// SPDX-License-Identifier: GPL-3.0-or-later
// Selection without branches on the values: half of the branches would be mispredicted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace rimline {

// Moves the items whose value is below the pivot (or not above it) to the front. The result of a comparison
// is added, not branched on.
template <class Item, class Value, class Compare>
Item* partition_by(Item* first, Item* last, const Value& value, double pivot, const Compare& is_low) {
  Item* high = first;
  for (Item* i = first; i < last; ++i) {
    const Item item = *i;
    *i = *high;
    *high = item;
    high += is_low(value(item), pivot);
  }
  return high;
}

// The same as std::nth_element by value(item), a number; items of the same value are in any order, but always
// the same one.
template <class Item, class Value>
void select(Item* first, Item* nth, Item* last, const Value& value) {
  constexpr std::ptrdiff_t few = 16;
  const auto middle_of = [](double a, double b, double c) {
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
  };
  while (last - first > few) {
    const auto sample = [&](int part) { return value(first[part * (last - first - 1) / 8]); };
    const double pivot =
        middle_of(middle_of(sample(0), sample(1), sample(2)), middle_of(sample(3), sample(4), sample(5)),
                  middle_of(sample(6), sample(7), sample(8)));
    Item* high = partition_by(first, last, value, pivot, std::less<>());
    if (high == first) {  // the pivot is the minimum: items equal to it need no order
      high = partition_by(first, last, value, pivot, std::less_equal<>());
      if (nth < high) return;
    }
    nth < high ? last = high : first = high;
  }
  std::nth_element(first, nth, last, [&](const Item& a, const Item& b) { return value(a) < value(b); });
}

}  // namespace rimline
