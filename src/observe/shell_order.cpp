#include "wirepack/observe/shell_order.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/observe/order.hpp"

namespace wirepack {

std::vector<ShellOrder> order_by_shell(const RodState& state, const Cavity& cavity, double width) {
  const double cavity_radius = semi_axes_of(cavity).minCoeff();
  const auto count = static_cast<std::size_t>(std::ceil(cavity_radius / width - 1e-9));
  std::vector<std::vector<Vec3>> tangents_in(count);
  const Points tangents = edge_tangents(state);
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 midpoint = (state.nodes.col(j) + state.nodes.col(next_node(state, j))) / 2;
    const double depth = std::max(0.0, wall_gap(cavity, midpoint, 0));
    const auto shell = std::min(static_cast<std::size_t>(depth / width), count - 1);
    tangents_in[shell].push_back(tangents.col(j));
  }
  std::vector<ShellOrder> shells;
  for (std::size_t k = 0; k < count; ++k) {
    Points axes(3, static_cast<Index>(tangents_in[k].size()));
    for (Index j = 0; j < axes.cols(); ++j)
      axes.col(j) = tangents_in[k][static_cast<std::size_t>(j)];
    const double outer = cavity_radius - static_cast<double>(k) * width;
    shells.push_back({std::max(0.0, outer - width), outer, axes.cols(), axial_order(axes).order()});
  }
  return shells;
}

}  // namespace wirepack
