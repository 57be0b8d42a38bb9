// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/options.h"

#include <doctest/doctest.h>

#include <string>

#include "rimline/run.h"

namespace rimline {

TEST_CASE("the policy for holes reads what it writes") {
  for (const char* text : {"keep", "fill", "fill:30", "fill:2.5u", "fill:3"})
    CHECK(name(parse_holes(text)) == text);
  CHECK(parse_holes("fill:30").most_points == 30);
  CHECK(parse_holes("fill:1e3u").most_length == 1000);
}

TEST_CASE("a policy for holes that is none is refused, and the message says what is allowed") {
  for (const char* text : {"", "Keep", "fill:", "fill:2", "fill:-3", "fill:2.5", "fill:0u", "fill:u",
                           "fill:nanu", "fill:infu", "fill:3x", "fill:30 ", "fill30"}) {
    CAPTURE(text);
    try {
      parse_holes(text);
      CHECK(false);
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::BadOption);
      CHECK(std::string(error.what()).find("fill:2.5u") != std::string::npos);
    }
  }
}

TEST_CASE("the defaults are those of section 4") {
  for (const Preset preset : {Preset::Default, Preset::Paper, Preset::PaperLog}) {
    const Options options = preset_options(preset);
    CHECK(options.boundary.k == 40);
    CHECK(options.boundary.sectors == 8);
    CHECK(options.boundary.significance == 0.10);
    CHECK(options.loops.path_k == 40);
    CHECK(options.loops.path_threshold == 0);
    CHECK(options.loops.length_exponent == 0.9);
    CHECK(options.loops.population == 100);
    CHECK(options.loops.generations == 100);
  }
  CHECK(preset_options(Preset::Paper).loops.score_form == ScoreForm::Capped);
  CHECK(preset_options(Preset::Paper).loops.score_cap == 1e-3);
  CHECK(preset_options(Preset::PaperLog).loops.score_form == ScoreForm::Log);
}

// Another value that lies in the range of a field.
template <class T>
T other_value(const Field<T>& field) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(static_cast<int>(field.value) == 0 ? 1 : 0);
  } else {
    return field.value == field.least ? field.most : field.least;
  }
}

TEST_CASE("an option that does not count is refused unless it is at its default, and the presets are named") {
  for (const Preset preset : {Preset::Default, Preset::Paper, Preset::PaperLog}) {
    std::vector<std::string> names;
    Options defaults = preset_options(preset);
    CHECK_NOTHROW(check_options(defaults));
    visit_fields(defaults, [&](const auto& field) { names.emplace_back(field.name); });
    for (const std::string& changed : names) {
      CAPTURE(changed);
      Options options = defaults;
      UsedBy used_by = UsedBy::All;
      visit_fields(options, [&](const auto& field) {
        if (changed != field.name) return;
        field.value = other_value(field);
        used_by = field.used_by;
      });
      try {
        check_options(options);
        CHECK(counts(used_by, options));
      } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::BadOption);
        CHECK_FALSE(counts(used_by, options));
        CHECK(std::string(error.what()).find(changed + " is " + where_used(used_by)) == 0);
      }
    }
  }
}

TEST_CASE("options of the paper's search do not change the neighbours of the default") {
  Options options;
  const int k = most_neighbours(options);
  options.loops.path_k = 60;
  options.map.map_k = 80;
  CHECK(most_neighbours(options) == k);
  options.preset = Preset::Paper;
  CHECK(most_neighbours(options) == 80);
}

}  // namespace rimline
