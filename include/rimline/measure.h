// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of what came out, taken from the triangles alone.
#pragma once

#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

// `spacing` as of local_spacing(), one per point; `uv` one per point or empty. Throws Cancelled.
MeshSummary measure_mesh(Points points, const std::vector<Triangle>& triangles,
                         std::span<const double> spacing, std::span<const UV> uv, const Run& run = {});

SpacingSummary summarize_spacing(std::vector<double> spacing);

}  // namespace rimline
