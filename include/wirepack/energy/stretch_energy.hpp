#pragma once

#include <string_view>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Axial springs: sum over edges of YA l / 2 (x - 1)^2, x = |e| / l (Stoop et al. 2011, Eq. 1,
/// first term).
///
/// An edge that is pressed to less than half its length, which the paper's springs let vanish at a
/// finite force, resists more: YA l (1/2 - x)^3 / x is added below x = 1/2, so that no edge
/// collapses.
class StretchEnergy {
 public:
  static constexpr std::string_view name = "stretch";
  explicit StretchEnergy(const RodParams& params);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;

 private:
  RodParams params_;
  double stiffness_;
};

}  // namespace wirepack
