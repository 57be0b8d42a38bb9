// SPDX-License-Identifier: GPL-3.0-or-later
// Recognizes file formats by content.
#pragma once

#include <string>
#include <string_view>

namespace rimline::io {

// The last part of a name after its dot, in lower case; empty where there is none.
std::string lower_ending(std::string_view name);

// No control characters in the first kilobytes.
bool is_text(std::string_view bytes);

// UTF-16 without a byte order mark: every other byte of the first is 0.
bool is_utf16(std::string_view bytes);

bool tells_ply(std::string_view bytes);
bool tells_pcd(std::string_view bytes);
bool tells_stl(std::string_view bytes);
bool tells_off(std::string_view bytes);
bool tells_obj(std::string_view bytes);

}  // namespace rimline::io
