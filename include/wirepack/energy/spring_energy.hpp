#pragma once

#include <string_view>
#include <vector>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Spring of rest length 0 between a node and a point in space. Points that are moved between two
/// equilibria, with stiff springs, prescribe a motion.
struct PointSpring {
  Index node;
  Vec3 point;
  double stiffness;  ///< [force / length]

  /// Of the spring on the node.
  Vec3 force(const RodState& state) const { return stiffness * (point - state.nodes.col(node)); }
};

/// Sum of k / 2 |r - p|^2.
class SpringEnergy {
 public:
  static constexpr std::string_view name = "spring";
  explicit SpringEnergy(std::vector<PointSpring> springs);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;

 private:
  std::vector<PointSpring> springs_;
};

}  // namespace wirepack
