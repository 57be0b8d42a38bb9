// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "quality/analytic.h"
#include "quality/hard_clouds.h"
#include "quality/ply_faces.h"
#include "rimline/io.h"

namespace rimline::bench {
namespace {

namespace fs = std::filesystem;

bool is_point_set(const std::string& name) {
  return name.ends_with(".xyz") || name.ends_with(".pcd") ||
         (name.ends_with(".ply") && !name.ends_with(".truth.ply") && !name.ends_with(".flipped.ply"));
}

Topology topology_of_shape(const std::string& shape) {
  if (shape == name(Shape::ClosedSphere)) return {2, 1, 0};
  if (shape == name(Shape::TorusMinusCap)) return {-1, 1, 1};
  return {0, 1, 1};  // the Moebius strip
}

Asked ask_for_file(const std::string& path) {
  Asked asked;
  asked.points.points = read_cloud(path, {}).points;
  const fs::path truth = fs::path(path).replace_extension(".truth.ply");
  if (fs::exists(truth)) asked.truth = topology_of(read_ply_faces(truth.string()));
  return asked;
}

}  // namespace

std::vector<Question> questions_of_files(const std::string& folders) {
  std::vector<Question> questions;
  std::istringstream names(folders);
  for (std::string folder; std::getline(names, folder, ':');) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (is_point_set(name))
        questions.push_back({fs::path(folder).filename().string(), name, entry.path().string(), 0, 0, {}});
    }
  }
  std::ranges::sort(questions, {}, &Question::path);
  return questions;
}

std::vector<Question> questions_of_clouds(std::uint64_t seed, std::size_t count) {
  std::vector<Question> questions;
  const std::string group = fmt::format("hard clouds, seed {}", seed);
  for (std::uint64_t i = 0; i < count; ++i)
    questions.push_back({group, fmt::format("cloud {}", i), "", seed, i, {}});
  return questions;
}

std::vector<Question> questions_of_shapes(std::uint64_t seed, int draws) {
  std::vector<Question> questions;
  AnalyticPlan plan;
  plan.seed = seed;
  plan.draws = draws;
  for (const double noise : {0.0, 0.2, 0.5}) {
    plan.noises = {noise};
    for (const CaseName& sample : closed_cases(plan))
      questions.push_back(
          {fmt::format("closed, handled, one-sided, noise {}", noise), sample.text(), "", 0, 0, sample});
  }
  return questions;
}

Asked ask_for(const Question& question) {
  if (!question.path.empty()) return ask_for_file(question.path);
  Asked asked;
  if (question.sample.n > 0) {
    asked.points = make_analytic(question.sample).value();
    asked.truth = topology_of_shape(question.sample.shape);
    return asked;
  }
  HardCloud cloud = hard_cloud(question.seed, question.number);
  asked.has_surface = cloud.has_surface;
  asked.points.points = std::move(cloud.points);
  return asked;
}

}  // namespace rimline::bench
