#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/value_problems.hpp"
#include "wirepack/observe/coil_report.hpp"
#include "wirepack/observe/knot.hpp"
#include "wirepack/observe/loop_sizes.hpp"
#include "wirepack/observe/order.hpp"
#include "wirepack/observe/radial_density.hpp"
#include "wirepack/observe/shell_order.hpp"
#include "wirepack/observe/strand_spacing.hpp"
#include "wirepack/observe/writhe.hpp"

#include "module.hpp"

namespace wirepack {

namespace {

using py::literals::operator""_a;

Points nodes_of(const Positions& position, bool closed) {
  const Index fewest = closed ? 3 : 2;
  if (position.rows() < fewest) {
    throw InvalidInput(
        fmt::format("position has {} rows: must be at least {}", position.rows(), fewest));
  }
  if (!position.allFinite()) throw InvalidInput("position: must be finite numbers");
  return position.transpose();
}

RodState rod(const Positions& position, bool closed = false) {
  return make_rod(nodes_of(position, closed), {}, {.closed = closed});
}

void require_positive(double value, const char* name) {
  if (is_positive(value)) return;
  throw InvalidInput(fmt::format("{} = {}: {}", name, value, must_be_positive));
}

double writhe_of(const Positions& position, bool closed, int threads) {
  const Threads shared(threads);
  return crossing_sums(nodes_of(position, closed), closed).writhe;
}

double average_crossings(const Positions& position, bool closed, int threads) {
  const Threads shared(threads);
  return crossing_sums(nodes_of(position, closed), closed).average_crossing_number;
}

double twist(const Positions& position, const Quaternions& quaternion, bool closed) {
  RodState state = rod(position, closed);
  state.frames = frames_of(quaternion, state.edge_count());
  carry_frames(state);
  return total_twist(state);
}

std::tuple<std::string, std::uint32_t, Index> knot(const Positions& position, bool closed) {
  const Points nodes = nodes_of(position, closed);
  const KnotType found = knot_type(closed ? nodes : closed_outside(nodes));
  return {found.name, found.determinant, found.crossings};
}

std::map<std::string, double> coils(const Positions& position, const Vec3& feed, int threads) {
  if (!feed.allFinite() || feed.isZero(0)) {
    throw InvalidInput("feed: must be three finite numbers, not all 0");
  }
  const Threads shared(threads);
  const CoilReport found = coil_report(rod(position), feed.normalized());
  return {{"axis_order", found.axis_order},
          {"feed_alignment", found.feed_alignment},
          {"reversals", found.reversals},
          {"writhe", found.writhe},
          {"average_crossings", found.average_crossing_number}};
}

std::map<std::string, double> spacing(const Positions& position) {
  const StrandSpacing found = strand_spacing(rod(position));
  return {{"spacing", found.mean},
          {"spacing_across", found.across},
          {"pairs", found.pairs},
          {"hexagonal_order", found.hexagonal_order},
          {"ordered", found.ordered}};
}

Eigen::MatrixXd density(const Positions& position, double wire_radius, double cavity_radius,
                        Index shells) {
  require_positive(wire_radius, "wire_radius");
  require_positive(cavity_radius, "cavity_radius");
  require_positive(static_cast<double>(shells), "shells");
  Eigen::MatrixXd table(3, shells);
  Index k = 0;
  for (const ShellDensity& s : radial_density(rod(position), wire_radius, cavity_radius, shells)) {
    table.col(k++) << s.inner, s.outer, s.density;
  }
  return table;
}

Eigen::MatrixXd order(const Positions& position, double cavity_radius, double width) {
  require_positive(cavity_radius, "cavity_radius");
  require_positive(width, "width");
  const std::vector<ShellOrder> found = order_by_shell(rod(position), {cavity_radius}, width);
  Eigen::MatrixXd table(4, found.size());
  Index k = 0;
  for (const ShellOrder& s : found) {
    table.col(k++) << s.inner, s.outer, static_cast<double>(s.edges), s.order;
  }
  return table;
}

Eigen::VectorXd vector(const std::vector<double>& values) {
  return Eigen::VectorXd::Map(values.data(), static_cast<Index>(values.size()));
}

}  // namespace

void add_observables(py::module_& module) {
  const auto add = [&](const char* name, auto function, auto... arguments) {
    module.def(name, function, "position"_a, arguments..., py::call_guard<Computing>());
  };
  const auto open = "closed"_a = false;
  const auto one = "threads"_a = 1;
  add("writhe", writhe_of, open, one, "Writhe of a polygon. Costs N^2.");
  add("average_crossings", average_crossings, open, one,
      "Crossings of a polygon that are seen, mean over all directions. Costs N^2.");
  add("twist", twist, "quaternion"_a, open,
      "Twist of all joints in turns, from the frames of the edges (scalar first).");
  add("knot_type", knot, open,
      "(name, determinant, crossings left) of a polygon's knot; an open one is closed far "
      "outside.");
  add("coils", coils, "feed"_a = Vec3(0, 0, 1), one,
      "axis_order, feed_alignment and reversals of the coils of a wire fed along `feed`, its "
      "writhe and average_crossings. Costs N^2.");
  add(
      "coil_axes", [](const Positions& r) -> Positions { return coil_axes(rod(r)).transpose(); },
      "Unit axes of the turns (M x 3).");
  add(
      "tangent_order",
      [](const Positions& r) { return axial_order(edge_tangents(rod(r))).order(); },
      "Nematic order of the tangents: 1 parallel, 0 isotropic.");
  add(
      "local_curvatures", [](const Positions& r) { return vector(local_curvatures(rod(r))); },
      "Curvature at the inner nodes (N - 2) [1 / length].");
  add(
      "loop_lengths", [](const Positions& r) { return vector(loop_lengths(rod(r))); },
      "Lengths along which the wire turns by 2 pi, one after the other from the tip on.");
  add("strand_spacing", spacing,
      "spacing and spacing_across of neighbouring strands, means over `pairs`, and their "
      "hexagonal_order, over `ordered` strands.");
  add("radial_density", density, "wire_radius"_a, "cavity_radius"_a, "shells"_a,
      "Part of spherical shells of equal width that is wire: rows inner, outer, density.");
  add("order_by_shell", order, "cavity_radius"_a, "width"_a,
      "Nematic order of the tangents in shells along the wall of a sphere, the outermost first: "
      "rows inner, outer, edges, order.");
}

}  // namespace wirepack
