// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/data_sets.h"

#include <algorithm>
#include <filesystem>

#include "quality/ply_faces.h"
#include "rimline/io.h"
#include "rimline/run.h"

namespace rimline::bench {
namespace {

namespace fs = std::filesystem;

void read_truth_mesh(const std::string& stem, Case& c) {
  const std::string path = stem + ".truth.ply";
  if (!fs::exists(path)) return;
  if (read_cloud(path, {}).points != c.points) return;  // a reference surface with vertices of its own
  c.mesh = read_ply_faces(path);
  c.loops = connected_pieces(boundary_of(edges_of_mesh(c.mesh)));
  c.has_loops = true;
  if (fs::exists(stem + ".flipped.ply")) c.flipped = read_ply_faces(stem + ".flipped.ply");
}

void read_truth_loops(const std::string& stem, Case& c) {
  const std::string path = stem + ".loops.json";
  if (c.has_loops || !fs::exists(path)) return;
  for (const Loop& loop : read_loops(path, c.points.size())) c.loops.push_back(edges_of_loop(loop.points));
  c.has_loops = true;
}

}  // namespace

std::vector<CaseName> data_cases(const std::string& folder) {
  std::vector<CaseName> cases;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path file = entry.path().filename();
    // "mannequin.ply", not "mannequin.truth.ply"
    if (file.extension() != ".ply" || file.stem().has_extension()) continue;
    cases.push_back({"data", file.stem().string(), "", 0, 0, 0, 1});
  }
  std::sort(cases.begin(), cases.end(), [](const auto& a, const auto& b) { return a.shape < b.shape; });
  return cases;
}

Case read_data_set(const std::string& folder, const CaseName& name) {
  const std::string stem = folder + "/" + name.shape;
  Cloud cloud = read_cloud(stem + ".ply", {});
  Case c;
  c.name = name;
  c.points = std::move(cloud.points);
  c.name.n = c.points.size();
  if (const Column* flag = cloud.find("boundary")) {
    for (Index i = 0; i < static_cast<Index>(c.points.size()); ++i) {
      c.boundary.push_back(static_cast<std::uint8_t>(flag->value(i)));
    }
    c.rim = c.boundary;
  }
  read_truth_mesh(stem, c);
  read_truth_loops(stem, c);
  measure_spacing(c);
  return c;
}

}  // namespace rimline::bench
