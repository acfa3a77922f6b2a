#include <fmt/format.h>

#include "wirepack/io/export.hpp"

#include "../node_values.hpp"
#include "../palette.hpp"
#include "bytes.hpp"
#include "tube_mesh.hpp"

namespace wirepack {

namespace {

std::string header(const ExportSource& source, const TubeMesh& mesh, double top) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& line : source.provenance) text += "comment " + line + "\n";
  text += fmt::format(
      "comment scaled_bend_energy is per length, over YI/2R^2; colours end at {:.3g}\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property float scaled_bend_energy\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      top, mesh.points.cols(), mesh.triangles.size());
  return text;
}

}  // namespace

ExportedFiles export_ply(const ExportSource& source) {
  const TubeMesh mesh = tube_mesh(source.scenario, source.frames.back());
  const double top = top_of_colours(scaled_bend_energy(source.scenario, source.frames.back()));
  std::string bytes = header(source, mesh, top);
  for (Index i = 0; i < mesh.points.cols(); ++i) {
    for (const double x : mesh.points.col(i)) append_bytes(bytes, static_cast<float>(x));
    const Colour colour = palette_colour(mesh.scaled_bend_energy[i] / top);
    for (const std::uint8_t c : {colour.red, colour.green, colour.blue}) append_bytes(bytes, c);
    append_bytes(bytes, static_cast<float>(mesh.scaled_bend_energy[i]));
  }
  for (const auto& triangle : mesh.triangles) {
    append_bytes(bytes, std::uint8_t{3});
    for (const std::int32_t corner : triangle) append_bytes(bytes, corner);
  }
  return {{source.target, bytes}};
}

}  // namespace wirepack
