// SPDX-License-Identifier: GPL-3.0-or-later
// Any file of points or of a mesh, by the table of formats.
#include <new>

#include "io/formats.h"
#include "rimline/io.h"

namespace rimline {
namespace io {
namespace {

Cloud read_as(const Format& format, const Source& source, const Run& run) {
  Cloud cloud = format.read(source, run);
  if (cloud.format.empty()) cloud.format = format.about.name;  // some readers set a more specific name
  if (!source.packing().empty()) cloud.format += ", in " + source.packing();
  if (cloud.points.empty()) source.fail("has no points; export it again, with its vertices");
  source.progress(run, source.end());
  return cloud;
}

const Format& checked_format(const Source& source) {
  if (source.bytes().empty()) source.fail("is empty (0 bytes); copy or export it again");
  return format_of(source);
}

// Calls read(source), and names the file where memory runs out.
template <class Read>
auto read_file(const std::string& path, const Run& run, const Read& read) {
  const Source source = load(path, run);
  try {
    return read(source);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::OutOfMemory,
                source.name() + ": its points do not fit into memory; thin the cloud");
  }
}

}  // namespace

Cloud read_any(const Source& source, const Run& run) { return read_as(checked_format(source), source, run); }

}  // namespace io

Cloud read_cloud(const std::string& path, const Run& run) {
  return io::read_file(path, run, [&](const io::Source& source) { return io::read_any(source, run); });
}

MeshFile read_mesh(const std::string& path, const Run& run) {
  return io::read_file(path, run, [&](const io::Source& source) {
    const io::Format& format = io::checked_format(source);
    MeshFile mesh{io::read_as(format, source, run), {}};
    io::Faces faces(source, mesh.cloud.points.size());
    if (format.read_faces != nullptr) format.read_faces(source, mesh.cloud, faces);
    if (faces.triangles.empty()) {
      source.fail("has no faces; a mesh is wanted here, as " + names_of_formats(FormatUse::ReadFaces));
    }
    mesh.triangles = std::move(faces.triangles);
    return mesh;
  });
}

}  // namespace rimline
