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

void SelfContactEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  // The gradient that comes along costs less than one pair at a time would.
  Points unused = Points::Zero(3, state.node_count());
  std::vector<SelfContact> touching;
  add_contact_energy(kernel_, state, list_.fours(), unused, touching);
  for (const SelfContact& touch : touching) {
    const Vec3 n = touch.line.separation / touch.line.distance;
    const double s = touch.line.s;
    const double t = touch.line.t;
    const auto [i, j] = touch.edges;
    const std::array<CurvatureModel::NodePart, 4> parts{{{i, (0.5 - s) * n},
                                                         {next_node(state, i), (0.5 + s) * n},
                                                         {j, (t - 0.5) * n},
                                                         {next_node(state, j), (-t - 0.5) * n}}};
    model.add_square(touch.line.stiffness, parts);
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
