// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops.h"

#include <fmt/format.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <string>

#include "arrays.h"
#include "names.h"
#include "parts.h"
#include "rimline/io.h"

namespace rimline::python {
namespace {

void check_loop(const std::vector<Index>& ids, std::size_t point_count, std::size_t number) {
  check_ids(ids, point_count, "a loop");
  if (ids.size() < 3) {
    throw Error(ErrorCode::BadOption, fmt::format("loop {} has fewer than three points", number));
  }
  std::vector<Index> sorted = ids;
  std::ranges::sort(sorted);
  const auto twice = std::ranges::adjacent_find(sorted);
  if (twice == sorted.end()) return;
  throw Error(ErrorCode::BadOption,
              fmt::format("loop {} has the id {} twice; split it there", number, *twice), {*twice});
}

std::string loops_json(const Items& loops, std::size_t point_count) {
  return loops_to_json(loops_from_python(loops, point_count), point_count);
}

Items read_loops_file(const std::string& path, std::size_t point_count) {
  return loops_to_python(read_loops(path, point_count));
}

}  // namespace

void check_ids(std::span<const Index> ids, std::size_t point_count, const char* what) {
  for (const Index id : ids) {
    if (id >= 0 && static_cast<std::size_t>(id) < point_count) continue;
    throw Error(ErrorCode::BadOption,
                fmt::format("{} has the id {}; ids are integers from 0 to {}", what, id,
                            static_cast<long long>(point_count) - 1),
                {id});
  }
}

Items loops_to_python(std::vector<Loop> loops) {
  const nb::object type = nb::module_::import_("rimline._loops").attr("Loop");
  Items made;
  for (Loop& loop : loops) {
    made.append(type(give(std::move(loop.points)), name(loop.kind), loop.length, loop.fitness, loop.component,
                     loop.probability));
  }
  return made;
}

std::vector<Loop> loops_from_python(const Items& loops, std::size_t point_count) {
  std::vector<Loop> made;
  for (const nb::handle given : loops) {
    const auto ids = nb::cast<List<Index>>(given.attr("points"));
    Loop loop{.points = {ids.data(), ids.data() + ids.shape(0)}};
    loop.kind = value_of<LoopKind>("kind", nb::cast<std::string>(given.attr("kind")));
    loop.length = nb::cast<double>(given.attr("length"));
    loop.fitness = nb::cast<double>(given.attr("fitness"));
    loop.component = nb::cast<Index>(given.attr("component"));
    loop.probability = nb::cast<double>(given.attr("probability"));
    if (loop.points.size() > 1 && loop.points.front() == loop.points.back()) loop.points.pop_back();
    check_loop(loop.points, point_count, made.size());
    made.push_back(std::move(loop));
  }
  return made;
}

void add_loops(nb::module_& m) {
  m.def("loops_to_json", &loops_json, nb::arg("loops"), nb::arg("point_count"));
  m.def("read_loops", &read_loops_file, nb::arg("path"), nb::arg("point_count"));
}

}  // namespace rimline::python
