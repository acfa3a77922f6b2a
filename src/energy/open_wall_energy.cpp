#include "wirepack/energy/open_wall_energy.hpp"

#include <cmath>
#include <utility>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

// Distance of a point from a wall, and its derivatives.
struct WallDistance {
  double distance;
  Vec3 inward;   // gradient
  Mat3 hessian;  // negative semidefinite inside a tube
};

WallDistance distance_from(const PlaneWall& wall, const Vec3& r) {
  return {wall.normal.dot(r - wall.point), wall.normal, Mat3::Zero()};
}

WallDistance distance_from(const CylinderWall& wall, const Vec3& r) {
  const Mat3 across = Mat3::Identity() - wall.axis * wall.axis.transpose();
  const Vec3 out = across * (r - wall.point);
  const double off = out.norm();
  if (!(off > 0)) return {wall.radius, Vec3::Zero(), Mat3::Zero()};
  const Vec3 inward = -out / off;
  return {wall.radius - off, inward, -(across - inward * inward.transpose()) / off};
}

void check(const PlaneWall& wall, double) {
  if (!(std::abs(wall.normal.norm() - 1) < 1e-12)) {
    throw InvalidInput("the normal of a plane wall must be a unit vector");
  }
}

void check(const CylinderWall& wall, double wire_radius) {
  if (!(std::abs(wall.axis.norm() - 1) < 1e-12)) {
    throw InvalidInput("the axis of a cylinder must be a unit vector");
  }
  if (!(wall.radius > wire_radius)) {
    throw InvalidInput("the radius of a cylinder must be above that of the wire");
  }
}

// Calls f(node, overlap, distance) where the wire overlaps with a wall.
template <class F>
void for_each_overlap(const RodState& state, double wire_radius, const std::vector<OpenWall>& walls,
                      F&& f) {
  for (const OpenWall& wall : walls) {
    for (Index i = 0; i < state.node_count(); ++i) {
      const WallDistance from = std::visit(
          [&](const auto& kind) { return distance_from(kind, state.nodes.col(i)); }, wall);
      const double overlap = wire_radius - from.distance;
      if (overlap > 0) f(i, overlap, from);
    }
  }
}

}  // namespace

OpenWallEnergy::OpenWallEnergy(const RodParams& params, std::vector<OpenWall> walls,
                               double stiffness)
    : params_(params), walls_(std::move(walls)), stiffness_(stiffness) {
  for (const OpenWall& wall : walls_) {
    std::visit([&](const auto& kind) { check(kind, params_.radius); }, wall);
  }
}

Energy OpenWallEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  EnergySum energy;
  for_each_overlap(state, params_.radius, walls_,
                   [&](Index i, double overlap, const WallDistance& from) {
                     const double length = node_length(state, params_, i);
                     const double per_length = stiffness_ / 2 * overlap * overlap;
                     energy.add(length * per_length);
                     gradient.node.col(i) -= length * stiffness_ * overlap * from.inward;
                     gradient.inlet_length += node_length_by_inlet(state, i) * per_length;
                   });
  return energy.total();
}

// The curved wall adds a positive part: the overlap grows to all sides.
void OpenWallEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  for_each_overlap(
      state, params_.radius, walls_, [&](Index i, double overlap, const WallDistance& from) {
        const Mat3 by_overlap = from.inward * from.inward.transpose() - overlap * from.hessian;
        model.add_node_block(i, stiffness_ * node_length(state, params_, i) * by_overlap);
      });
}

}  // namespace wirepack
