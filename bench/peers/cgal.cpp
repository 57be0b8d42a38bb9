// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/cgal.h"

int main(int argc, char** argv) {
  using namespace rimline::peers;
  return serve(argc, argv,
               {{"advancing-front", advancing_front},
                {"scale-space-alpha", scale_space_alpha},
                {"scale-space-advancing-front", scale_space_advancing_front}});
}
