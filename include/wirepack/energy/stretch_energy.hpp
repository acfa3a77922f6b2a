#pragma once

#include <string_view>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Axial springs: sum over edges of YA l / 2 (|e| / l - 1)^2 (Stoop et al. 2011, Eq. 1, first term).
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
