// SPDX-License-Identifier: GPL-3.0-or-later
// An estimate of the memory that a run will take.
#pragma once

#include <cstddef>
#include <vector>

#include "rimline/options.h"
#include "rimline/run.h"

namespace rimline {

struct StageMemory {
  Stage stage;
  std::size_t bytes;  // peak memory of the process during the stage, the input's points included
};

// An upper estimate for each stage of reconstruct() in its order: bytes per point and per neighbour times the
// number of points, with the figures of docs/memory.md.
std::vector<StageMemory> estimate_memory(std::size_t points, const Options& options);

// Throws OutOfMemory where a stage up to and including `last` would take more than run.memory_limit.
void check_memory(std::size_t points, const Options& options, Stage last, const Run& run);

}  // namespace rimline
