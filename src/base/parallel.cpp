// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

namespace rimline {

void run_slices(std::size_t first, std::size_t last, std::size_t grain,
                void (*call)(const void* body, std::size_t begin, std::size_t end), const void* body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, grain),
                    [&](const auto& range) { call(body, range.begin(), range.end()); });
}

}  // namespace rimline
