// SPDX-License-Identifier: GPL-3.0-or-later
// What leaving single triangles out is worth, beside the truth.
#pragma once

#include <vector>

#include "local/samples.h"
#include "local/sampling_profile.h"
#include "search/select.h"

// Prints a line `triangles` for each triangle of the surface that is at its rim or may be left out, where the
// true loops are edges of triangles: 1 where truth leaves it out, then what leaving it out adds to each term
// of the fitness, all other triangles as truth has them. `loops`: the true ones, by the ids of the points.
void print_triangles(const rimline::SelectedSurface& surface, const rimline::Samples& samples,
                     const rimline::SamplingProfile& sampling,
                     const std::vector<std::vector<rimline::Index>>& loops, const rimline::Run& run);
