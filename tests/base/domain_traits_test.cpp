// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/domain_traits.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace rimline {
namespace {

TEST_CASE("a square and a rectangle have corners, a disc and a free map have none") {
  CHECK(traits(Domain::Square).outline == Outline::Box);
  CHECK(traits(Domain::Rectangle).outline == Outline::Box);
  CHECK(traits(Domain::Disc).outline == Outline::Circle);
  CHECK(traits(Domain::Free).outline == Outline::Circle);
  CHECK(traits(Domain::None).outline == Outline::None);
}

TEST_CASE("every domain but none has a map, and all have names of their own") {
  std::set<std::string> names;
  for (const Domain domain : {Domain::Disc, Domain::Square, Domain::Rectangle, Domain::Free, Domain::None}) {
    CHECK(has_map(domain) == (domain != Domain::None));
    names.insert(name(domain));
  }
  CHECK(names.size() == 5);
  CHECK_FALSE(names.contains("?"));
}

TEST_CASE("only a free map lets its outline go, and only a square is as high as wide") {
  for (const Domain domain : {Domain::Disc, Domain::Square, Domain::Rectangle, Domain::Free, Domain::None}) {
    CHECK(traits(domain).released == (domain == Domain::Free));
    CHECK(traits(domain).square == (domain == Domain::Square));
  }
}

}  // namespace
}  // namespace rimline
