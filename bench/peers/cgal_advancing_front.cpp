// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's advancing front (Cohen-Steiner, Da 2004) with its defaults: radius ratio bound 5, beta 0.52.
#include <CGAL/Advancing_front_surface_reconstruction.h>

#include <iterator>

#include "peers/cgal.h"

namespace rimline::peers {

Answer advancing_front(const Coordinates& points) {
  const auto given = to_cgal(points);
  std::vector<std::array<std::size_t, 3>> found;
  CGAL::advancing_front_surface_reconstruction(given.begin(), given.end(), std::back_inserter(found));
  Answer answer;
  for (const auto& t : found) {
    answer.triangles.push_back(
        {static_cast<std::int32_t>(t[0]), static_cast<std::int32_t>(t[1]), static_cast<std::int32_t>(t[2])});
  }
  return answer;
}

}  // namespace rimline::peers
