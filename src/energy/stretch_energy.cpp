#include "wirepack/energy/stretch_energy.hpp"

#include <array>
#include <cmath>

#include "wirepack/core/lanes.hpp"

namespace wirepack {

StretchEnergy::StretchEnergy(const RodParams& params)
    : params_(params), stiffness_(stiffness(params).stretch) {}

namespace {

template <class T>
struct Spring {
  T strain, energy;
  Triple<T> tension;
};

template <class T>
Spring<T> spring(const Triple<T>& edge, double rest, double stiffness) {
  using std::sqrt;
  const T length = sqrt(dot(edge, edge));
  const T strain = length / rest - 1.0;
  return {strain, 0.5 * stiffness * rest * strain * strain, (stiffness * strain / length) * edge};
}

}  // namespace

Energy StretchEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  EnergySum energy;
  const Index last = state.edge_count() - 1;
  Points by_edge(3, last + 1);
  const auto add = [&]<class T>(Index j, const Spring<T>& s) {
    energy.add(s.energy);
    store_columns(s.tension, by_edge, j);
  };
  for_each_in_lanes(0, last, [&]<class T>(Index j) {
    const Triple<T> edge = load_columns<T>(state.nodes, j + 1) - load_columns<T>(state.nodes, j);
    add(j, spring(edge, params_.edge_length, stiffness_));
  });
  const Vec3 edge = state.nodes.col(next_node(state, last)) - state.nodes.col(last);
  const Spring<double> s = spring(triple(edge), rest_length(state, params_, last), stiffness_);
  add(last, s);
  if (!state.ends.closed) gradient.inlet_length -= stiffness_ * s.strain * (1 + s.strain / 2);
  add_by_edges(state, by_edge, gradient.node);
  return energy.total();
}

void StretchEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  const double exactness = model.exactness();
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Index next = next_node(state, j);
    const Vec3 edge = state.nodes.col(next) - state.nodes.col(j);
    const double length = edge.norm();
    const Vec3 t = edge / length;
    const double rest = rest_length(state, params_, j);
    const std::array<CurvatureModel::NodePart, 2> parts{{{next, t}, {j, -t}}};
    model.add_square(stiffness_ / rest, parts);
    if (exactness == 0) continue;
    // what is missing: the tension turns with the edge
    const double tension = stiffness_ * (length / rest - 1);
    CurvatureModel::Hessian turning = CurvatureModel::Hessian::Zero(8, 8);
    turning.block<3, 3>(0, 0) = tension / length * (Mat3::Identity() - t * t.transpose());
    turning.block<3, 3>(4, 4) = turning.block<3, 3>(0, 0);
    turning.block<3, 3>(0, 4) = turning.block<3, 3>(4, 0) = -turning.block<3, 3>(0, 0);
    model.add_hessian(exactness, turning, std::array<Index, 2>{j, next});
  }
}

}  // namespace wirepack
