// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/results.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "rimline/run.h"

namespace rimline::bench {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Reliability& r) {
  Json bins = Json::array();
  for (const auto& bin : r.bins) bins.push_back({bin.points, bin.boundary, bin.probability});
  return {{"bins", bins}, {"squared_error", r.squared_error}};
}

Reliability reliability_from(const Json& json) {
  Reliability r;
  for (std::size_t i = 0; i < r.bins.size(); ++i) {
    const Json& bin = json.at("bins").at(i);
    r.bins[i] = {bin.at(0), bin.at(1), bin.at(2)};
  }
  r.squared_error = json.at("squared_error");
  return r;
}

Json to_json(const Row& row) {
  Json json{{"case", row.name.text()},       {"group", row.name.group}, {"shape", row.name.shape},
            {"sampling", row.name.sampling}, {"noise", row.name.noise}, {"n", row.name.n},
            {"draw", row.name.draw},         {"seed", row.name.seed},   {"method", row.method},
            {"seconds", row.seconds}};
  if (!row.error.empty()) json["error"] = row.error;
  if (!row.mesh_error.empty()) json["mesh_error"] = row.mesh_error;
  if (!row.loops.empty()) json["loops"] = row.loops;
  if (!row.mesh.empty()) json["mesh"] = row.mesh;
  if (row.reliability) json["reliability"] = to_json(*row.reliability);
  return json;
}

Row row_from(const Json& json) {
  Row row;
  row.name = {json.at("group"), json.at("shape"), json.at("sampling"), json.at("noise"),
              json.at("n"),     json.at("draw"),  json.at("seed")};
  row.method = json.at("method");
  row.seconds = json.at("seconds");
  row.error = json.value("error", "");
  row.mesh_error = json.value("mesh_error", "");
  if (json.contains("loops")) row.loops = json.at("loops").get<Metrics>();
  if (json.contains("mesh")) row.mesh = json.at("mesh").get<Metrics>();
  if (json.contains("reliability")) row.reliability = reliability_from(json.at("reliability"));
  return row;
}

Json to_json(const Provenance& run) {
  return {{"command", run.command}, {"version", run.version}, {"commit", run.commit},
          {"date", run.date},       {"seed", run.seed},       {"methods", run.methods}};
}

Provenance provenance_from(const Json& json) {
  return {json.at("command"), json.at("version"), json.at("commit"),
          json.at("date"),    json.at("seed"),    json.at("methods")};
}

std::set<std::string> methods_of(const Results& results) {
  std::set<std::string> methods;
  for (const auto& [id, title] : results.titles) methods.insert(id);
  return methods;
}

}  // namespace

void write_results(const std::string& path, const Results& results) {
  Json json{{"schema", 1}, {"runs", Json::array()}, {"titles", results.titles}, {"rows", Json::array()}};
  for (const Provenance& run : results.runs) json["runs"].push_back(to_json(run));
  for (const Row& row : results.rows) json["rows"].push_back(to_json(row));
  std::ofstream out(path);
  out << json.dump() << '\n';
  if (!out.flush()) throw Error(ErrorCode::CannotWrite, path + ": can not be written");
}

Results read_results(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw Error(ErrorCode::CannotRead, path + ": can not be opened");
  const Json json = Json::parse(in);
  Results results;
  results.titles = json.at("titles").get<decltype(results.titles)>();
  for (const Json& run : json.at("runs")) results.runs.push_back(provenance_from(run));
  for (const Json& row : json.at("rows")) results.rows.push_back(row_from(row));
  return results;
}

void keep_other_methods(Results& results, const Results& old) {
  const auto here = methods_of(results);
  const auto is_new = [&](const std::string& id) { return !here.contains(id); };
  for (const auto& title : old.titles) {
    if (is_new(title.first)) results.titles.push_back(title);
  }
  for (Provenance run : old.runs) {
    std::erase_if(run.methods, [&](const auto& id) { return !is_new(id); });
    if (!run.methods.empty()) results.runs.push_back(std::move(run));
  }
  for (const Row& row : old.rows) {
    if (is_new(row.method)) results.rows.push_back(row);
  }
}

}  // namespace rimline::bench
