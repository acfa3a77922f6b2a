#include "wirepack/energy/self_contact_energy.hpp"

#include <array>

namespace wirepack {

namespace {

Line line_of(const RodState& state, Index edge) {
  const Vec3 a = state.nodes.col(edge);
  const Vec3 b = state.nodes.col(next_node(state, edge));
  const bool open = !state.ends.closed;
  return {(a + b) / 2, b - a, open && edge == 0, open && edge == state.edge_count() - 1};
}

}  // namespace

SelfContactEnergy::SelfContactEnergy(const RodParams& params, const ContactParams& contact)
    : range_{2 * params.radius, params.edge_length, contact.excluded_arc_length},
      kernel_(LineKernel::per_length(contact.stiffness, params.radius, params.edge_length)),
      skin_(params.radius) {}

void SelfContactEnergy::prepare(const RodState& state) {
  if (!list_.covers(state)) list_ = NeighborList(state, range_, skin_);
}

double SelfContactEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  double energy = 0;
  LineGradient by_line;
  for (const EdgePair& pair : list_.pairs()) {
    const double e =
        kernel_.energy(line_of(state, pair.first), line_of(state, pair.second), by_line);
    if (e == 0) continue;
    energy += e;
    gradient.node.col(pair.first) += by_line.midpoint1 / 2 - by_line.vector1;
    gradient.node.col(next_node(state, pair.first)) += by_line.midpoint1 / 2 + by_line.vector1;
    gradient.node.col(pair.second) += by_line.midpoint2 / 2 - by_line.vector2;
    gradient.node.col(next_node(state, pair.second)) += by_line.midpoint2 / 2 + by_line.vector2;
  }
  return energy;
}

void SelfContactEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  for (const SelfContact& touch : contacts(state)) {
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
  for (const EdgePair& pair : list_.pairs()) {
    const auto touch = kernel_.touch(line_of(state, pair.first), line_of(state, pair.second));
    if (!touch) continue;
    const double overlap = kernel_.touching_distance - touch->distance;
    found.push_back({pair, *touch, overlap, touch->stiffness * overlap});
  }
  return found;
}

}  // namespace wirepack
