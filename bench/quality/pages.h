// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of docs/quality.md, each from the results alone.
#pragma once

#include <string>

#include "quality/results.h"

namespace rimline::bench {

inline constexpr const char* default_method = "default";

std::string quality_page(const Results& results);  // all of them, under one title, but the corpus
std::string corpus_page(const Results& results);

std::string provenance_section(const Results& results);
std::string aims_section(const Results& results);
std::string analytic_loops_section(const Results& results);
std::string data_loops_section(const Results& results);
std::string reliability_section(const Results& results);
std::string search_section(const Results& results);
std::string mesh_section(const Results& results);

}  // namespace rimline::bench
