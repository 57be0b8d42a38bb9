// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/case.h"

#include <fmt/format.h>

namespace rimline::bench {

std::string CaseName::text() const {
  if (group == "data") return "data/" + shape;
  if (group == "corpus") return "corpus/" + sampling + "/" + shape;
  return fmt::format("{}/{}/{}/n{}/noise{}/{}", group, shape, sampling, n, noise, draw);
}

void measure_spacing(Case& c) {
  constexpr int neighbours = 12;
  Run run;
  run.threads = 1;
  c.neighbours = find_neighbours(c.points, neighbours, run);
  c.spacing = local_spacing(c.points, c.neighbours);
}

}  // namespace rimline::bench
