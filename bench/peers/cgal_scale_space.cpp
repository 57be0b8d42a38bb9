// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's scale space reconstruction (Digne et al. 2011) as its manual runs it: four weighted PCA smoothings,
// then a mesh at that scale, whose vertices are the input points again.
#include <CGAL/Scale_space_reconstruction_3/Advancing_front_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Alpha_shape_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Weighted_PCA_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>

#include "peers/cgal.h"

namespace rimline::peers {
namespace {

using Reconstruction = CGAL::Scale_space_surface_reconstruction_3<Kernel>;
using Smoother = CGAL::Scale_space_reconstruction_3::Weighted_PCA_smoother<Kernel>;
using AlphaMesher = CGAL::Scale_space_reconstruction_3::Alpha_shape_mesher<Kernel>;
using FrontMesher = CGAL::Scale_space_reconstruction_3::Advancing_front_mesher<Kernel>;

constexpr int smoothings = 4;

Answer facets_of(const Reconstruction& reconstruction) {
  Answer answer;
  for (auto f = reconstruction.facets_begin(); f != reconstruction.facets_end(); ++f) {
    answer.triangles.push_back({static_cast<std::int32_t>((*f)[0]), static_cast<std::int32_t>((*f)[1]),
                                static_cast<std::int32_t>((*f)[2])});
  }
  return answer;
}

}  // namespace

Answer scale_space_alpha(const Coordinates& points) {
  const auto given = to_cgal(points);
  Reconstruction reconstruction(given.begin(), given.end());
  Smoother smoother;
  reconstruction.increase_scale(smoothings, smoother);
  reconstruction.reconstruct_surface(AlphaMesher(smoother.squared_radius()));
  return facets_of(reconstruction);
}

Answer scale_space_advancing_front(const Coordinates& points) {
  const auto given = to_cgal(points);
  Reconstruction reconstruction(given.begin(), given.end());
  reconstruction.increase_scale(smoothings, Smoother());
  reconstruction.reconstruct_surface(FrontMesher());
  return facets_of(reconstruction);
}

}  // namespace rimline::peers
