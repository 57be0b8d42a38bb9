// SPDX-License-Identifier: GPL-3.0-or-later
// One wide picture of what a run found, stage by stage: points, candidates, boundary, map, mesh.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/pipeline.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline::cli {

inline const Seams no_seams;

struct Scene {
  Points points;
  const BoundaryResult& boundary;
  std::span<const UV> uv = {};               // empty: no panel for the map
  std::span<const Triangle> triangles = {};  // empty: no panel for the mesh
  const Seams& seams = no_seams;             // of the map
  std::span<const Index> chart = {};         // of each triangle, or empty
  std::optional<Point> up = {};
  int panel_size = 620;                  // width and height of each panel's drawing, in pixels
  std::vector<std::string> panels = {};  // their titles, in order; empty for all that there are
};

// PNG or SVG by the ending. Points and surfaces are images in both, so that a million points is no trouble;
// lines and text are vectors in SVG. Throws CannotWrite, Cancelled.
void write_picture(const std::string& path, const Scene& scene, const Run& run);

}  // namespace rimline::cli
