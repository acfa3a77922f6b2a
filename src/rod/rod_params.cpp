#include "wirepack/rod/rod_params.hpp"

#include "wirepack/core/value_problems.hpp"

namespace wirepack {

Stiffness stiffness(const RodParams& params) {
  const double a = params.radius;
  const double area = pi * a * a;
  const double second_moment = area * a * a / 4;
  const double bend = params.youngs_modulus * second_moment;
  return {params.youngs_modulus * area * params.stretch_multiplier, bend,
          bend / (1 + params.poisson_ratio)};
}

std::vector<std::string> problems(const RodParams& params) {
  std::vector<std::string> found;
  const auto positive = [&](std::string_view key, double value) {
    require(is_positive(value), key, value, must_be_positive, found);
  };
  const auto within = [&](std::string_view key, double value, double largest,
                          std::string_view allowed) {
    require(!is_positive(value) || (value >= 1 / largest && value <= largest), key, value, allowed,
            found);
  };
  positive("wire.radius", params.radius);
  within("wire.radius", params.radius, 1e30, "must be between 1e-30 and 1e30");
  positive("wire.youngs_modulus", params.youngs_modulus);
  within("wire.youngs_modulus", params.youngs_modulus, 1e60, "must be between 1e-60 and 1e60");
  require(params.poisson_ratio > -1 && params.poisson_ratio <= 1e6, "wire.poisson_ratio",
          params.poisson_ratio, "must be above -1 and at most 1e6", found);
  positive("wire.stretch_multiplier", params.stretch_multiplier);
  positive("wire.edge_length", params.edge_length);
  require(params.rest_darboux.allFinite(), "wire.precurvature", params.rest_darboux.norm(),
          "must be finite", found);
  return found;
}

}  // namespace wirepack
