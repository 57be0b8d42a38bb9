// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/domain_traits.h"
#include "base/parse.h"
#include "base/preset_traits.h"
#include "rimline/run.h"

namespace rimline {

const char* name(Preset preset) { return traits(preset).name; }

const char* name(ScoreForm form) {
  switch (form) {
    case ScoreForm::Printed: return "printed";
    case ScoreForm::Capped: return "capped";
    case ScoreForm::Log: return "log";
  }
  return "?";
}

const char* name(LoopPolicy policy) {
  switch (policy) {
    case LoopPolicy::All: return "all";
    case LoopPolicy::Outer: return "outer";
    case LoopPolicy::Largest: return "largest";
  }
  return "?";
}

const char* name(RimSearch search) {
  switch (search) {
    case RimSearch::Greedy: return "greedy";
    case RimSearch::Climb: return "climb";
    case RimSearch::Genetic: return "genetic";
  }
  return "?";
}

const char* name(Domain domain) { return traits(domain).name; }

bool has_map(Domain domain) { return traits(domain).is_mapped(); }

const char* name(UvScale scale) {
  switch (scale) {
    case UvScale::Domain: return "domain";
    case UvScale::Unit: return "unit";
    case UvScale::Real: return "real";
  }
  return "?";
}

const char* name(HandlePolicy handles) {
  switch (handles) {
    case HandlePolicy::Repair: return "repair";
    case HandlePolicy::Keep: return "keep";
  }
  return "?";
}

bool counts(UsedBy used_by, const Options& options) {
  const MethodKind method = traits(options.preset).method;
  switch (used_by) {
    case UsedBy::All: return true;
    case UsedBy::Default: return method == MethodKind::Default;
    case UsedBy::Paper: return method == MethodKind::Paper;
    case UsedBy::Capped: return method == MethodKind::Paper && options.loops.score_form == ScoreForm::Capped;
  }
  return true;
}

std::string where_used(UsedBy used_by) {
  switch (used_by) {
    case UsedBy::All: return "";
    case UsedBy::Default: return "of the preset default alone";
    case UsedBy::Paper: return "of the presets paper and paper-log alone";
    case UsedBy::Capped: return "of the presets paper and paper-log with the score form capped alone";
  }
  return "";
}

int most_neighbours(const Options& options) {
  const int most = std::max(options.boundary.k, traits(options.preset).least_neighbours);
  return counts(UsedBy::Paper, options) ? std::max({most, options.loops.path_k, options.map.map_k}) : most;
}

std::string name(const HolePolicy& holes) {
  if (!holes.fill) return "keep";
  if (holes.most_points > 0) return fmt::format("fill:{}", holes.most_points);
  if (holes.most_length > 0) return fmt::format("fill:{}u", holes.most_length);
  return "fill";
}

HolePolicy parse_holes(std::string_view text) {
  const auto refuse = [&]() -> HolePolicy {
    throw Error(ErrorCode::BadOption,
                fmt::format("holes is '{}'; it must be keep, fill, fill:POINTS (a whole number of points on "
                            "the rim, as in fill:30) or fill:LENGTHu (the rim's length in units of the "
                            "input, as in fill:2.5u)",
                            text));
  };
  constexpr std::string_view most = "fill:";
  if (text == "keep") return {};
  if (text == "fill") return {.fill = true};
  if (!text.starts_with(most)) return refuse();
  HolePolicy holes{.fill = true};
  const char* from = text.data() + most.size();
  const char* end = text.data() + text.size();
  const bool is_length = end > from && end[-1] == 'u';
  if (is_length) {
    const char* after = read_number(from, --end, holes.most_length);
    if (after != end || !std::isfinite(holes.most_length) || !(holes.most_length > 0)) return refuse();
  } else if (read_number(from, end, holes.most_points) != end || holes.most_points < 3) {
    return refuse();
  }
  return holes;
}

Options preset_options(Preset preset) {
  Options options;
  options.preset = preset;
  options.loops.score_form = traits(preset).score_form;
  return options;
}

namespace {

// Each field's value as a number.
std::map<std::string, double> numbers_of(const Options& options) {
  std::map<std::string, double> numbers;
  visit_fields(options, [&](const auto& field) { numbers[field.name] = static_cast<double>(field.value); });
  return numbers;
}

[[noreturn]] void refuse_unused(const char* field, UsedBy used_by, const Options& options) {
  throw Error(ErrorCode::BadOption, fmt::format("{} is {}; these options are of the preset {}", field,
                                                where_used(used_by), name(options.preset)));
}

// What does not count must be at its default: nobody should believe that it did something.
void check_used(const Options& options) {
  const auto defaults = numbers_of(preset_options(options.preset));
  visit_fields(options, [&](const auto& field) {
    const bool is_default = static_cast<double>(field.value) == defaults.at(field.name);
    if (!is_default && !counts(field.used_by, options)) refuse_unused(field.name, field.used_by, options);
  });
  if (counts(UsedBy::Default, options)) return;
  if (options.mesh.holes.fill) refuse_unused("holes", UsedBy::Default, options);
  if (options.map.corners[0] != none) refuse_unused("corners", UsedBy::Default, options);
}

}  // namespace

void check_options(const Options& options) {
  visit_fields(options, []<class T>(const Field<T>& field) {
    if constexpr (std::is_arithmetic_v<T>) {
      if (field.value >= field.least && field.value <= field.most) return;  // false for NaN too
      throw Error(ErrorCode::BadOption, fmt::format("{} is {}; it must lie between {} and {}", field.name,
                                                    field.value, field.least, field.most));
    }
  });
  if (!is_finite(options.mesh.up) || norm(options.mesh.up) == 0) {
    throw Error(ErrorCode::BadOption, "up must be a finite vector other than zero");
  }
  check_used(options);
}

}  // namespace rimline
