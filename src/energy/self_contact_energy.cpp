#include "wirepack/energy/self_contact_energy.hpp"

#include <array>

namespace wirepack {

SelfContactEnergy::SelfContactEnergy(const RodParams& params, const ContactParams& contact)
    : range_{2 * params.radius, params.edge_length, contact.excluded_arc_length},
      kernel_(LineKernel::per_length(contact.stiffness, params.radius, params.edge_length)),
      skin_(params.radius) {}

bool SelfContactEnergy::prepare(const RodState& state) {
  if (list_.covers(state)) return false;
  list_ = NeighborList(state, range_, skin_);
  return true;
}

double SelfContactEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  return add_contact_energy(kernel_, state, list_.fours(), gradient.node);
}

double SelfContactEnergy::add_gradient(const RodState& state, Gradient& gradient,
                                       std::vector<SelfContact>& contacts) const {
  return add_contact_energy(kernel_, state, list_.fours(), gradient.node, contacts);
}

namespace {

// By four nodes, from the derivative by the vector w between midpoints and by both edge vectors.
CurvatureModel::Hessian by_nodes(const Eigen::Matrix<double, 9, 9>& by_lines) {
  // of each node, what it adds to w, e1 and e2
  static constexpr std::array<std::array<double, 3>, 4> share{
      {{0.5, -1, 0}, {0.5, 1, 0}, {-0.5, 0, -1}, {-0.5, 0, 1}}};
  CurvatureModel::Hessian result = CurvatureModel::Hessian::Zero(16, 16);
  for (Index p = 0; p < 4; ++p) {
    for (Index q = 0; q < 4; ++q) {
      for (Index i = 0; i < 3; ++i) {
        for (Index j = 0; j < 3; ++j) {
          const double weight = share[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)] *
                                share[static_cast<std::size_t>(q)][static_cast<std::size_t>(j)];
          if (weight == 0) continue;
          result.block<3, 3>(4 * p, 4 * q) += weight * by_lines.block<3, 3>(3 * i, 3 * j);
        }
      }
    }
  }
  return result;
}

}  // namespace

void SelfContactEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  // The gradient that comes along costs less than one pair at a time would.
  Points unused = Points::Zero(3, state.node_count());
  std::vector<SelfContact> touching;
  LineKernel wide = kernel_;
  wide.touching_distance += nearly_touching * kernel_.touching_distance / 2;
  add_contact_energy(wide, state, list_.fours(), unused, touching);
  for (const SelfContact& touch : touching) {
    const auto [i, j] = touch.edges;
    const Line first = line_of(state, i), second = line_of(state, j);
    const bool at_an_end =
        first.ends_before || first.ends_after || second.ends_before || second.ends_after;
    const double exactness = at_an_end ? 0 : model.exactness();
    const Vec3 n = touch.line.separation / touch.line.distance;
    const double s = touch.line.s;
    const double t = touch.line.t;
    const std::array<Index, 4> nodes{i, next_node(state, i), j, next_node(state, j)};
    const std::array<CurvatureModel::NodePart, 4> parts{{{nodes[0], (0.5 - s) * n},
                                                         {nodes[1], (0.5 + s) * n},
                                                         {nodes[2], (t - 0.5) * n},
                                                         {nodes[3], (-t - 0.5) * n}}};
    model.add_square((1 - exactness) * touch.line.stiffness, parts);
    if (exactness == 0) continue;
    model.add_hessian(exactness, by_nodes(kernel_.second_derivative(first, second)), nodes);
  }
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
