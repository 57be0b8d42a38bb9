// SPDX-License-Identifier: GPL-3.0-or-later
// One question of the bench: points, and what is known to be true of them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "quality/edge_set.h"
#include "rimline/mesh.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline::bench {

// What a sample of an analytic surface is measured against.
struct TrueSurface {
  std::vector<Point> points;  // a dense, even sample without noise: four times the points of the case
  double area = 0;
  long long euler = 0;
  std::size_t loops = 0;
};

// A name as the tables and --cases see it, and where the case stands in them.
struct CaseName {
  std::string group;     // "analytic", "topology", "data" or "corpus": a set whose folder has an index
  std::string shape;     // of a set: its name
  std::string sampling;  // empty for a data set; of a set of a corpus the style that the index tells
  double noise = 0;      // in local mean nearest-neighbour distances
  std::size_t n = 0;     // points asked for; of a data set those it has
  int draw = 0;          // which of the seeds of the case, from 0
  std::uint64_t seed = 1;

  // "flat-disc/random/n1000/noise0.2/3", or "data/mannequin".
  std::string text() const;
  bool is_file() const { return group == "data" || group == "corpus"; }
};

struct Case {
  CaseName name;
  std::vector<Point> points;
  std::vector<std::uint8_t> boundary;  // 1 on the boundary, 0 not, 2 not asked; empty where it is not known
  std::vector<std::uint8_t> rim;       // 1 on a true loop: differs from `boundary` for random sampling alone
  bool has_loops = false;
  std::vector<EdgeSet> loops;     // the true loops; those that meet in a point are one
  std::vector<Triangle> mesh;     // of the truth, over the same points; empty where there is none
  std::vector<Triangle> flipped;  // the same after 3D flips
  std::shared_ptr<const TrueSurface> surface;  // of analytic cases that are meshed

  Neighbours neighbours;        // the nearest twelve
  std::vector<double> spacing;  // mean distance to the nearest six
};

// Fills neighbours and spacing.
void measure_spacing(Case& c);

}  // namespace rimline::bench
