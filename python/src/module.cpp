// SPDX-License-Identifier: GPL-3.0-or-later
// rimline._core: the library as it is, for the package around it (python/rimline). Arrays come in as the
// package makes them; defaults of arguments are the package's business.
#include "parts.h"
#include "rimline/version.h"

NB_MODULE(_core, m) {
  using namespace rimline::python;
  m.attr("version") = rimline::version;
  add_errors(m);
  add_options(m);
  add_loops(m);
  add_pipeline(m);
  add_boundary_stages(m);
  add_mesh_stages(m);
  add_measures(m);
  add_files(m);
  add_sample(m);
}
