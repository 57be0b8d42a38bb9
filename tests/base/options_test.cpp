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

}  // namespace rimline
