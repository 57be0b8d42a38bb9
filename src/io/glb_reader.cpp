// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0 binary: the vertices of all primitives that the scene shows, each at its place, with normals and
// colours; and their triangles.
#include <algorithm>
#include <cmath>
#include <optional>

#include "io/glb_document.h"
#include "io/readers.h"

namespace rimline::io {
namespace {

using Json = nlohmann::json;

Point placed(const GlbMatrix& m, Point p) {
  return {m[0] * p.x + m[4] * p.y + m[8] * p.z + m[12], m[1] * p.x + m[5] * p.y + m[9] * p.z + m[13],
          m[2] * p.x + m[6] * p.y + m[10] * p.z + m[14]};
}

// Normals turn with the inverse transpose, which is the matrix of the cofactors but for its length.
Point turned(const GlbMatrix& m, Point n) {
  const Point a{m[0], m[1], m[2]}, b{m[4], m[5], m[6]}, c{m[8], m[9], m[10]};
  const Point sum = n.x * cross(b, c) + n.y * cross(c, a) + n.z * cross(a, b);
  const double length = norm(sum);
  return length > 0 ? (1 / length) * sum : Point{};
}

// The content of one primitive, as many items of each kind.
struct Primitive {
  GlbMatrix place;
  GlbAccessor positions;
  std::optional<GlbAccessor> normals, colours;
};

Primitive primitive_of(const GlbDocument& document, const Json& json, const GlbMatrix& place) {
  const Json& attributes = json["attributes"];
  if (!attributes.is_object() || !attributes.contains("POSITION"))
    document.fail("has a mesh without POSITION");
  Primitive result{place, document.accessor(attributes["POSITION"]), {}, {}};
  const auto optional = [&](const char* name, std::size_t least_width) -> std::optional<GlbAccessor> {
    if (!attributes.contains(name)) return std::nullopt;
    const GlbAccessor found = document.accessor(attributes[name]);
    if (found.count != result.positions.count || found.width < least_width)
      document.fail(std::string("has ") + name + " that do not fit its positions");
    return found;
  };
  if (result.positions.width != 3) document.fail("has positions that are not three numbers each");
  result.normals = optional("NORMAL", 3);
  result.colours = optional("COLOR_0", 3);
  return result;
}

std::vector<Primitive> primitives_of(const GlbDocument& document, const Source& source) {
  std::vector<Primitive> result;
  std::uint64_t count = 0;
  document.visit_primitives([&](const Json& json, const GlbMatrix& place) {
    result.push_back(primitive_of(document, json, place));
    count += result.back().positions.count;
    // A mesh that is used many times counts as often; the file size is no bound.
    if (count > 64 * source.bytes().size()) document.fail("shows its meshes too often");
    check_point_count(source, count);
  });
  return result;
}

Point three(const GlbAccessor& accessor, std::size_t i) {
  return {accessor.value(i, 0), accessor.value(i, 1), accessor.value(i, 2)};
}

template <class Has>
bool all_have(const std::vector<Primitive>& primitives, const Has& has) {
  return !primitives.empty() && std::ranges::all_of(primitives, has);
}

void add_normals(Cloud& cloud, const std::vector<Primitive>& primitives) {
  std::array<std::vector<float>, 3> values;
  for (const Primitive& p : primitives) {
    for (std::size_t i = 0; i < p.positions.count; ++i) {
      const Point n = turned(p.place, three(*p.normals, i));
      values[0].push_back(static_cast<float>(n.x));
      values[1].push_back(static_cast<float>(n.y));
      values[2].push_back(static_cast<float>(n.z));
    }
  }
  const char* const names[] = {"nx", "ny", "nz"};
  for (std::size_t c = 0; c < 3; ++c) set_column(cloud, make_column(names[c], values[c]));
}

void add_colours(Cloud& cloud, const std::vector<Primitive>& primitives) {
  const char* const names[] = {"red", "green", "blue"};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<std::uint8_t> values;
    for (const Primitive& p : primitives) {
      for (std::size_t i = 0; i < p.positions.count; ++i) {
        const double share = std::clamp(p.colours->value(i, c), 0.0, 1.0);
        values.push_back(static_cast<std::uint8_t>(std::isnan(share) ? 0 : std::lround(255 * share)));
      }
    }
    set_column(cloud, make_column(names[c], values));
  }
}

constexpr std::size_t mode_triangles = 4;

}  // namespace

bool is_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }

Cloud read_glb(const Source& source, const Run& run) {
  const GlbDocument document(source);
  const std::vector<Primitive> primitives = primitives_of(document, source);
  Cloud cloud;
  for (const Primitive& p : primitives) {
    for (std::size_t i = 0; i < p.positions.count; ++i) {
      if (i % items_per_look == 0) source.progress(run, i, p.positions.count);
      cloud.points.push_back(placed(p.place, three(p.positions, i)));
    }
  }
  if (all_have(primitives, [](const Primitive& p) { return p.normals.has_value(); }))
    add_normals(cloud, primitives);
  if (all_have(primitives, [](const Primitive& p) { return p.colours.has_value(); }))
    add_colours(cloud, primitives);
  cloud.unit = std::string("m");  // the standard's, whether or not the writer knew
  return cloud;
}

void read_glb_faces(const Source& source, const Cloud&, Faces& faces) {
  const GlbDocument document(source);
  long long first = 0;
  document.visit_primitives([&](const Json& json, const GlbMatrix& place) {
    const long long count = static_cast<long long>(primitive_of(document, json, place).positions.count);
    const auto mode = json.find("mode");
    const bool triangles = mode == json.end() || *mode == mode_triangles;
    if (triangles && json.contains("indices")) {
      const GlbAccessor ids = document.accessor(json["indices"]);
      for (std::size_t i = 0; i < ids.count; ++i) {
        const double id = ids.value(i, 0);
        const bool known = id >= 0 && id < static_cast<double>(count);
        const char* at = ids.place(i) == nullptr ? source.begin() : ids.place(i);
        faces.corner(known ? first + static_cast<long long>(id) : -1, at, Faces::Place::Byte);
        if (i % 3 == 2) faces.close();
      }
    } else if (triangles) {
      for (long long i = 0; i < count; ++i) {
        faces.corner(first + i, source.begin(), Faces::Place::Byte);
        if (i % 3 == 2) faces.close();
      }
    }
    first += count;
  });
}

}  // namespace rimline::io
