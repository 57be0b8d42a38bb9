// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/report.h"

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "rimline/version.h"

namespace rimline {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: the stretch of a triangle without area in the map is null.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class Struct>
bool holds(const Struct& options, const void* field) {
  return std::less_equal<>{}(static_cast<const void*>(&options), field) &&
         std::less<>{}(field, static_cast<const void*>(&options + 1));
}

// Those that counted.
Json options_json(const Report& report) {
  const Options& options = report.options;
  Json json;
  json["preset"] = name(options.preset);
  visit_fields(options, [&]<class T>(const Field<T>& field) {
    const bool of_map = holds(options.map, &field.value) || holds(options.mesh, &field.value);
    const bool of_search = field.used_by == UsedBy::Paper && holds(options.loops, &field.value) &&
                           std::string_view(field.name) != "score_form";
    if (!counts(field.used_by, options) || (of_map && !report.has_map)) return;
    if (of_search && report.search.starts == 0) return;  // the loops were given, so that there was no search
    if constexpr (std::is_arithmetic_v<T>) {
      const bool has_word = field.zero[0] != 0 && field.value == T{};
      json[field.name] = has_word ? Json(field.zero) : Json(field.value);
    } else {
      json[field.name] = name(field.value);
    }
  });
  if (!report.has_map) return json;
  if (counts(UsedBy::Default, options)) json["holes"] = name(options.mesh.holes);
  if (options.map.corners[0] != none) json["corners"] = options.map.corners;
  json["up"] = {options.mesh.up.x, options.mesh.up.y, options.mesh.up.z};
  return json;
}

Json loops_json(const std::vector<Loop>& loops) {
  Json json = Json::array();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    json.push_back({{"id", i},
                    {"kind", name(loops[i].kind)},
                    {"points", loops[i].points.size()},
                    {"length", loops[i].length},
                    {"fitness", finite(loops[i].fitness)},
                    {"component", loops[i].component},
                    {"probability", finite(loops[i].probability)}});
  }
  return json;
}

Json doubtful_json(const std::vector<DoubtfulGap>& gaps) {
  Json json = Json::array();
  for (const DoubtfulGap& gap : gaps) {
    json.push_back({{"points", gap.points},
                    {"length", gap.length},
                    {"probability", gap.probability},
                    {"place", {gap.place.x, gap.place.y, gap.place.z}}});
  }
  return json;
}

Json search_json(const Options& options, const SearchSummary& search) {
  Json best = Json::array(), mean = Json::array();
  for (const Generation& g : search.history) {
    best.push_back(g.best);
    mean.push_back(g.mean);
  }
  if (counts(UsedBy::Default, options)) {
    return {{"doubtful_triangles", search.doubtful},
            {"groups", search.groups},
            {"greedy_fitness", search.greedy_fitness},
            {"best_fitness", best},
            {"mean_fitness", mean}};
  }
  return {{"starts", search.starts},
          {"closed_paths", search.closed_paths},
          {"distinct_paths", search.distinct_paths},
          {"population", search.population},
          {"steps", search.steps},
          {"bound_hit", search.bound_hit},
          {"loop_from", name(search.loop_from)},
          {"winner_points", search.winner_points},
          {"winner_fitness", search.winner_fitness},
          {"winner_rank", search.winner_rank},
          {"best_fitness", best},
          {"mean_fitness", mean}};
}

Json mesh_json(const MeshSummary& mesh) {
  return {{"triangles", mesh.triangles},
          {"points_used", mesh.points_used},
          {"edges", mesh.edges},
          {"euler_number", mesh.euler},
          {"components", mesh.components},
          {"boundary_loops", mesh.boundary_loops},
          {"boundary_edges", mesh.boundary_edges},
          {"nonmanifold_edges", mesh.nonmanifold_edges},
          {"nonmanifold_vertices", mesh.nonmanifold_vertices},
          {"min_angle_histogram_5_degrees", mesh.min_angle_histogram},
          {"edges_longer_than_3_spacings", mesh.long_edges},
          {"area", mesh.area},
          {"uv_flips", mesh.uv_flips},
          {"mean_angle_distortion", mesh.mean_angle_distortion}};
}

Json distortion_json(const DistortionSummary& d) {
  return {{"angle_mean", finite(d.angle_mean)},       {"angle_most", finite(d.angle_most)},
          {"area_least", finite(d.area_least)},       {"area_most", finite(d.area_most)},
          {"area_mean_log", finite(d.area_mean_log)}, {"stretch_l2", finite(d.stretch_l2)},
          {"stretch_linf", finite(d.stretch_linf)}};
}

Json holes_json(const Options& options, const HoleSummary& holes) {
  Json filled = Json::array();
  for (const FilledHole& hole : holes.filled) {
    filled.push_back({{"points", hole.points},
                      {"length", hole.length},
                      {"triangles", hole.triangles},
                      {"added_points", hole.added_points}});
  }
  std::size_t triangles = 0, added = 0;
  for (const FilledHole& hole : holes.filled) {
    triangles += hole.triangles;
    added += hole.added_points;
  }
  return {{"policy", name(options.mesh.holes)},
          {"found", holes.found},
          {"kept", holes.kept},
          {"filled", holes.filled.size()},
          {"failed", holes.failed},
          {"fill_triangles", triangles},
          {"added_points", added},
          {"fills", filled}};
}

Json distance_json(const DistanceSummary& d) { return {{"mean", d.mean}, {"rms", d.rms}, {"most", d.most}}; }

Json reference_json(const ReferenceSummary& reference) {
  Json json = {{"name", reference.name},
               {"points", reference.points},
               {"triangles", reference.triangles},
               {"area", reference.area},
               {"hausdorff", reference.hausdorff},
               {"mesh_to_reference", distance_json(reference.to_reference)},
               {"reference_to_mesh", distance_json(reference.from_reference)}};
  if (reference.edges_agree) {
    json["edges_agree"] = *reference.edges_agree;
  } else {
    json["edges_agree"] = "not measured: the vertices are not the same";
  }
  return json;
}

Json point_json(Point p) { return {p.x, p.y, p.z}; }

// "disc", "disc with 2 holes", "closed", "one-sided", "with 3 handles and 2 loops".
std::string shape_of(const ComponentSummary& c) {
  if (c.triangles == 0) return "none";
  if (!c.orientable) return "one-sided";
  const std::string handles =
      c.genus == 0 ? "" : std::to_string(c.genus) + (c.genus == 1 ? " handle" : " handles");
  if (c.loops == 0) return handles.empty() ? "closed" : "closed, with " + handles;
  if (!handles.empty()) return "with " + handles;
  if (c.loops == 1) return "disc";
  return "disc with " + std::to_string(c.loops - 1) + (c.loops == 2 ? " hole" : " holes");
}

Json repairs_json(const std::vector<HandleRepair>& repairs) {
  Json json = Json::array();
  for (const HandleRepair& repair : repairs) {
    json.push_back({{"points", repair.points},
                    {"place", point_json(repair.place)},
                    {"length", repair.length},
                    {"triangles_removed", repair.removed},
                    {"triangles_added", repair.added}});
  }
  return json;
}

Json left_out_json(const std::vector<LeftOut>& parts) {
  Json json = Json::array();
  for (const LeftOut& part : parts) {
    Json one = {{"points", part.ids.size()},
                {"ids", part.ids},
                {"box", {point_json(part.low), point_json(part.high)}},
                {"cause", part.cause},
                {"try", part.remedy}};
    if (part.component != none) one["component"] = part.component;
    json.push_back(std::move(one));
  }
  return json;
}

// Of each component. A component that the paper's presets make is a disc.
Json kinds_json(const Report& report) {
  if (report.components.empty()) return {name(report.options.map.domain)};
  Json json = Json::array();
  for (const ComponentSummary& c : report.components) json.push_back(name(c.map));
  return json;
}

Json components_json(const std::vector<ComponentSummary>& components) {
  Json json = Json::array();
  for (const ComponentSummary& c : components) {
    Json one = {{"points", c.points},       {"triangles", c.triangles},      {"loops", c.loops},
                {"bad_edges", c.bad_edges}, {"bad_edge_share", c.bad_share}, {"suspect", c.suspect}};
    one["map"] = {{"kind", name(c.map)}, {"charts", c.charts}, {"seam_length", c.seams}};
    one["orientable"] = c.orientable;
    one[c.orientable ? "handles" : "cross_caps"] = c.genus;
    one["shape"] = shape_of(c);
    one["box"] = {point_json(c.low), point_json(c.high)};
    if (!c.repairs.empty()) one["repairs"] = repairs_json(c.repairs);
    if (!c.failure.empty()) one["failure"] = c.failure;
    if (c.mesh.triangles > 0) {
      one["mesh"] = mesh_json(c.mesh);
      one["mesh"]["self_intersections"] = c.self_intersections;
      one["distortion"] = distortion_json(c.distortion);
    }
    if (c.to_reference) one["mesh_to_reference"] = distance_json(*c.to_reference);
    json.push_back(std::move(one));
  }
  return json;
}

Json run_json(const Report& report) {
  Json stages = Json::array();
  double seconds = 0;
  std::size_t peak = 0;
  for (const StageCost& cost : report.stages) {
    stages.push_back(
        {{"stage", name(cost.stage)}, {"seconds", cost.seconds}, {"peak_bytes", cost.peak_bytes}});
    seconds += cost.seconds;
    peak = std::max(peak, cost.peak_bytes);
  }
  return {{"threads", report.threads}, {"seconds", seconds}, {"peak_bytes", peak}, {"stages", stages}};
}

}  // namespace

const char* name(LoopSource source) {
  switch (source) {
    case LoopSource::Fittest: return "fittest chromosome";
    case LoopSource::Later: return "later chromosome";
    case LoopSource::InitialPath: return "initial path";
  }
  return "?";
}

Json steps_json(const StepSummary& steps) {
  const auto number = [](double quantum) { return quantum > 0 ? Json(quantum) : Json(); };
  return {{"x", number(steps.x)},
          {"y", number(steps.y)},
          {"z", number(steps.z)},
          {"removed", number(steps.removed)},
          {"removed_along", steps.removed_along.empty() ? Json() : Json(steps.removed_along)}};
}

std::string to_json(const Report& report) {
  Json json;
  json["schema"] = 1;
  json["version"] = version;
  json["options"] = options_json(report);
  json["seed"] = report.seed;
  json["points"] = {{"input", report.points.input},           {"used", report.points.used},
                    {"not_finite", report.points.not_finite}, {"duplicates", report.points.duplicates},
                    {"stray", report.points.stray},           {"unmeshed", report.points.unmeshed}};
  json["spacing"] = {{"mean", report.spacing.mean},
                     {"least", report.spacing.least},
                     {"quantile_05", report.spacing.low},
                     {"quantile_95", report.spacing.high},
                     {"most", report.spacing.most}};
  json["steps"] = steps_json(report.steps);
  json["assumptions"] = {{"delta", report.assumptions.delta},
                         {"points_below_delta_0.05", report.assumptions.below_delta},
                         {"points_per_sector", report.assumptions.points_per_sector},
                         {"chi_square_valid", report.assumptions.chi_square_valid}};
  json["candidates"] = report.candidates;
  json["undersampled"] = report.undersampled;
  json["loops"] = loops_json(report.loops);
  if (counts(UsedBy::Default, report.options)) json["closed"] = report.closed;
  if (!report.doubtful.empty()) json["doubtful_gaps"] = doubtful_json(report.doubtful);
  json["search"] = search_json(report.options, report.search);
  if (report.has_map) {
    json["map"] = {{"kind", kinds_json(report)},
                   {"unknowns", report.map.unknowns},
                   {"iterations", report.map.iterations},
                   {"residual", report.map.residual}};
    std::size_t charts = report.components.empty() ? 1 : 0;
    double seams = 0;
    for (const ComponentSummary& c : report.components) charts += c.charts, seams += c.seams;
    json["map"]["charts"] = charts;
    json["map"]["seam_length"] = seams;
  }
  if (report.has_mesh) {
    json["mesh"] = mesh_json(report.mesh);
    json["mesh"]["self_intersections"] = report.self_intersections;
    json["mesh"]["more_self_intersections"] = report.more_self_intersections;
    json["mesh"]["longest_edge_over_median_spacing"] = report.longest_edge;
    json["mesh"]["offset"] = {report.offset.x, report.offset.y, report.offset.z};
    json["distortion"] = distortion_json(report.distortion);
  }
  if (report.holes) json["holes"] = holes_json(report.options, *report.holes);
  if (report.reference) json["reference"] = reference_json(*report.reference);
  if (!report.components.empty()) json["components"] = components_json(report.components);
  if (!report.left_out.empty()) json["left_out"] = left_out_json(report.left_out);
  json["warnings"] = report.warnings;
  json["run"] = run_json(report);
  // File names need not be valid UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rimline
