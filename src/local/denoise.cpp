// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/denoise.h"

#include <utility>

namespace rimline {

std::optional<DenoisedPoints> denoise(Points points, const Neighbours& neighbours,
                                      const SamplingProfile& sampling, const Run& run) {
  if (sampling.noise_weight == 0) return {};
  DenoisedPoints moved;
  moved.points = take_off_noise(points, neighbours, sampling.noise_weight, run);
  moved.neighbours = find_neighbours(moved.points, neighbours.k, run);
  for (Index i = 0; i < moved.neighbours.size(); ++i) {
    if (distance_to(moved.points, moved.neighbours, i, 0) == 0) return {};
  }
  moved.spacing = local_spacing(moved.points, moved.neighbours, run);
  return moved;
}

}  // namespace rimline
