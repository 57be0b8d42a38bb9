// SPDX-License-Identifier: GPL-3.0-or-later
// Selects points by class and return, properties of airborne scans.
#include <algorithm>
#include <cctype>
#include <set>

#include "rimline/io.h"

namespace rimline {
namespace {

// "ReturnNumber" and "return_number" are one name.
std::string plain(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c != '_' && c != ' ') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

const Column& column_for(const Cloud& cloud, std::string_view wanted, const std::string& file) {
  const auto found = std::ranges::find_if(
      cloud.columns, [&](const Column& column) { return plain(column.name) == plain(wanted); });
  if (found != cloud.columns.end()) return *found;
  throw Error(ErrorCode::CannotRead, file + ": has no " + std::string(wanted) +
                                         " to choose points by; read all points, or a file that has it");
}

std::string listed(const std::set<int>& numbers) {
  constexpr std::size_t most = 20;
  std::string text;
  std::size_t count = 0;
  for (const int number : numbers) {
    if (count++ == most) return text + ", ...";
    text += (text.empty() ? "" : ", ") + std::to_string(number);
  }
  return text;
}

// Clears the marks of the points of other classes.
void choose_classes(const Cloud& cloud, const std::vector<int>& classes, const std::string& file,
                    std::vector<char>& chosen) {
  const Column& column = column_for(cloud, "classification", file);
  std::set<int> present;
  bool any = false;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const double value = column.value(static_cast<Index>(i));
    if (value >= 0 && value <= 255) present.insert(static_cast<int>(value));
    const bool wanted = std::ranges::find(classes, value) != classes.end();
    any = any || wanted;
    chosen[i] = chosen[i] != 0 && wanted;
  }
  if (any) return;
  throw Error(ErrorCode::CannotRead, file + ": has no point of class " +
                                         listed(std::set<int>(classes.begin(), classes.end())) +
                                         "; its classes are " + listed(present));
}

void choose_returns(const Cloud& cloud, Returns returns, const std::string& file, std::vector<char>& chosen) {
  const Column& number = column_for(cloud, "return_number", file);
  const Column& count = column_for(cloud, "number_of_returns", file);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const double n = number.value(static_cast<Index>(i)), all = count.value(static_cast<Index>(i));
    const bool wanted = returns == Returns::First ? n <= 1 : returns == Returns::Last ? n >= all : all <= 1;
    chosen[i] = chosen[i] != 0 && wanted;
  }
}

void keep(Cloud& cloud, const std::vector<char>& chosen) {
  std::vector<std::uint32_t> ids;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i] != 0) ids.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t i = 0; i < ids.size(); ++i) cloud.points[i] = cloud.points[ids[i]];
  cloud.points.resize(ids.size());
  for (Column& column : cloud.columns) {
    const std::size_t size = size_in_bytes(column.type);
    for (std::size_t i = 0; i < ids.size(); ++i)
      std::copy_n(column.bytes.begin() + static_cast<std::ptrdiff_t>(ids[i] * size), size,
                  column.bytes.begin() + static_cast<std::ptrdiff_t>(i * size));
    column.bytes.resize(ids.size() * size);
  }
  set_column(cloud, make_column("file_index", ids));
}

}  // namespace

const char* name(Returns returns) {
  switch (returns) {
    case Returns::All: return "all";
    case Returns::First: return "first";
    case Returns::Last: return "last";
    case Returns::Only: return "only";
  }
  return "?";
}

void filter_points(Cloud& cloud, const PointFilter& filter, const std::string& file) {
  const std::size_t all = cloud.points.size();
  std::vector<char> chosen(all, 1);
  if (!filter.classes.empty()) choose_classes(cloud, filter.classes, file, chosen);
  if (filter.returns != Returns::All) choose_returns(cloud, filter.returns, file, chosen);
  const auto count = static_cast<std::size_t>(std::ranges::count(chosen, 1));
  if (count == all) return;
  if (count == 0) {
    throw Error(ErrorCode::CannotRead,
                file + ": no point is of that class and return; choose others, or take all points");
  }
  keep(cloud, chosen);
  cloud.warnings.push_back(file + ": " + std::to_string(count) + " of " + std::to_string(all) +
                           " points were chosen by class and return");
}

Cloud read_cloud(const std::string& path, const PointFilter& filter, const Run& run) {
  Cloud cloud = read_cloud(path, run);
  filter_points(cloud, filter, path == "-" ? "standard input" : path);
  return cloud;
}

}  // namespace rimline
