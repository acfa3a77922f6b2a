#include "wirepack/dynamics/inertia.hpp"

#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

// of a round cross-section about its axis
double spin_per_length(const Inertia& inertia, const RodParams& p) {
  return inertia.mass_per_length(p) * p.radius * p.radius / 2;
}

// The inverse, where the coordinate is not held.
double changed_inverse(double inverse_before, double inertia) {
  return inverse_before != 0 ? 1 / inertia : 0.0;
}

}  // namespace

Inertia lumped_inertia(const RodState& rod, const RodParams& params, double density,
                       const HeldUnknowns& held) {
  const Index n = rod.node_count();
  const Index edges = rod.edge_count();
  const auto frames = static_cast<Index>(rod.frames.size());
  Inertia inertia{density, Eigen::VectorXd(n), Eigen::VectorXd(frames), Eigen::VectorXd(3 * n),
                  Eigen::VectorXd(frames)};
  for (Index i = 0; i < n; ++i) {
    inertia.mass[i] = inertia.mass_per_length(params) * node_length(rod, params, i);
    for (Index c = 3 * i; c < 3 * i + 3; ++c) {
      inertia.inverse_mass[c] =
          held.coordinate[static_cast<std::size_t>(c)] ? 0.0 : 1 / inertia.mass[i];
    }
  }
  for (Index j = 0; j < frames; ++j) {
    const double length = j < edges ? rest_length(rod, params, j) : params.edge_length / 2;
    inertia.spin[j] = spin_per_length(inertia, params) * length;
    inertia.inverse_spin[j] = held.angle[static_cast<std::size_t>(j)] ? 0.0 : 1 / inertia.spin[j];
  }
  return inertia;
}

void update_inlet(Inertia& inertia, const RodState& rod, const RodParams& params) {
  const Index inlet = rod.edge_count() - 1;
  for (const Index i : {inlet, next_node(rod, inlet)}) {
    inertia.mass[i] = inertia.mass_per_length(params) * node_length(rod, params, i);
    for (Index c = 3 * i; c < 3 * i + 3; ++c) {
      inertia.inverse_mass[c] = changed_inverse(inertia.inverse_mass[c], inertia.mass[i]);
    }
  }
  inertia.spin[inlet] = spin_per_length(inertia, params) * rod.inlet_rest_length;
  inertia.inverse_spin[inlet] = changed_inverse(inertia.inverse_spin[inlet], inertia.spin[inlet]);
}

double kinetic_energy(const DynamicState& state, const Inertia& inertia) {
  double energy = 0;
  for (Index i = 0; i < inertia.mass.size(); ++i) {
    energy += inertia.mass[i] / 2 * state.velocity(i).squaredNorm();
  }
  for (Index j = 0; j < inertia.spin.size(); ++j) {
    energy += inertia.spin[j] / 2 * state.spin_rate(j) * state.spin_rate(j);
  }
  return energy;
}

Vec3 linear_momentum(const DynamicState& state, const Inertia& inertia) {
  Vec3 sum = Vec3::Zero();
  for (Index i = 0; i < inertia.mass.size(); ++i) sum += inertia.mass[i] * state.velocity(i);
  return sum;
}

Vec3 angular_momentum(const DynamicState& state, const Inertia& inertia) {
  Vec3 sum = Vec3::Zero();
  for (Index i = 0; i < inertia.mass.size(); ++i) {
    sum += inertia.mass[i] * state.rod.nodes.col(i).cross(state.velocity(i));
  }
  for (Index j = 0; j < inertia.spin.size(); ++j) {
    sum += inertia.spin[j] * state.spin_rate(j) *
           third_axis(state.rod.frames[static_cast<std::size_t>(j)]);
  }
  return sum;
}

}  // namespace wirepack
