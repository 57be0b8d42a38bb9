// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "rimline/arrange.h"
#include "rimline/clean.h"
#include "rimline/io.h"
#include "rimline/neighbours.h"
#include "session.h"
#include "subcommands.h"
#include "summary.h"

namespace rimline::cli {
namespace {

struct InfoArguments {
  Common common;
  Input input;
};

std::string line(const char* label, const std::string& text) {
  return fmt::format("{:<12} {}\n", label, text);
}

// The box and the extent of the points.
std::string box_lines(Points points, const std::string& unit) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Point low = {infinite, infinite, infinite}, high = {-infinite, -infinite, -infinite};
  for (const Point p : points) {
    if (!is_finite(p)) continue;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Point extent = high - low;
  return line("unit", unit.empty() ? "not told by the file" : unit) +
         line("x", fmt::format("{} to {}", low.x, high.x)) +
         line("y", fmt::format("{} to {}", low.y, high.y)) +
         line("z", fmt::format("{} to {}", low.z, high.z)) +
         line("extent", fmt::format("{:.6g} x {:.6g} x {:.6g}", extent.x, extent.y, extent.z));
}

std::string property_lines(const Cloud& cloud) {
  std::string text = line("coordinates", name(cloud.coordinate_type));
  if (!cloud.coordinates.empty()) text += line("x, y, z from", cloud.coordinates);
  std::string list;
  for (const Column& column : cloud.columns) {
    list += (list.empty() ? "" : ", ") + fmt::format("{} {}", name(column.type), column.name);
  }
  return text + line("properties", list.empty() ? "none" : list);
}

// Of the largest coordinate: where that is far from 0, squares of lengths do not fit a double.
int exponent_of(const std::vector<Point>& points) {
  double most = 0;
  for (const Point p : points) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most > 0 ? std::ilogb(most) : 0;
}

// The steps that coordinates are in; empty where they are in none.
std::string steps_line(const std::vector<Point>& points, double spacing, int exponent) {
  std::string found;
  const std::array<std::pair<const char*, double Point::*>, 3> axes{
      {{"x", &Point::x}, {"y", &Point::y}, {"z", &Point::z}}};
  for (const auto& [name, axis] : axes) {
    if (const auto levels = find_levels(points, axis, spacing))
      found +=
          fmt::format("{}{} {:.6g}", found.empty() ? "" : ", ", name, std::ldexp(levels->quantum, exponent));
  }
  return found.empty() ? "" : line("steps", found + " (rounding, or a grid)");
}

std::string spacing_line(Arrangement distinct, const Run& run) {
  constexpr int six = 6;  // neighbours that local_spacing() averages over
  const int exponent = exponent_of(distinct.points);
  for (Point& p : distinct.points)
    p = {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
  const auto neighbours = find_neighbours(distinct.points, six, run);
  auto spacing = local_spacing(distinct.points, neighbours);
  std::sort(spacing.begin(), spacing.end());
  const std::string steps = steps_line(distinct.points, spacing[spacing.size() / 2], exponent);
  const auto at = [&](double share) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(spacing.size() - 1));
    return std::ldexp(spacing[place], exponent);
  };
  return line("spacing",
              fmt::format("median {:.6g}, 5 % below {:.6g}, 5 % above {:.6g} (mean distance to the "
                          "{} nearest)",
                          at(0.5), at(0.05), at(0.95), std::min(six, neighbours.k))) +
         steps;
}

void run_info(const InfoArguments& arguments) {
  Session session(arguments.common);
  const Cloud cloud = read_cloud(arguments.input.path, arguments.input.filter, session.run());
  std::string text = line("file", arguments.input.path == "-" ? "standard input" : arguments.input.path);
  text += line("format", cloud.format);
  text += line("points", with_commas(static_cast<long long>(cloud.points.size())));
  text += property_lines(cloud);
  const bool any_finite = std::any_of(cloud.points.begin(), cloud.points.end(), is_finite);
  if (any_finite) {
    Arrangement distinct = arrange(cloud.points, session.run());
    text += box_lines(cloud.points, cloud.unit);
    text += line("not finite", with_commas(static_cast<long long>(distinct.not_finite.size())));
    text += line("duplicates", with_commas(static_cast<long long>(distinct.duplicates.size())));
    if (distinct.points.size() > 1) text += spacing_line(std::move(distinct), session.run());
  } else {
    text += line("not finite", with_commas(static_cast<long long>(cloud.points.size())));
  }
  for (const std::string& warning : cloud.warnings) text += line("warning", warning);
  session.bar().erase();
  fmt::print("{}", text);
}

}  // namespace

void add_info(CLI::App& tool) {
  auto arguments = std::make_shared<InfoArguments>();
  CLI::App& command = add_subcommand(
      tool, "info",
      "Tell what a file of points holds: format, columns taken for x, y and z, unit, extent, counts, "
      "properties, points that can not be used, spacing.",
      "rimline info scan.ply");
  add_input(command, arguments->input);
  add_common(command, arguments->common);
  command.callback([arguments] { run_info(*arguments); });
}

}  // namespace rimline::cli
