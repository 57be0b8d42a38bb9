// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/write_outcome.h"

#include "rimline/io.h"

namespace rimline::bench {
namespace {

Cloud cloud_with_uv(const Case& c, const std::vector<UV>& uv) {
  Cloud cloud;
  cloud.points = c.points;
  if (uv.empty()) return cloud;
  std::vector<double> u, v;
  for (const UV& p : uv) {
    u.push_back(p.u);
    v.push_back(p.v);
  }
  cloud.columns = {make_column("u", u), make_column("v", v)};
  return cloud;
}

}  // namespace

void write_outcome(const std::string& folder, const Case& c, const std::string& method,
                   const Outcome& outcome) {
  const std::string stem = folder + "/" + c.name.shape + "." + method;
  if (outcome.has_loops) {
    std::vector<Loop> loops;
    for (const auto& ids : outcome.loops) loops.push_back({ids, LoopKind::Outer, 0, 0});
    write_text(stem + ".loops.json", loops_to_json(loops, c.points.size()));
  }
  if (!outcome.mesh.empty()) {
    write_mesh(stem + ".mesh.ply", cloud_with_uv(c, outcome.uv), outcome.mesh, {});
  }
}

}  // namespace rimline::bench
