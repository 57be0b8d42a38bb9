// SPDX-License-Identifier: GPL-3.0-or-later
// Lists what the mesh does not contain, with causes and remedies.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"
#include "rimline/refine_surface.h"

namespace rimline::pipeline {

// The remedy for a component that is left out.
inline constexpr const char* remedy_of_component =
    "crop the box out and look at the loops there; --use-loops takes corrected ones";

// An entry for points of the arrangement (at least one), in ids and coordinates of the input, without cause
// and remedy.
LeftOut points_left_out(const PreparedPoints& prepared, const std::vector<Index>& points);

// One entry for each component that could not be meshed and for each connected group of points in no triangle
// (by their six nearest neighbours), the largest first; in ids of the input.
std::vector<LeftOut> describe_left_out(const PreparedPoints& prepared, const Surface& surface);

// The reason why there is no mesh to return: no triangle, or under `strict` anything that is left out. None
// where there is a mesh.
std::optional<Error> why_no_mesh(const MappedMesh& mesh, bool strict);

}  // namespace rimline::pipeline
