// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors that are not filled with zeros first. Where zeros are asked for, src/base/prefault.h shares their
// pages.
#pragma once

#include <memory>
#include <new>
#include <vector>

namespace rimline {

// Leaves numbers as they are where std::allocator writes zeros. A large array is then handed out by the
// system page by page to the threads that write its items, and written once.  [ours: zeros for a million
// lists of 40 neighbours are half a gigabyte written by one thread while the others wait]
template <class T>
struct UnfilledAllocator : std::allocator<T> {
  template <class U>
  void construct(U* item) noexcept {
    ::new (static_cast<void*>(item)) U;
  }
};

// resize() gives items no value: whoever asks for them writes each.
template <class T>
using UnfilledVector = std::vector<T, UnfilledAllocator<T>>;

}  // namespace rimline
