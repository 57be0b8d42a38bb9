// SPDX-License-Identifier: GPL-3.0-or-later
#include "session.h"

#include <doctest/doctest.h>

using namespace rimline;
using namespace rimline::cli;

TEST_CASE("a run of the tool takes its seed and threads from the flags and stops when it is interrupted") {
  Common common;
  common.seed = 7;
  common.threads = 2;
  const Session session(common);
  CHECK(session.run().seed == 7);
  CHECK(session.run().threads == 2);
  CHECK_NOTHROW(session.run().check_cancel());
  interrupted = true;
  CHECK_THROWS_AS(session.run().check_cancel(), Error);
  interrupted = false;
}
