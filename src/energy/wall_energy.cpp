#include "wirepack/energy/wall_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wirepack/contact/wall_point.hpp"
#include "wirepack/core/lane_differences.hpp"
#include "wirepack/core/lanes.hpp"

namespace wirepack {

WallEnergy::WallEnergy(const RodParams& params, const Cavity& cavity, double stiffness)
    : params_(params), cavity_(cavity), stiffness_(stiffness) {}

namespace {

bool is_free_end(const RodState& state, Index node) {
  if (state.ends.closed) return false;
  return (node == 0 && !state.ends.first_clamped) ||
         (node == state.node_count() - 1 && !state.ends.last_clamped);
}

// The other node of a free end's edge.
Index node_inside(const RodState& state, Index end) {
  return end == 0 ? 1 : state.node_count() - 2;
}

// Cosine of the angle between the edge of a free end at r, which starts at `inside`, and the wall's
// normal.
double cosine_at(const Cavity& cavity, const Vec3& r, const Vec3& inside) {
  return (r - inside).normalized().dot(outward_normal(cavity, r));
}

template <class T>
struct EndContact {
  T overlap, energy, by_length;  // by half an edge
  Triple<T> by_end, by_inside;
};

// Energy of a free end: k / 2 (h + (d - h) c^2) overlap^2, h half an edge and d = 2 a.
template <class T, class Shape>
EndContact<T> end_contact(const Triple<T>& r, const Triple<T>& inside, double half_edge,
                          double stiffness, const Shape& shape, double wire_radius) {
  using std::sqrt;
  const WallPoint<T> at = wall_point(shape, r, wire_radius);
  const Triple<T> n = (1.0 / at.length) * at.outward, edge = r - inside;
  const T length = sqrt(dot(edge, edge));
  const Triple<T> t = (1.0 / length) * edge;
  const T c = dot(t, n), overlap = -at.gap;
  const double more = 2 * wire_radius - half_edge;
  const T contact_length = half_edge + more * c * c;
  const T square = 0.5 * stiffness * overlap * overlap, by_cosine = square * 2.0 * more * c;
  const Triple<T> by_edge = (by_cosine / length) * (n - c * t);
  const Triple<T> by_end = (stiffness * contact_length * overlap) * n + by_edge +
                           normal_turning(shape, at, by_cosine, t, n);
  return {overlap, contact_length * square, (1.0 - c * c) * square, by_end, T(-1.0) * by_edge};
}

}  // namespace

Energy WallEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  return with_shape(cavity_,
                    [&](const auto& shape) { return add_gradient(shape, state, gradient); });
}

template <class Shape>
Energy WallEnergy::add_gradient(const Shape& shape, const RodState& state,
                                Gradient& gradient) const {
  EnergySum energy;
  const auto add = [&]<class T>(Index i, double length) {
    const WallPoint<T> at = wall_point(shape, load_columns<T>(state.nodes, i), params_.radius);
    const T overlap = -at.gap;
    const auto touches = overlap > 0.0;
    const T per_length = select(touches, 0.5 * stiffness_ * overlap * overlap, T(0.0));
    const T pull = length * stiffness_ * overlap / at.length;
    energy.add(T(length * per_length));
    store_columns(load_columns<T>(gradient.node, i) + select(touches, pull, T(0.0)) * at.outward,
                  gradient.node, i);
    return per_length;
  };
  const auto add_end = [&](Index i) {
    if (!is_free_end(state, i)) {
      const double per_length = add.template operator()<double>(i, node_length(state, params_, i));
      gradient.inlet_length += node_length_by_inlet(state, i) * per_length;
      return;
    }
    const Index inside = node_inside(state, i);
    const auto contact =
        end_contact(load_columns<double>(state.nodes, i), load_columns<double>(state.nodes, inside),
                    node_length(state, params_, i), stiffness_, shape, params_.radius);
    if (contact.overlap <= 0) return;
    energy.add(contact.energy);
    gradient.node.col(i) += vec3(contact.by_end);
    gradient.node.col(inside) += vec3(contact.by_inside);
    gradient.inlet_length += node_length_by_inlet(state, i) * contact.by_length;
  };
  const Index last = state.node_count() - 1;
  add_end(0);
  for_each_in_lanes(1, last - 1,
                    [&]<class T>(Index i) { add.template operator()<T>(i, params_.edge_length); });
  for (Index i = std::max<Index>(1, last - 1); i <= last; ++i) add_end(i);
  return energy.total();
}

double WallEnergy::stiffness(const RodState& state, Index node) const {
  const double length = node_length(state, params_, node);
  if (!is_free_end(state, node)) return stiffness_ * length;
  const double c =
      cosine_at(cavity_, state.nodes.col(node), state.nodes.col(node_inside(state, node)));
  return stiffness_ * (length + (2 * params_.radius - length) * c * c);
}

void WallEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  // An end that leans turns its contact's stiffness: by differences of its gradient, over the
  // radius.
  const auto add_end = [&](Index i) {
    const Index inside = node_inside(state, i);
    const Vec3 r = state.nodes.col(i), from = state.nodes.col(inside);
    const double length = node_length(state, params_, i), unit = params_.radius;
    const auto gradient = [&](const std::array<Lanes, 6>& x) -> std::array<Lanes, 6> {
      const auto contact = with_shape(cavity_, [&](const auto& shape) {
        return end_contact<Lanes>({x[0] * unit, x[1] * unit, x[2] * unit},
                                  {x[3] * unit, x[4] * unit, x[5] * unit}, length, stiffness_,
                                  shape, unit);
      });
      const auto &g = contact.by_end, &h = contact.by_inside;
      return {g.x, g.y, g.z, h.x, h.y, h.z};
    };
    const Eigen::Matrix<double, 6, 6> by_nodes =
        second_derivative<6>({r.x() / unit, r.y() / unit, r.z() / unit, from.x() / unit,
                              from.y() / unit, from.z() / unit},
                             1e-5, gradient) /
        unit;
    CurvatureModel::Hessian hessian = CurvatureModel::Hessian::Zero(8, 8);
    for (Index p = 0; p < 2; ++p) {
      for (Index q = 0; q < 2; ++q) {
        hessian.block<3, 3>(4 * p, 4 * q) = by_nodes.block<3, 3>(3 * p, 3 * q);
      }
    }
    model.add_hessian(model.exactness(), hessian, std::array<Index, 2>{i, inside});
  };
  for (Index i = 0; i < state.node_count(); ++i) {
    const Vec3 r = state.nodes.col(i);
    const double overlap = -wall_gap(cavity_, r, params_.radius);
    if (overlap <= -nearly_touching * params_.radius) continue;
    const bool leans = is_free_end(state, i) && overlap > 0;
    const double k = stiffness(state, i) * (leans ? 1 - model.exactness() : 1);
    // exact Hessian: the normal part, and the wall's own curvature times the force
    model.add_node_block(i, contact_hessian(cavity_, r, std::max(0.0, overlap), k));
    if (leans && model.exactness() > 0) add_end(i);
  }
}

Eigen::VectorXd WallEnergy::forces(const RodState& state) const {
  Eigen::VectorXd result(state.node_count());
  for (Index i = 0; i < state.node_count(); ++i) {
    const double overlap = -wall_gap(cavity_, state.nodes.col(i), params_.radius);
    result[i] = overlap > 0 ? stiffness(state, i) * overlap : 0;
  }
  return result;
}

}  // namespace wirepack
