// SPDX-License-Identifier: GPL-3.0-or-later
// The raster that a scanner wrote down: triangles between samples in neighbouring cells.
#pragma once

#include <optional>
#include <vector>

#include "rimline/given.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"
#include "surface/range_image.h"

namespace rimline {

// The range image of points that were taken in these cells, one each: spherical, parallel or any other. None
// where there are fewer than 200 points, where two have the same cell, and where the cells do not fit the
// points: 80 % of the samples have their nearest neighbour, or one no more than half again as far, beside
// them in the raster. A first column that lies beside the last one is its neighbour (a full turn).
//
// The triangles are the halves of the cells, along the diagonal that gives more of them, the shorter one
// where both do. An edge longer than six steps is a depth jump (find_range_image); the step at a sample is
// the least distance to a neighbour in the raster, as the median over 3 x 3 samples has it, since a surface
// seen at a glancing angle is stretched in one direction alone. Rows may be finer than columns: their ratio
// is the median over all samples. [ours]
std::optional<RangeImage> image_of_raster(Points points, const Neighbours& neighbours,
                                          const std::vector<RasterCell>& cells, const Run& run);

// The range image of the raster that the scanner wrote down, where there is one, else of one that is seen.
std::optional<RangeImage> find_range_image(Points points, const Neighbours& neighbours,
                                           const std::vector<RasterCell>& cells, const Run& run);

}  // namespace rimline
