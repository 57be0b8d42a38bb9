// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/domain_traits.h"

#include <doctest/doctest.h>

namespace rimline {
namespace {

TEST_CASE("a square and a rectangle have corners, a disc and a free map have none") {
  CHECK(traits(Domain::Square).outline == Outline::Box);
  CHECK(traits(Domain::Rectangle).outline == Outline::Box);
  CHECK(traits(Domain::Disc).outline == Outline::Circle);
  CHECK(traits(Domain::Free).outline == Outline::Circle);
  CHECK(traits(Domain::None).outline == Outline::None);
}

TEST_CASE("only a free map lets its outline go, and only a square is as high as wide") {
  for (const Domain domain : {Domain::Disc, Domain::Square, Domain::Rectangle, Domain::Free, Domain::None}) {
    CHECK(traits(domain).released == (domain == Domain::Free));
    CHECK(traits(domain).square == (domain == Domain::Square));
  }
}

}  // namespace
}  // namespace rimline
