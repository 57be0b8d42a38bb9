// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/point_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "rimline/arrange.h"
#include "rimline/io.h"

namespace rimline::bench {
namespace {

constexpr double crease_angle = 30 * std::numbers::pi / 180;

Point normal_of(const std::vector<Point>& points, const Triangle& t) {
  const Point n = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  const double length = norm(n);
  return length > 0 ? (1 / length) * n : Point{};
}

// Ids of the input on edges whose two triangles fold.
std::vector<char> on_creases(const MeshFile& mesh) {
  std::map<std::pair<Index, Index>, std::vector<Point>> normals;
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c)
      normals[std::minmax(t[c], t[(c + 1) % 3])].push_back(normal_of(mesh.cloud.points, t));
  }
  std::vector<char> on(mesh.cloud.points.size(), 0);
  for (const auto& [ends, both] : normals) {
    if (both.size() != 2 || dot(both[0], both[1]) > std::cos(crease_angle)) continue;
    on[ends.first] = on[ends.second] = 1;
  }
  return on;
}

}  // namespace

PointSet read_point_set(const std::string& path, const std::string& truth, int k) {
  const Cloud cloud = read_cloud(path, {});
  Arrangement arranged = arrange(cloud.points, {});
  PointSet set;
  set.neighbours = find_neighbours(arranged.points, k, {});
  if (leave_out_stray(arranged, set.neighbours)) set.neighbours = find_neighbours(arranged.points, k, {});
  set.points = arranged.points;
  set.spacing = local_spacing(set.points, set.neighbours);
  set.asked.assign(set.points.size(), 1);
  const Column* flag = cloud.find("boundary");
  for (Index i = 0; flag != nullptr && i < static_cast<Index>(set.points.size()); ++i) {
    const double value = flag->value(arranged.ids[i]);
    if (value == 1) set.rim.push_back(i);
    if (value == 2) set.asked[i] = 0;
  }
  if (truth.empty() || !std::filesystem::exists(truth)) return set;
  const MeshFile mesh = read_mesh(truth, {});
  if (mesh.cloud.points != cloud.points) return set;  // a reference surface with vertices of its own
  const std::vector<char> on = on_creases(mesh);
  for (Index i = 0; i < static_cast<Index>(set.points.size()); ++i) {
    if (on[arranged.ids[i]] != 0) set.creases.push_back(i);
  }
  return set;
}

std::vector<char> near(const PointSet& set, std::span<const Index> ids, std::span<const Index> others) {
  std::vector<Index> by_x(others.begin(), others.end());
  std::sort(by_x.begin(), by_x.end(), [&](Index a, Index b) { return set.points[a].x < set.points[b].x; });
  std::vector<char> result;
  for (const Index i : ids) {
    const Point p = set.points[i];
    auto at = std::lower_bound(by_x.begin(), by_x.end(), p.x - set.spacing[i],
                               [&](Index a, double x) { return set.points[a].x < x; });
    const auto is_beyond = [&](auto it) {
      return it == by_x.end() || set.points[*it].x > p.x + set.spacing[i];
    };
    while (!is_beyond(at) && distance(set.points[*at], p) > set.spacing[i]) ++at;
    result.push_back(!is_beyond(at));
  }
  return result;
}

double share_near(const PointSet& set, std::span<const Index> ids, std::span<const Index> others) {
  const std::vector<char> is_near = near(set, ids, others);
  std::size_t counted = 0, found = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (set.asked[ids[i]] == 0) continue;
    ++counted;
    found += is_near[i] != 0;
  }
  return counted == 0 ? 0 : static_cast<double>(found) / static_cast<double>(counted);
}

}  // namespace rimline::bench
