// SPDX-License-Identifier: GPL-3.0-or-later
// LOOPS.json, schema 1.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <nlohmann/json.hpp>

#include "io/readers.h"
#include "rimline/io.h"

namespace rimline {
namespace {

using Json = nlohmann::json;

// Shortest form that reads back the same; JSON has no NaN or infinity, null says "not known".
std::string number_text(double value) {
  if (!std::isfinite(value)) return "null";
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// A value quoted in a message: writing a deep nest would need as deep a stack.
std::string quoted(const Json& value) {
  return value.is_structured() ? std::string("an ") + value.type_name() : io::quoted(value.dump());
}

class LoopsReader {
 public:
  LoopsReader(const io::Source& source, std::size_t point_count)
      : source_(source), point_count_(point_count) {}

  // The tree that the text becomes takes up to 32 bytes a byte: of brackets, or of short numbers in lists
  // that grow.
  void check_limit(const Run& run) const {
    constexpr std::size_t tree = 32;
    if (run.memory_limit == 0 || source_.bytes().size() <= run.memory_limit / tree) return;
    throw Error(ErrorCode::OutOfMemory, source_.name() + ": its loops may need " +
                                            std::to_string(tree * source_.bytes().size()) +
                                            " bytes, more than the memory limit of " +
                                            std::to_string(run.memory_limit) + "; raise the limit");
  }

  std::vector<Loop> read() const {
    const Json json = parse();
    if (!json.is_object() || !json.contains("loops") || !json["loops"].is_array()) {
      source_.fail("has no list 'loops'; LOOPS.json looks like {\"loops\": [{\"points\": [0, 1, 2]}]}");
    }
    check_schema(json);
    std::vector<Loop> loops;
    for (const Json& item : json["loops"]) loops.push_back(read_loop(item, loops.size()));
    return loops;
  }

 private:
  Json parse() const {
    if (source_.bytes().empty()) source_.fail("is empty (0 bytes); copy or export it again");
    try {
      return Json::parse(source_.bytes());
    } catch (const Json::parse_error& error) {
      const std::size_t byte = std::min(error.byte, source_.bytes().size());
      source_.fail_at_line(source_.begin() + (byte > 0 ? byte - 1 : 0),
                           "is not valid JSON (byte " + std::to_string(byte) +
                               "); correct it there, or write the loops again with --loops");
    } catch (const Json::exception&) {
      source_.fail("holds a number or text that JSON can not have; write the loops again with --loops");
    }
  }

  void check_schema(const Json& json) const {
    const auto schema = json.find("schema");
    if (schema != json.end() && *schema != 1) {
      source_.fail("has schema " + quoted(*schema) + "; this version reads schema 1");
    }
    const auto points = json.find("points");
    if (points != json.end() && points->is_number() && *points != point_count_) {
      source_.fail("was made for " + points->dump() + " points, but the cloud has " +
                   std::to_string(point_count_) + "; use it with the file it was made from");
    }
  }

  [[noreturn]] void fail_loop(std::size_t number, const std::string& message) const {
    source_.fail("loop " + std::to_string(number) + " " + message);
  }

  Loop read_loop(const Json& item, std::size_t number) const {
    if (!item.is_object() || !item.contains("points") || !item["points"].is_array()) {
      fail_loop(number, "has no list 'points' of ids");
    }
    const auto closed = item.find("closed");
    if (closed != item.end() && *closed == false)
      fail_loop(number, "is not closed; only closed loops bound a surface");
    Loop loop;
    for (const Json& id : item["points"]) loop.points.push_back(read_id(id, number));
    if (loop.points.size() > 1 && loop.points.front() == loop.points.back()) loop.points.pop_back();
    check_distinct(loop.points, number);
    loop.kind = read_kind(item, number);
    loop.length = item.value("length", Json()).is_number() ? item["length"].get<double>() : 0;
    loop.fitness = item.value("fitness", Json()).is_number() ? item["fitness"].get<double>() : 0;
    return loop;
  }

  Index read_id(const Json& id, std::size_t number) const {
    const bool in_range = id.is_number_unsigned() && id.get<std::uint64_t>() < point_count_;
    if (!in_range) {
      fail_loop(number, "has the id " + quoted(id) + "; ids are integers from 0 to " +
                            std::to_string(static_cast<long long>(point_count_) - 1));
    }
    return static_cast<Index>(id.get<std::uint64_t>());
  }

  void check_distinct(const std::vector<Index>& ids, std::size_t number) const {
    if (ids.size() < 3) fail_loop(number, "has fewer than three points");
    std::vector<Index> sorted = ids;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
      fail_loop(number, "has the id " + std::to_string(*twice) + " twice; split it there");
  }

  LoopKind read_kind(const Json& item, std::size_t number) const {
    const auto kind = item.find("kind");
    if (kind == item.end() || kind->is_null() || *kind == name(LoopKind::Outer)) return LoopKind::Outer;
    if (*kind == name(LoopKind::Hole)) return LoopKind::Hole;
    fail_loop(number, "has the kind " + quoted(*kind) + "; known are outer and hole");
  }

  const io::Source& source_;
  std::size_t point_count_;
};

}  // namespace

std::string loops_to_json(const std::vector<Loop>& loops, std::size_t point_count) {
  std::string text = "{\"schema\": 1,\n \"loops\": [";
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Loop& loop = loops[i];
    text += (i == 0 ? "\n  {\"id\": " : ",\n  {\"id\": ") + std::to_string(i);
    text.append(", \"kind\": \"").append(name(loop.kind)).append("\", \"closed\": true, \"points\": [");
    for (std::size_t j = 0; j < loop.points.size(); ++j) {
      if (j > 0) text += ", ";
      text += std::to_string(loop.points[j]);
    }
    text += "], \"length\": " + number_text(loop.length) + ", \"fitness\": " + number_text(loop.fitness);
    text += ", \"component\": " + std::to_string(loop.component);
    text += ", \"probability\": " + number_text(loop.probability) + "}";
  }
  text += loops.empty() ? "],\n" : "\n ],\n";
  return text + " \"points\": " + std::to_string(point_count) + "}\n";
}

std::vector<Loop> io::read_loops(const Source& source, std::size_t point_count, const Run& run) {
  try {
    const LoopsReader reader(source, point_count);
    reader.check_limit(run);
    return reader.read();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::OutOfMemory, source.name() + ": its loops do not fit into memory");
  }
}

std::vector<Loop> read_loops(const std::string& path, std::size_t point_count, const Run& run) {
  return io::read_loops(io::load(path, run), point_count, run);
}

}  // namespace rimline
