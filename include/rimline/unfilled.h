// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors without zero-initialization. Where zeros are needed, src/base/prefault.h writes them in parallel.
#pragma once

#include <memory>
#include <new>
#include <vector>

namespace rimline {

// Leaves numbers uninitialized where std::allocator writes zeros. The pages of a large array are then
// assigned to the threads that write its items, and are written once.  [ours: zeros for a million lists of 40
// neighbours are half a gigabyte written by one thread]
template <class T>
struct UnfilledAllocator : std::allocator<T> {
  template <class U>
  void construct(U* item) noexcept {
    ::new (static_cast<void*>(item)) U;
  }
};

// resize() leaves new items uninitialized: the caller must write each.
template <class T>
using UnfilledVector = std::vector<T, UnfilledAllocator<T>>;

}  // namespace rimline
