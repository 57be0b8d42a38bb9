// SPDX-License-Identifier: GPL-3.0-or-later
// A method: how the loops are found, and how the surface that they bound is mapped and meshed.
#pragma once

#include <string>
#include <vector>

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"
#include "rimline/boundary_loops.h"
#include "rimline/score_boundary.h"

namespace rimline::pipeline {

// The loops, and further results of their search.
struct FoundLoops {
  std::vector<Loop> loops;
  std::vector<DoubtfulGap> doubtful;  // of the default method
  std::vector<float> probability;     // per point; of the default method
  std::vector<PointLabel> label;      // per point; of the default method
  std::vector<Triangle> surface;      // that the loops were found on; of the default method
  bool range_scan = false;            // BoundaryLoops::range_scan
  bool closed = false;                // there are no loops, and most points lie on closed surfaces
  SearchSummary search;
  std::vector<Index> winner;  // the winning chromosome; of the paper's
  SearchHistory history;      // likewise
  std::vector<std::string> warnings;
};

// The functions that differ between the presets. Everything else is common to them.
struct Method {
  FoundLoops (*find_loops)(const PreparedPoints&, const BoundaryScores&, const Options&, const Given&,
                           const Run&, StageClock&);

  // Makes the map, and the triangles where they come with it.
  MappedMesh (*map)(const PreparedPoints&, const FoundLoops&, const Options&, const Given&, const Run&,
                    StageClock&);

  // Makes the map and the triangles.
  MappedMesh (*mesh)(const PreparedPoints&, const FoundLoops&, const Options&, const Given&, const Run&,
                     StageClock&);
};

// Sections 3 and 5 of the paper, and the default method in their place.
const Method& method_of_the_paper();
const Method& default_method();

// The method is chosen here and nowhere else.
const Method& method_of(Preset preset);

}  // namespace rimline::pipeline
