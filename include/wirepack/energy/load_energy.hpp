#pragma once

#include <string_view>
#include <vector>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Constant force on a node: -F.r.
struct NodeForce {
  Index node;
  Vec3 force;
};

/// Moment M on an edge about a fixed unit axis: -M angle, where angle is the twist of the rotation
/// since `reference` about that axis. Conservative; it is the moment M about the axis wherever the
/// edge has turned about that axis alone. The angle is taken within pi of `angle_guide`, so that a
/// load can be followed over whole turns.
struct EdgeMoment {
  Index edge;
  Vec3 axis;
  double moment;
  Quat reference;
  double angle_guide = 0;

  double angle(const RodState& state) const;
};

/// Dead loads: forces, moments and a weight per rest length w acting along a direction.
struct Loads {
  std::vector<NodeForce> forces;
  std::vector<EdgeMoment> moments;
  Vec3 weight = Vec3::Zero();  ///< force per rest length
};

/// Potential energy of loads: -sum F.r - sum M angle - sum l w.r, l the node length.
class LoadEnergy {
 public:
  static constexpr std::string_view name = "load";
  LoadEnergy(const RodParams& params, Loads loads);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState&, CurvatureModel&) const {}  // linear, but for the moments

 private:
  RodParams params_;
  Loads loads_;
};

}  // namespace wirepack
