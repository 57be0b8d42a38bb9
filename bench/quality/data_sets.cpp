// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/data_sets.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "quality/ply_faces.h"
#include "rimline/io.h"
#include "rimline/run.h"

namespace rimline::bench {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& folders) {
  std::vector<std::string> parts;
  std::istringstream names(folders);
  for (std::string folder; std::getline(names, folder, ':');) parts.push_back(folder);
  return parts;
}

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

namespace {

// The style of each set that a corpus lists; empty where the folder is none.
std::map<std::string, std::string> styles_of(const std::string& folder) {
  std::map<std::string, std::string> styles;
  std::ifstream file(folder + "/index.json");
  if (!file) return styles;
  const auto index = nlohmann::json::parse(file);
  for (const auto& set : index.at("sets")) styles[set.at("name")] = set.at("style");
  return styles;
}

}  // namespace

std::vector<CaseName> data_cases(const std::string& folders) {
  std::map<std::string, std::string> names;  // style, "" of data sets; two folders may have the same set
  for (const std::string& folder : split(folders)) {
    const auto styles = styles_of(folder);
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::path file = entry.path().filename();
      // "mannequin.ply", not "mannequin.truth.ply"
      if (file.extension() != ".ply" || file.stem().has_extension()) continue;
      const auto style = styles.find(file.stem().string());
      names.emplace(file.stem().string(), style == styles.end() ? "" : style->second);
    }
  }
  std::vector<CaseName> cases;
  for (const auto& [name, style] : names)
    cases.push_back({style.empty() ? "data" : "corpus", name, style, 0, 0, 0, 1});
  return cases;
}

std::string data_path(const std::string& folders, const std::string& file) {
  for (const std::string& folder : split(folders)) {
    if (fs::exists(folder + "/" + file)) return folder + "/" + file;
  }
  return folders + "/" + file;
}

Case read_data_set(const std::string& folders, const CaseName& name) {
  const std::string set = data_path(folders, name.shape + ".ply");
  const std::string stem = set.substr(0, set.size() - std::string(".ply").size());
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
