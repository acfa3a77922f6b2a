#include <array>

#include "wirepack/io/export.hpp"

#include "bytes.hpp"
#include "tube_mesh.hpp"

namespace wirepack {

namespace {

void append_vector(std::string& bytes, const Vec3& v) {
  for (const double x : v) append_bytes(bytes, static_cast<float>(x));
}

}  // namespace

ExportedFiles export_stl(const ExportSource& source) {
  const TubeMesh mesh = tube_mesh(source.scenario, source.frames.back());
  constexpr std::size_t header_size = 80;
  std::string bytes = source.provenance.front().substr(0, header_size);
  bytes.resize(header_size, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.points.col(a), q = mesh.points.col(b), r = mesh.points.col(c);
    append_vector(bytes, (q - p).cross(r - p).normalized());
    for (const Vec3& corner : {p, q, r}) append_vector(bytes, corner);
    append_bytes(bytes, std::uint16_t{0});
  }
  return {{source.target, bytes}};
}

}  // namespace wirepack
