// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module _core, each in a file of its name.
#pragma once

#include <nanobind/nanobind.h>

namespace rimline::python {

void add_errors(nanobind::module_& m);
void add_options(nanobind::module_& m);
void add_loops(nanobind::module_& m);
void add_pipeline(nanobind::module_& m);
void add_boundary_stages(nanobind::module_& m);
void add_mesh_stages(nanobind::module_& m);
void add_measures(nanobind::module_& m);
void add_files(nanobind::module_& m);
void add_sample(nanobind::module_& m);

}  // namespace rimline::python
