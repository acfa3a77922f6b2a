#include "tube_mesh.hpp"

#include <cmath>

#include "../node_values.hpp"
#include "../tube.hpp"

namespace wirepack {

namespace {

constexpr Index around = 16;

// Corners of a polygon with the area of a circle.
double corner_radius(double radius) {
  const double part = 2 * pi / static_cast<double>(around);
  return radius * std::sqrt(part / std::sin(part));
}

}  // namespace

TubeMesh tube_mesh(const Scenario& scenario, const PackingFrame& frame) {
  const Points& nodes = frame.rod.nodes;
  const SmoothLine line =
      smooth_line(nodes, scaled_bend_energy(scenario, frame), smooth_parts(nodes.cols()));
  const Index rings = line.points.cols(), first_end = rings * around, last_end = first_end + 1;
  TubeMesh mesh;
  mesh.points.resize(3, first_end + 2);
  mesh.points << tube_rings(line.points, corner_radius(scenario.wire.radius), around),
      line.points.col(0), line.points.col(rings - 1);
  mesh.scaled_bend_energy.resize(first_end + 2);
  for (Index i = 0; i < first_end; ++i) mesh.scaled_bend_energy[i] = line.colour[i / around];
  mesh.scaled_bend_energy.tail(2) << line.colour[0], line.colour[rings - 1];

  const auto add = [&](Index a, Index b, Index c) {
    mesh.triangles.push_back(
        {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)});
  };
  const auto corner = [](Index ring, Index j) { return ring * around + j % around; };
  for (Index j = 0; j < around; ++j) {
    add(first_end, corner(0, j + 1), corner(0, j));
    for (Index k = 0; k + 1 < rings; ++k) {
      add(corner(k, j), corner(k, j + 1), corner(k + 1, j + 1));
      add(corner(k, j), corner(k + 1, j + 1), corner(k + 1, j));
    }
    add(last_end, corner(rings - 1, j), corner(rings - 1, j + 1));
  }
  return mesh;
}

}  // namespace wirepack
