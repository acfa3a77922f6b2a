#include "wirepack/energy/self_contact_energy.hpp"

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "wirepack/core/threads.hpp"

namespace wirepack {

SelfContactEnergy::SelfContactEnergy(const RodParams& params, const ContactParams& contact)
    : range_{2 * params.radius, params.edge_length, contact.excluded_arc_length},
      kernel_(LineKernel::per_length(contact.stiffness, params.radius, params.edge_length)),
      skin_(params.radius) {}

bool SelfContactEnergy::prepare(const RodState& state) {
  // the model of the Hessian also has contacts that nearly touch
  const double margin = nearly_touching * kernel_.touching_distance / 2;
  if (list_.covers(state, margin)) return false;
  std::swap(list_, list_before_);
  if (list_.covers(state, margin)) return false;
  list_ = NeighborList(state, range_, skin_);
  return true;
}

Energy SelfContactEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  return add_contact_energy(kernel_, state, list_.fours(), gradient.node);
}

Energy SelfContactEnergy::add_gradient(const RodState& state, Gradient& gradient,
                                       std::vector<SelfContact>& contacts) const {
  return add_contact_energy(kernel_, state, list_.fours(), gradient.node, contacts);
}

namespace {

using ByLines = Eigen::Matrix<double, 9, 9>;  // the vector w between midpoints, both edge vectors

// The same second derivative by the four nodes of both edges.
CurvatureModel::Hessian by_nodes(const ByLines& by_lines) {
  // A node moves its midpoint by a half and its edge by all of its own move.
  static constexpr std::array<double, 4> on_w{0.5, 0.5, -0.5, -0.5}, on_edge{-1, 1, -1, 1};
  const auto by_rows = [&](Index node) -> Eigen::Matrix<double, 3, 9> {
    const auto n = static_cast<std::size_t>(node);
    return on_w[n] * by_lines.middleRows<3>(0) +
           on_edge[n] * by_lines.middleRows<3>(node < 2 ? 3 : 6);
  };
  CurvatureModel::Hessian result(16, 16);
  result.setZero();
  for (Index p = 0; p < 4; ++p) {
    const Eigen::Matrix<double, 3, 9> rows = by_rows(p);
    for (Index q = 0; q < 4; ++q) {
      const auto n = static_cast<std::size_t>(q);
      result.block<3, 3>(4 * p, 4 * q) =
          on_w[n] * rows.middleCols<3>(0) + on_edge[n] * rows.middleCols<3>(q < 2 ? 3 : 6);
    }
  }
  return result;
}

}  // namespace

void SelfContactEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  // The gradient is not used. Still this is faster than finding contacts one pair at a time.
  Points unused = Points::Zero(3, state.node_count());
  std::vector<SelfContact> touching;
  LineKernel wide = kernel_;
  wide.touching_distance += nearly_touching * kernel_.touching_distance / 2;
  add_contact_energy(wide, state, list_.fours(), unused, touching);
  // Second derivatives of a gap are no model of a contact to come: they would have its parts in the
  // overlap, which is below zero.
  const auto exactness_of = [&](const SelfContact& touch) {
    if (touch.line.distance >= kernel_.touching_distance) return 0.0;
    const auto ends = [&](Index edge) {
      const Line line = line_of(state, edge);
      return line.ends_before || line.ends_after;
    };
    return ends(touch.edges.first) || ends(touch.edges.second) ? 0 : model.exactness();
  };
  const auto add = [&](const SelfContact& touch, const ByLines& second_derivative) {
    const auto [i, j] = touch.edges;
    const double exactness = exactness_of(touch);
    const Vec3 n = touch.line.separation / touch.line.distance;
    const double s = touch.line.s;
    const double t = touch.line.t;
    const std::array<Index, 4> nodes{i, next_node(state, i), j, next_node(state, j)};
    const std::array<CurvatureModel::NodePart, 4> parts{{{nodes[0], (0.5 - s) * n},
                                                         {nodes[1], (0.5 + s) * n},
                                                         {nodes[2], (t - 0.5) * n},
                                                         {nodes[3], (-t - 0.5) * n}}};
    model.add_square((1 - exactness) * touch.line.stiffness, parts);
    if (exactness > 0) model.add_hessian(exactness, by_nodes(second_derivative), nodes);
  };
  // Threads share the derivatives of about a thousand contacts, which are then added in order.
  constexpr Index at_a_time = 1024, tile = 64;
  std::vector<ByLines> second_derivatives(at_a_time);
  for_each_tile(
      static_cast<Index>(touching.size()), at_a_time, false, [&](Index first, Index last) {
        const auto part = std::span(touching).subspan(static_cast<std::size_t>(first),
                                                      static_cast<std::size_t>(last - first));
        for_each_tile(last - first, tile, true, [&](Index start, Index end) {
          for (auto k = static_cast<std::size_t>(start); k < static_cast<std::size_t>(end); ++k) {
            if (exactness_of(part[k]) == 0) continue;
            const auto [i, j] = part[k].edges;
            second_derivatives[k] = kernel_.second_derivative(line_of(state, i), line_of(state, j));
          }
        });
        for (std::size_t k = 0; k < part.size(); ++k) add(part[k], second_derivatives[k]);
      });
}

std::vector<SelfContact> SelfContactEnergy::contacts(const RodState& state) const {
  std::vector<SelfContact> found;
  for_each_pair(list_.fours(), [&](const EdgePair& pair) {
    const auto touch = kernel_.touch(line_of(state, pair.first), line_of(state, pair.second));
    if (!touch) return;
    const double overlap = kernel_.touching_distance - touch->distance;
    found.push_back({pair, *touch, overlap, touch->stiffness * overlap});
  });
  return found;
}

}  // namespace wirepack
