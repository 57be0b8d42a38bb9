// SPDX-License-Identifier: GPL-3.0-or-later
// Requests huge pages for large arrays of the tool: a scan of a million points needs hundreds of megabytes,
// and address translation of small pages is slow. Only in the tool: a library leaves memory to its host.
// docs/lab has the measurement.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t page = std::size_t{1} << 21, least = 4 * page;

}  // namespace

void* operator new(std::size_t size) {
  void* memory = nullptr;
  if (size < least) {
    memory = std::malloc(size > 0 ? size : 1);
  } else if (size <= static_cast<std::size_t>(-1) - page) {
    const std::size_t whole = (size + page - 1) / page * page;
    memory = std::aligned_alloc(page, whole);
    if (memory != nullptr) ::madvise(memory, whole, MADV_HUGEPAGE);  // advice: no error matters
  }
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif
