// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates in steps: rounded along an axis, or along the rays of a depth camera.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/model.h"
#include "base/model_clean.h"
#include "base/parallel.h"
#include "base/quantile.h"
#include "base/vec.h"
#include "local/frame.h"
#include "rimline/clean.h"

namespace rimline {
namespace {

constexpr std::size_t most_measured = 4096;  // [speed]

double value_of(Point p, const Terraces& terraces) {
  if (terraces.centre) return distance(p, *terraces.centre);
  return std::array{p.x, p.y, p.z}[static_cast<std::size_t>(terraces.axis)];
}

Point direction_at(Point p, const Terraces& terraces) {
  if (terraces.centre) return unit(p - *terraces.centre);
  return {terraces.axis == 0 ? 1.0 : 0.0, terraces.axis == 1 ? 1.0 : 0.0, terraces.axis == 2 ? 1.0 : 0.0};
}

// How many steps each level lies above the first. A step is as long as most around it.
std::vector<double> count_steps(const std::vector<double>& at) {
  constexpr std::size_t around = 2;  // gaps on either side [layout]
  std::vector<double> index{0};
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    std::vector<double> gaps;
    for (std::size_t j = i - std::min(i, around); j <= i + around && j + 1 < at.size(); ++j)
      gaps.push_back(at[j + 1] - at[j]);
    index.push_back(index.back() + std::max(1.0, std::round((at[i + 1] - at[i]) / median(gaps))));
  }
  return index;
}

// The line through the two of `from`, ascending, that are nearest around x and their values `to`, at x.
double interpolate(const std::vector<double>& from, const std::vector<double>& to, double x) {
  const auto above = std::ranges::lower_bound(from, x);
  const auto i = std::clamp<std::ptrdiff_t>(above - from.begin(), 1, std::ssize(from) - 1);
  return to[i - 1] + (to[i] - to[i - 1]) * (x - from[i - 1]) / (from[i] - from[i - 1]);
}

// The level of a value, in steps; between levels, and beyond them, there are broken numbers.
double level_of(double value, const Levels& levels) { return interpolate(levels.at, levels.index, value); }

double value_at(double level, const Levels& levels) { return interpolate(levels.index, levels.at, level); }

// Whether most points have most of their neighbours on their own level.
bool are_terraces(Points points, const Neighbours& neighbours, const Terraces& terraces) {
  const std::size_t stride = points.size() / most_measured + 1;
  const int count = std::min(model::few_neighbours, neighbours.k);
  std::size_t asked = 0, on_terrace = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const auto level = [&](Index j) {
      return std::round(level_of(value_of(points[j], terraces), terraces.levels));
    };
    const auto alike = std::ranges::count_if(neighbours.of(static_cast<Index>(i), count), [&](Index j) {
      return level(j) == level(static_cast<Index>(i));
    });
    on_terrace += 2 * alike > count;
    ++asked;
  }
  return 2 * on_terrace > asked;
}

std::optional<Levels> levels_of(std::vector<double> values, double spacing) {
  const double apart = model::step_least * spacing;
  constexpr std::size_t least = 3;  // points of a level [layout]
  std::ranges::sort(values);
  Levels levels;
  std::size_t on_level = 0, wide = 0;
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
    for (end = begin + 1; end < values.size() && values[end] - values[end - 1] <= apart;) ++end;
    if (values[end - 1] - values[begin] > apart) wide += end - begin;
    if (end - begin < least) continue;
    levels.at.push_back(values[begin + (end - begin) / 2]);
    on_level += end - begin;
  }
  const auto share = static_cast<double>(values.size());
  if (levels.at.size() < 2 || static_cast<double>(wide) > (1 - model::step_share) * share) return {};
  if (static_cast<double>(on_level) < model::step_share * share) return {};
  if (static_cast<double>(levels.at.size()) * model::step_points > share) return {};
  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < levels.at.size(); ++i) gaps.push_back(levels.at[i + 1] - levels.at[i]);
  levels.index = count_steps(levels.at);
  levels.quantum = median(gaps);
  return levels;
}

// The levels of value(point) over all points.
template <class Value>
std::optional<Levels> levels_along(Points points, double spacing, const Value& value) {
  const auto of_every = [&](std::size_t stride) {
    std::vector<double> values;
    values.reserve(points.size() / stride + 1);
    for (std::size_t i = 0; i < points.size(); i += stride) values.push_back(value(points[i]));
    return levels_of(std::move(values), spacing);
  };
  // Nearly always a part tells that there are none.
  if (points.size() > 2 * most_measured && !of_every(points.size() / most_measured)) return {};
  return of_every(1);
}

std::optional<Terraces> terraces_along(Points points, const Neighbours& neighbours, double spacing,
                                       Terraces terraces) {
  auto levels = levels_along(points, spacing, [&](Point p) { return value_of(p, terraces); });
  if (!levels || levels->at.size() < model::terrace_levels) return {};
  const double step = levels->quantum / spacing;
  if (step < model::terrace_least || step > model::terrace_longest) return {};
  terraces.levels = *std::move(levels);
  if (!are_terraces(points, neighbours, terraces)) return {};
  return terraces;
}

// Takes the mean of the neighbours that are near in steps, again and again, never farther than a step from
// where it was. `moves`: points (1) that may.
std::vector<double> smooth(std::vector<double> level, const Neighbours& neighbours,
                           const std::vector<char>& moves, const Run& run) {
  const std::vector<double> given = level;
  for (int round = 0; round < model::terrace_rounds; ++round) {
    std::vector<double> next = level;
    parallel_for_each(level.size(), Stage::Neighbours, run.without_progress(), [&](Index i) {
      if (!moves[i]) return;
      double sum = level[i];
      int count = 1;
      for (const Index j : neighbours.of(i)) {
        if (std::abs(given[i] - given[j]) > model::terrace_near) continue;
        sum += level[j];
        ++count;
      }
      next[i] = std::clamp(sum / count, given[i] - model::terrace_most, given[i] + model::terrace_most);
    });
    level = std::move(next);
  }
  return level;
}

}  // namespace

std::optional<Levels> find_levels(Points points, double Point::*axis, double spacing) {
  return levels_along(points, spacing, [&](Point p) { return p.*axis; });
}

std::optional<Terraces> find_terraces(Points points, const Neighbours& neighbours,
                                      const std::vector<double>& spacing, const std::vector<Point>& centres,
                                      const Run& run) {
  run.check_cancel();
  if (points.size() < model::stray_fewest_points) return {};
  const double usual = median(spacing);
  for (const int axis : {2, 0, 1}) {
    if (auto found = terraces_along(points, neighbours, usual, {{}, axis, {}})) return found;
  }
  for (const Point centre : centres) {
    if (auto found = terraces_along(points, neighbours, usual, {centre, 2, {}})) return found;
  }
  return {};
}

std::vector<Point> without_terraces(Points points, const Terraces& terraces,
                                    const std::vector<double>& spacing, const Run& run) {
  const double step = model::terrace_squeezed * median(spacing);
  std::vector<double> level(points.size());
  std::vector<Point> squeezed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = value_of(points[i], terraces);
    level[i] = level_of(value, terraces.levels);
    squeezed[i] = points[i] + (step * level[i] - value) * direction_at(points[i], terraces);
  }
  const Neighbours neighbours = find_neighbours(squeezed, model::more_neighbours, run);
  if (median(local_spacing(squeezed, neighbours, run)) < model::terrace_beside * median(spacing)) return {};
  const std::vector<Frame> frames = fit_frames(squeezed, neighbours, run);
  std::vector<char> moves(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    moves[i] = std::abs(dot(frames[i].normal, direction_at(points[i], terraces))) > model::terrace_across;
  if (2 * std::ranges::count(moves, 1) < std::ssize(moves)) return {};
  const std::vector<double> smoothed = smooth(level, neighbours, moves, run);
  std::vector<Point> moved(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double by = value_at(smoothed[i], terraces.levels) - value_of(points[i], terraces);
    if (moves[i]) moved[i] = points[i] + by * direction_at(points[i], terraces);
  }
  return moved;
}

}  // namespace rimline
