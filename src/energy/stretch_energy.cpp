#include "wirepack/energy/stretch_energy.hpp"

#include <array>
#include <cmath>

#include "wirepack/core/lanes.hpp"

namespace wirepack {

StretchEnergy::StretchEnergy(const RodParams& params)
    : params_(params), stiffness_(stiffness(params).stretch) {}

namespace {

// Below this part of its rest length an edge resists ever more.
constexpr double half_length = 0.5;

// Energy per EA and rest length, and its derivatives, at a length of `ratio` times the rest length.
template <class T>
struct AxialLaw {
  T energy, slope, curvature;
};

template <class T>
AxialLaw<T> axial_law(const T& ratio) {
  const T strain = ratio - 1.0;
  const T missing = select(ratio < half_length, half_length - ratio, T(0.0));
  const T share = missing / ratio;
  return {0.5 * strain * strain + missing * missing * share,
          strain - (3.0 + share) * missing * share,
          1.0 + (6.0 + (6.0 + 2.0 * share) * share) * share};
}

template <class T>
struct Spring {
  T ratio;
  AxialLaw<T> law;
  Triple<T> tension;
};

template <class T>
Spring<T> spring(const Triple<T>& edge, double rest, double stiffness) {
  using std::sqrt;
  const T length = sqrt(dot(edge, edge));
  const T ratio = length / rest;
  const AxialLaw<T> law = axial_law<T>(ratio);
  return {ratio, law, (stiffness * law.slope / length) * edge};
}

}  // namespace

Energy StretchEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  EnergySum energy;
  const Index last = state.edge_count() - 1;
  Points by_edge(3, last + 1);
  const auto add = [&]<class T>(Index j, const Spring<T>& s, double rest) {
    energy.add(T(stiffness_ * rest * s.law.energy));
    store_columns(s.tension, by_edge, j);
  };
  for_each_in_lanes(0, last, [&]<class T>(Index j) {
    const Triple<T> edge = load_columns<T>(state.nodes, j + 1) - load_columns<T>(state.nodes, j);
    add(j, spring(edge, params_.edge_length, stiffness_), params_.edge_length);
  });
  const Vec3 edge = state.nodes.col(next_node(state, last)) - state.nodes.col(last);
  const double rest = rest_length(state, params_, last);
  const Spring<double> s = spring(triple(edge), rest, stiffness_);
  add(last, s, rest);
  gradient.inlet_length += stiffness_ * (s.law.energy - s.ratio * s.law.slope);
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
    const AxialLaw<double> law = axial_law(length / rest);
    model.add_square(stiffness_ * law.curvature / rest, parts);
    if (exactness == 0) continue;
    // what is missing: the tension turns with the edge
    const double tension = stiffness_ * law.slope;
    CurvatureModel::Hessian turning = CurvatureModel::Hessian::Zero(8, 8);
    turning.block<3, 3>(0, 0) = tension / length * (Mat3::Identity() - t * t.transpose());
    turning.block<3, 3>(4, 4) = turning.block<3, 3>(0, 0);
    turning.block<3, 3>(0, 4) = turning.block<3, 3>(4, 0) = -turning.block<3, 3>(0, 0);
    model.add_hessian(exactness, turning, std::array<Index, 2>{j, next});
  }
}

}  // namespace wirepack
