#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// The wire is on the side that the unit normal points to.
struct PlaneWall {
  Vec3 point, normal;
};
/// The wire is inside of a tube without ends, about a line along a unit axis.
struct CylinderWall {
  Vec3 point, axis;
  double radius;
};
using OpenWall = std::variant<PlaneWall, CylinderWall>;

/// Walls beside or in a cavity, each with a linear repulsion of its own: sum over nodes of k l / 2
/// overlap^2, l the node length (see WallEnergy for k), overlap = a - distance of the node from the
/// wall.
class OpenWallEnergy {
 public:
  static constexpr std::string_view name = "open wall";
  /// Throws InvalidInput for a normal or axis that is no unit vector, or a cylinder too narrow for
  /// the wire.
  OpenWallEnergy(const RodParams& params, std::vector<OpenWall> walls, double stiffness);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;

 private:
  RodParams params_;
  std::vector<OpenWall> walls_;
  double stiffness_;
};

}  // namespace wirepack
