// SPDX-License-Identifier: GPL-3.0-or-later
// How a peer is asked: PROGRAM METHOD IN OUT. Both files are plain arrays in native order.
//   IN   count (int64), then x y z (3 doubles) a point
//   OUT  seconds that the method took (double);
//        count (int64), then the ids (int32) of the points on the boundary;
//        count (int64), then three ids (3 int32) a triangle
// Status 0, or another and the reason on standard error.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace rimline::peers {

using Coordinates = std::vector<std::array<double, 3>>;

struct Answer {
  double seconds = 0;
  std::vector<std::int32_t> boundary;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

template <class T>
void write_array(std::ostream& out, const std::vector<T>& values) {
  const auto count = static_cast<std::int64_t>(values.size());
  out.write(reinterpret_cast<const char*>(&count), sizeof count);
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T>
std::vector<T> read_array(std::istream& in) {
  std::int64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof count);
  if (!in || count < 0) throw std::runtime_error("truncated file between bench and peer");
  std::vector<T> values(static_cast<std::size_t>(count));
  in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  if (!in) throw std::runtime_error("truncated file between bench and peer");
  return values;
}

inline void write_answer(const std::string& path, const Answer& answer) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&answer.seconds), sizeof answer.seconds);
  write_array(out, answer.boundary);
  write_array(out, answer.triangles);
  if (!out.flush()) throw std::runtime_error("can not write " + path);
}

inline Answer read_answer(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  Answer answer;
  in.read(reinterpret_cast<char*>(&answer.seconds), sizeof answer.seconds);
  answer.boundary = read_array<std::int32_t>(in);
  answer.triangles = read_array<std::array<std::int32_t, 3>>(in);
  return answer;
}

// Whether METHOD IN OUT were given and the method is one of these; prints the usage where not.
template <class Methods>
bool is_known_method(int argc, char** argv, const Methods& methods) {
  if (argc == 4 && methods.contains(argv[1])) return true;
  std::fprintf(stderr, "usage: %s METHOD IN OUT, METHOD one of:\n", argv[0]);
  for (const auto& [name, method] : methods) std::fprintf(stderr, "  %s\n", name.c_str());
  return false;
}

// The main() of a peer.
using Method = std::function<Answer(const Coordinates&)>;
inline int serve(int argc, char** argv, const std::map<std::string, Method>& methods) try {
  if (!is_known_method(argc, argv, methods)) return 1;
  std::ifstream in(argv[2], std::ios::binary);
  const auto points = read_array<std::array<double, 3>>(in);
  const auto start = std::chrono::steady_clock::now();
  Answer answer = methods.at(argv[1])(points);
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_answer(argv[3], answer);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}

}  // namespace rimline::peers
