// SPDX-License-Identifier: GPL-3.0-or-later
// The Point Cloud Library: boundary estimation by the largest angle between neighbours, and greedy projection
// (Marton, Rusu, Beetz 2009) with the settings of its tutorial.
#include <pcl/common/io.h>
#include <pcl/features/boundary.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "peers/protocol.h"

namespace rimline::peers {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

constexpr double degree = std::numbers::pi / 180;

// PCL has floats alone, so the origin moves to the first point: map coordinates would lose centimetres.
Cloud::Ptr to_pcl(const Coordinates& points) {
  auto cloud = std::make_shared<Cloud>();
  for (const auto& p : points) {
    cloud->push_back({static_cast<float>(p[0] - points[0][0]), static_cast<float>(p[1] - points[0][1]),
                      static_cast<float>(p[2] - points[0][2])});
  }
  return cloud;
}

Normals::Ptr normals_of(const Cloud::Ptr& cloud, int k) {
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(std::make_shared<Tree>());
  estimation.setKSearch(k);
  auto normals = std::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

// A point is on the boundary where the largest angle between neighbours in the plane exceeds `angle`.
Answer boundary(const Coordinates& points, int normal_k, int k, double angle) {
  const Cloud::Ptr cloud = to_pcl(points);
  pcl::BoundaryEstimation<pcl::PointXYZ, pcl::Normal, pcl::Boundary> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals_of(cloud, normal_k));
  estimation.setSearchMethod(std::make_shared<Tree>());
  estimation.setKSearch(k);
  estimation.setAngleThreshold(static_cast<float>(angle));
  pcl::PointCloud<pcl::Boundary> found;
  estimation.compute(found);
  Answer answer;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].boundary_point != 0) answer.boundary.push_back(static_cast<std::int32_t>(i));
  }
  return answer;
}

double mean_spacing(const Cloud::Ptr& cloud) {
  Tree tree;
  tree.setInputCloud(cloud);
  pcl::Indices ids;
  std::vector<float> squared;
  double sum = 0;
  for (const auto& p : *cloud) {
    tree.nearestKSearch(p, 7, ids, squared);
    for (const float d : squared) sum += std::sqrt(d) / 6;
  }
  return sum / static_cast<double>(cloud->size());
}

Answer greedy_projection(const Coordinates& points) {
  const Cloud::Ptr cloud = to_pcl(points);
  const Normals::Ptr normals = normals_of(cloud, 20);
  auto both = std::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  pcl::concatenateFields(*cloud, *normals, *both);
  auto tree = std::make_shared<pcl::search::KdTree<pcl::PointNormal>>();
  tree->setInputCloud(both);
  pcl::GreedyProjectionTriangulation<pcl::PointNormal> triangulation;
  // The tutorial's radius is in the unit of its cloud; five spacings, as for Co3Ne, is no smaller there.
  triangulation.setSearchRadius(5 * mean_spacing(cloud));
  triangulation.setMu(2.5);
  triangulation.setMaximumNearestNeighbors(100);
  triangulation.setMaximumSurfaceAngle(45 * degree);
  triangulation.setMinimumAngle(10 * degree);
  triangulation.setMaximumAngle(120 * degree);
  triangulation.setNormalConsistency(false);
  triangulation.setInputCloud(both);
  triangulation.setSearchMethod(tree);
  std::vector<pcl::Vertices> polygons;
  triangulation.reconstruct(polygons);
  Answer answer;
  for (const auto& p : polygons) answer.triangles.push_back({p.vertices[0], p.vertices[1], p.vertices[2]});
  return answer;
}

}  // namespace
}  // namespace rimline::peers

int main(int argc, char** argv) {
  using namespace rimline::peers;
  const auto boundary_at = [](int normal_k, int k, double degrees) {
    return [=](const Coordinates& points) { return boundary(points, normal_k, k, degrees * degree); };
  };
  return serve(argc, argv,
               {{"boundary-30-90", boundary_at(20, 30, 90)},
                {"boundary-40-90", boundary_at(30, 40, 90)},
                {"boundary-40-120", boundary_at(30, 40, 120)},
                {"greedy-projection", greedy_projection}});
}
