// SPDX-License-Identifier: GPL-3.0-or-later
// What the mesh does not have, told so that something can be done about it.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"
#include "rimline/refine_surface.h"

namespace rimline::pipeline {

// What to try where a component is left out.
inline constexpr const char* remedy_of_component =
    "crop the box out and look at the loops there; --use-loops takes corrected ones";

// Points of the arrangement, not none, told in ids and coordinates of the input: without cause and remedy.
LeftOut points_left_out(const PreparedPoints& prepared, const std::vector<Index>& points);

// One entry for each component that could not be meshed and for each group of points in no triangle that hang
// together by their six nearest neighbours, the largest first; in ids of the input.
std::vector<LeftOut> describe_left_out(const PreparedPoints& prepared, const Surface& surface);

// Why there is no mesh to give: not a triangle, or under `strict` a part of the surface that it does not
// have: a component that failed, or a group of at least ten points. Nothing where there is one.
std::optional<Error> why_no_mesh(const MappedMesh& mesh, bool strict);

}  // namespace rimline::pipeline
