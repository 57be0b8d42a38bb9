// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.h"

#include <fmt/format.h>

namespace rimline::cli {
namespace {

constexpr std::size_t most_loops_listed = 12;

std::string line(const char* label, const std::string& text) {
  return fmt::format("{:<10} {}\n", label, text);
}

std::string points_line(const PointCounts& points) {
  std::string text = fmt::format("{} used of {}", with_commas(points.used), with_commas(points.input));
  if (points.not_finite > 0) text += fmt::format(", {} not finite", with_commas(points.not_finite));
  if (points.duplicates > 0) text += fmt::format(", {} duplicates", with_commas(points.duplicates));
  if (points.stray > 0) text += fmt::format(", {} stray", with_commas(points.stray));
  if (points.unmeshed > 0) text += fmt::format(", {} in no triangle", with_commas(points.unmeshed));
  return line("points", text);
}

std::string loop_lines(const std::vector<Loop>& loops, bool is_closed) {
  if (loops.empty()) return line("loops", is_closed ? "none: the surface is closed" : "none");
  std::string text;
  for (std::size_t i = 0; i < loops.size() && i < most_loops_listed; ++i) {
    text +=
        line(i == 0 ? "loops" : "", fmt::format("{}: {}, {} points, length {:.6g}", i, name(loops[i].kind),
                                                with_commas(loops[i].points.size()), loops[i].length));
  }
  if (loops.size() > most_loops_listed) {
    text += line("", fmt::format("and {} more", loops.size() - most_loops_listed));
  }
  return text;
}

// Results of Algorithms 3.1 and 3.2; empty where they did not run.
std::string search_line(const SearchSummary& search) {
  if (search.starts == 0) return "";
  return line("search",
              fmt::format("{} distinct paths from {} starts; {}, {} points, e(C) {:.4g}",
                          with_commas(static_cast<long long>(search.distinct_paths)),
                          with_commas(static_cast<long long>(search.starts)), name(search.loop_from),
                          with_commas(static_cast<long long>(search.winner_points)), search.winner_fitness));
}

// "7 edges", "more than 100,000 self-intersections"; "" for none.
std::string counted(std::size_t count, const char* one, const char* many, bool more = false) {
  if (count == 0) return "";
  return fmt::format(", {}{} {}", more ? "more than " : "", with_commas(count), count == 1 ? one : many);
}

std::string mesh_lines(const Report& report) {
  const MeshSummary& mesh = report.mesh;
  std::string text = fmt::format("{} triangles on {} points, Euler number {}, {} boundary {}",
                                 with_commas(mesh.triangles), with_commas(mesh.points_used), mesh.euler,
                                 mesh.boundary_loops, mesh.boundary_loops == 1 ? "loop" : "loops");
  text += counted(mesh.nonmanifold_edges, "non-manifold edge", "non-manifold edges");
  text += counted(mesh.nonmanifold_vertices, "non-manifold vertex", "non-manifold vertices");
  text += counted(mesh.uv_flips, "triangle turned over in the map", "triangles turned over in the map");
  text += counted(mesh.long_edges, "edge longer than 3 spacings", "edges longer than 3 spacings");
  text += counted(report.self_intersections, "self-intersection", "self-intersections",
                  report.more_self_intersections);
  return line("mesh", text);
}

std::string map_line(const Report& report) {
  std::size_t mapped = 0;
  for (const ComponentSummary& component : report.components) mapped += has_map(component.map);
  if (!report.components.empty() && mapped == 0) return line("map", "none");
  std::string text =
      fmt::format("{} unknowns, residual {:.1e}", with_commas(report.map.unknowns), report.map.residual);
  std::size_t charts = 0;
  double seams = 0;
  for (const ComponentSummary& component : report.components)
    charts += component.charts, seams += component.seams;
  if (charts > 1) text += fmt::format(", {} charts", with_commas(charts));
  if (seams > 0) text += fmt::format(", seams {:.4g} long", seams);
  if (mapped < report.components.size())
    text += fmt::format(", of {} of {} components", mapped, report.components.size());
  return line("map", text);
}

std::string holes_line(const HoleSummary& holes) {
  std::size_t triangles = 0, added = 0;
  for (const FilledHole& hole : holes.filled) {
    triangles += hole.triangles;
    added += hole.added_points;
  }
  std::string text = fmt::format("{} filled by {} triangles", holes.filled.size(), with_commas(triangles));
  if (added > 0) text += fmt::format(" and {} vertices of their own", with_commas(added));
  return line("holes", text + fmt::format(", {} kept", holes.kept));
}

std::string reference_line(const ReferenceSummary& reference) {
  std::string text =
      fmt::format("Hausdorff distance {:.4g}, mean {:.4g} from the mesh and {:.4g} to it",
                  reference.hausdorff, reference.to_reference.mean, reference.from_reference.mean);
  if (reference.edges_agree) text += fmt::format(", edges agree {:.4f}", *reference.edges_agree);
  return line("reference", text);
}

std::string distortion_line(const DistortionSummary& d) {
  return line("distortion", fmt::format("{:.4f} rad a corner on average, stretch {:.3f} (L2), {:.3g} at most",
                                        d.angle_mean, d.stretch_l2, d.stretch_linf));
}

// Suspect and failed components are in the warnings.
std::string component_lines(const std::vector<ComponentSummary>& components) {
  std::size_t meshed = 0;
  for (const ComponentSummary& component : components) meshed += component.failure.empty();
  if (components.size() == 1 && meshed == 1) return "";
  return line("components", fmt::format("{}, {} meshed", components.size(), meshed));
}

std::string left_out_line(const std::vector<LeftOut>& parts) {
  if (parts.empty()) return "";
  const LeftOut& most = parts.front();
  return line("left out",
              fmt::format("{} {}; the largest of {} points near {:.6g} {:.6g} {:.6g}: {}", parts.size(),
                          parts.size() == 1 ? "group" : "groups", with_commas(most.ids.size()), most.low.x,
                          most.low.y, most.low.z, most.cause));
}

}  // namespace

std::string with_commas(long long number) {
  std::string digits = std::to_string(number);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > (number < 0 ? 1 : 0); i -= 3) {
    digits.insert(static_cast<std::size_t>(i), 1, ',');
  }
  return digits;
}

std::string summary(const Report& report, const std::string& files, double seconds) {
  std::string text = points_line(report.points);
  text += line("spacing", fmt::format("{:.4g} on average, {:.4g} to {:.4g}", report.spacing.mean,
                                      report.spacing.least, report.spacing.most));
  if (report.steps.removed > 0) {
    text += line("steps", fmt::format("terraces of {:.4g} along {}, smoothed to find the surface",
                                      report.steps.removed, report.steps.removed_along));
  }
  text += line("candidates", with_commas(report.candidates));
  text += search_line(report.search);
  text += loop_lines(report.loops, report.closed);
  if (report.has_map) text += map_line(report);
  if (report.has_mesh) {
    text += mesh_lines(report);
    text += distortion_line(report.distortion);
  }
  if (report.holes && !report.holes->filled.empty()) text += holes_line(*report.holes);
  if (report.reference) text += reference_line(*report.reference);
  if (!report.components.empty()) text += component_lines(report.components);
  text += left_out_line(report.left_out);
  for (const std::string& warning : report.warnings) text += line("warning", warning);
  if (!files.empty()) text += line("wrote", files);
  return text + line("seconds", fmt::format("{:.2f}", seconds));
}

}  // namespace rimline::cli
