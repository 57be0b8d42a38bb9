// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of a data folder: NAME.ply with a property `boundary` where the truth is known, beside it
// NAME.truth.ply (the mesh the points come from, the same vertices), NAME.flipped.ply (its triangles after
// flips in 3D) or NAME.loops.json (the points in order along the loop they were sampled on). A folder with an
// index.json is a corpus: its `sets` tell name and style of each.
#pragma once

#include <string>
#include <vector>

#include "quality/case.h"

namespace rimline::bench {

// Ascending by name.
// `folders`: one, or several parted by `:`, of which the first that has a set gives it.
std::vector<CaseName> data_cases(const std::string& folders);

// The path of a file of a set, without regard to whether it is there where none of the folders has it.
std::string data_path(const std::string& folders, const std::string& file);
// Throws rimline::Error{CannotRead}.
Case read_data_set(const std::string& folders, const CaseName& name);

}  // namespace rimline::bench
