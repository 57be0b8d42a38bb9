// SPDX-License-Identifier: GPL-3.0-or-later
// The checksums of an E57 file, made right: else a change of any byte is all that the reader ever sees.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace rimline::fuzz {

// CRC-32C (Castagnoli), a byte at a time.
inline std::uint32_t crc32c(const char* at, std::size_t size) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> values{};
    for (std::uint32_t i = 0; i < values.size(); ++i) {
      values[i] = i;
      for (int bit = 0; bit < 8; ++bit) values[i] = values[i] / 2 ^ (values[i] % 2 == 0 ? 0 : 0x82F63B78U);
    }
    return values;
  }();
  std::uint32_t sum = ~0U;
  for (; size > 0; --size, ++at) sum = table[(sum ^ static_cast<unsigned char>(*at)) & 255U] ^ sum >> 8;
  return ~sum;
}

// Filled up to whole pages of the size that the header tells, at byte 40; each ends in its checksum.
inline std::string with_checksums(std::string file) {
  constexpr std::size_t header = 48, place = 40, checksum = 4, most_page = 1 << 20;
  if (file.size() < header) return file;
  std::uint64_t page = 0;
  for (std::size_t i = 8; i-- > 0;) page = page << 8 | static_cast<unsigned char>(file[place + i]);
  if (page <= checksum || page > most_page || page > file.size()) return file;
  file.resize((file.size() + page - 1) / page * page);
  for (std::size_t first = 0; first < file.size(); first += page) {
    const std::size_t end = first + page - checksum;
    const std::uint32_t sum = crc32c(file.data() + first, end - first);
    for (std::size_t i = 0; i < checksum; ++i) file[end + i] = static_cast<char>(sum >> (24 - 8 * i));
  }
  return file;
}

}  // namespace rimline::fuzz
