// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "quality/pages.h"
#include "quality/table.h"
#include "rimline/sample.h"

namespace rimline::bench {
namespace {

using Titles = std::vector<std::pair<std::string, std::string>>;

Rows meshes_of(const Results& results, const std::string& method, const std::string& group) {
  return choose(results.rows, [&](const Row& row) {
    return row.method == method && row.name.group == group && !row.mesh.empty();
  });
}

Titles mesh_methods(const Results& results) {
  Titles methods;
  for (const auto& title : results.titles) {
    if (!meshes_of(results, title.first, "analytic").empty() ||
        !meshes_of(results, title.first, "data").empty())
      methods.push_back(title);
  }
  return methods;
}

// Shapes on which every draw is sound, and those on which not.
std::string sound_cell(const Rows& rows) {
  std::map<std::string, bool> sound;
  for (const Row* row : rows) {
    const auto found = row->mesh.find("sound");
    bool& all = sound.try_emplace(row->name.shape, true).first->second;
    all = all && found != row->mesh.end() && found->second == 1;
  }
  if (sound.empty()) return "-";
  const auto good = std::count_if(sound.begin(), sound.end(), [](const auto& s) { return s.second; });
  return fmt::format("{} of {}", good, sound.size());
}

std::string sound_table(const Results& results) {
  std::vector<std::string> header{"sampling", "noise"};
  const Titles methods = mesh_methods(results);
  for (const auto& [id, title] : methods) header.push_back(title);
  Table table(header);
  for (const Sampling sampling : all_samplings()) {
    for (const double noise : {0.0, 0.1, 0.2, 0.5}) {
      std::vector<std::string> cells{name(sampling), fmt::format("{}", noise)};
      bool any = false;
      for (const auto& [id, title] : methods) {
        cells.push_back(sound_cell(choose(meshes_of(results, id, "analytic"), [&](const Row& r) {
          return r.name.sampling == name(sampling) && r.name.noise == noise;
        })));
        any = any || cells.back() != "-";
      }
      if (any) table.add(std::move(cells));
    }
  }
  return table.markdown();
}

std::string why_not_sound(const Row& row) {
  if (!row.mesh_error.empty() || !row.error.empty()) return row.error + row.mesh_error;
  std::string parts;
  for (const char* part : {"topology", "manifold", "distance", "area", "boundary"}) {
    const auto found = row.mesh.find(std::string("sound_") + part);
    if (found == row.mesh.end() || found->second == 0) parts += std::string(parts.empty() ? "" : ", ") + part;
  }
  return parts;
}

std::string unsound_table(const Results& results) {
  Table table({"case of the default that is not sound", "what fails"});
  for (const Row* row : meshes_of(results, default_method, "analytic")) {
    const auto sound = row->mesh.find("sound");
    if (row->name.noise <= 0.2 && (sound == row->mesh.end() || sound->second == 0)) {
      table.add({row->name.text(), why_not_sound(*row)});
    }
  }
  return table.empty() ? std::string() : fmt::format("\n{}", table.markdown());
}

std::string cell(const Row& row, const char* metric, int digits = 3) {
  const auto found = row.mesh.find(metric);
  return found == row.mesh.end() ? "-" : number(found->second, digits);
}

std::string percent(const Row& row, const char* metric) {
  const auto found = row.mesh.find(metric);
  return found == row.mesh.end() ? "-" : fmt::format("{:.2f} %", 100 * found->second);
}

std::string default_table(const Results& results) {
  Table table({"set", "points used", "non-manifold edges, vertices", "degenerate", "conflicts",
               "Euler / true", "loops / true", "rim is the loops", "edges agree, flipped", "rim edges F1",
               "rim points F1", "long edges (truth)", "slivers (truth)", "area / truth",
               "self-intersections (truth)", "uv flips", "angle error"});
  for (const Row* row : meshes_of(results, default_method, "data")) {
    table.add(
        {row->name.shape, cell(*row, "points_used", 4),
         cell(*row, "nonmanifold_edges", 0) + ", " + cell(*row, "nonmanifold_vertices", 0),
         cell(*row, "degenerate_faces", 0), cell(*row, "orientation_conflicts", 0),
         cell(*row, "euler", 0) + " / " + cell(*row, "euler_true", 0),
         cell(*row, "boundary_loops", 0) + " / " + cell(*row, "loops_true", 0),
         cell(*row, "boundary_is_loops", 0), cell(*row, "edges_agree_flipped"),
         cell(*row, "boundary_edges_f1"), cell(*row, "boundary_points_f1"),
         percent(*row, "edges_longer_than_3_spacings") + " (" +
             percent(*row, "edges_longer_than_3_spacings_in_truth") + ")",
         percent(*row, "min_angle_below_10deg") + " (" + percent(*row, "min_angle_below_10deg_in_truth") +
             ")",
         cell(*row, "area_over_truth"),
         cell(*row, "self_intersections", 0) + " (" + cell(*row, "self_intersections_in_truth", 0) + ")",
         cell(*row, "uv_flipped_triangles", 0), cell(*row, "uv_mean_angle_error_rad")});
  }
  return table.markdown();
}

std::vector<std::string> meshed_sets(const Results& results, const char* metric) {
  std::set<std::string> sets;
  for (const Row& row : results.rows) {
    if (row.name.group == "data" && row.mesh.contains(metric)) sets.insert(row.name.shape);
  }
  return {sets.begin(), sets.end()};
}

std::string compared_sets(const Results& results) {
  std::vector<std::string> header{"set"};
  const Titles methods = mesh_methods(results);
  for (const auto& [id, title] : methods) header.push_back(title);
  Table table(header);
  const auto sets = meshed_sets(results, "edges_agree");
  for (const std::string& set : sets) {
    std::vector<std::string> cells{set};
    for (const auto& [id, title] : methods) {
      std::string text = "-";
      for (const Row* row : meshes_of(results, id, "data")) {
        if (row->name.shape != set) continue;
        const auto right = row->mesh.find("topology_right");
        text =
            fmt::format("{} {}, {}", right != row->mesh.end() && right->second == 1 ? "**right**" : "wrong",
                        cell(*row, "edges_agree_flipped"), cell(*row, "boundary_points_f1"));
      }
      cells.push_back(text);
    }
    table.add(std::move(cells));
  }
  return table.markdown();
}

std::string verdict_table(const Results& results) {
  const Rows all = choose(results.rows, [](const Row& row) { return row.name.group == "topology"; });
  std::set<std::string> shapes;
  for (const Row* row : all) shapes.insert(row->name.shape);
  Table table({"surface", "runs", "meshed", "Euler number and loops right"});
  for (const std::string& shape : shapes) {
    const Rows rows = choose(all, [&](const Row& row) { return row.name.shape == shape; });
    table.add({shape, std::to_string(rows.size()), percent_of(rows, &Row::mesh, "accepted"),
               percent_of(rows, &Row::mesh, "verdict_right")});
  }
  if (table.empty()) return {};
  return fmt::format("\nSurfaces that are no disc, 5,000 points:\n\n{}", table.markdown());
}

}  // namespace

std::string mesh_section(const Results& results) {
  if (mesh_methods(results).empty()) return "";
  std::string text =
      "\n## Meshes\n\nSound on so many of the analytic shapes (all seeds), 10,000 points:\n\n" +
      sound_table(results) + unsound_table(results);
  if (!meshed_sets(results, "edges_agree").empty()) {
    text +=
        "\nThe data sets with a truth mesh: topology, edges that agree with the flipped truth, F1 of the "
        "points of the rim:\n\n" +
        compared_sets(results);
  }
  return text + "\nThe default, in full:\n\n" + default_table(results) + verdict_table(results);
}

}  // namespace rimline::bench
