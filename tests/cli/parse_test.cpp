// SPDX-License-Identifier: GPL-3.0-or-later
#include "parse.h"

#include <doctest/doctest.h>

#include "outputs.h"
#include "rimline/run.h"
#include "summary.h"

using namespace rimline;
using namespace rimline::cli;

TEST_CASE("whole numbers are read whole, in plain or in scientific writing") {
  CHECK(parse_whole("-n", "1000000", 1, 10'000'000) == 1'000'000);
  CHECK(parse_whole("-n", "1e6", 1, 10'000'000) == 1'000'000);
  CHECK(parse_whole("-n", "4611686018427387904", 1, std::int64_t{1} << 62) == std::int64_t{1} << 62);
  for (const char* text : {"", " 1", "1 ", "1x", "1.5", "0x10", "nan", "1e400", "10000001", "0", "1e30"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_whole("-n", text, 1, 10'000'000), Error);
  }
}

TEST_CASE("bytes are read with and without a unit") {
  CHECK(parse_bytes("--memory-limit", "0") == 0);
  CHECK(parse_bytes("--memory-limit", "1500") == 1500);
  CHECK(parse_bytes("--memory-limit", "1.5k") == 1500);
  CHECK(parse_bytes("--memory-limit", "2M") == 2'000'000);
  CHECK(parse_bytes("--memory-limit", "12G") == 12'000'000'000);
  for (const char* text : {"", "G", "-1", "1T", "1 G", "12GB", "nan", "inf", "1e30", "1e12G"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_bytes("--memory-limit", text), Error);
  }
}

TEST_CASE("the ends of a range belong to it") {
  CHECK(parse_number("--noise", "0", 0, 2) == 0);
  CHECK(parse_number("--noise", "2", 0, 2) == 2);
  CHECK_THROWS_AS(parse_number("--noise", "2.0000001", 0, 2), Error);
  CHECK_THROWS_AS(parse_number("--noise", "nan", 0, 2), Error);
}

TEST_CASE("a direction has three numbers and a length") {
  CHECK(parse_direction("--up", "0,-1,2.5") == Point{0, -1, 2.5});
  for (const char* text : {"", "1,2", "1,2,3,4", "1,2,", ",1,2", "0,0,0", "a,b,c", "1,2,inf", "1 2 3"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_direction("--up", text), Error);
  }
}

TEST_CASE("the names of an enumeration are found by counting up") {
  CHECK(names_of<Preset>() == std::vector<std::string>{"default", "paper", "paper-log"});
  CHECK(names_of<ScoreForm>() == std::vector<std::string>{"printed", "capped", "log"});
  CHECK(parse_enum<ScoreForm>("--score-form", "log") == ScoreForm::Log);
}

TEST_CASE("a flag is spelled as its field, with dashes") {
  CHECK(flag_name("length_exponent") == "--length-exponent");
  CHECK(flag_name("k") == "--k");
}

TEST_CASE("endings are told in any case") {
  CHECK(ending_of("a/b.PLY") == "ply");
  CHECK(ending_of("a.b/c") == "");
  CHECK(ending_of("-") == "");
}

TEST_CASE("long numbers get commas") {
  CHECK(with_commas(0) == "0");
  CHECK(with_commas(999) == "999");
  CHECK(with_commas(1000) == "1,000");
  CHECK(with_commas(12745123) == "12,745,123");
  CHECK(with_commas(-100) == "-100");
  CHECK(with_commas(-1000) == "-1,000");
}
