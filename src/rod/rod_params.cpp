#include "wirepack/rod/rod_params.hpp"

#include <cmath>
#include <sstream>

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
  const auto require = [&](bool ok, const char* key, double value, const char* allowed) {
    if (ok) return;
    std::ostringstream text;
    text << key << " = " << value << ": " << allowed;
    found.push_back(text.str());
  };
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  require(positive(params.radius), "wire.radius", params.radius, "must be positive and finite");
  require(!positive(params.radius) || (params.radius >= 1e-30 && params.radius <= 1e30),
          "wire.radius", params.radius, "must be between 1e-30 and 1e30");
  require(positive(params.youngs_modulus), "wire.youngs_modulus", params.youngs_modulus,
          "must be positive and finite");
  require(!positive(params.youngs_modulus) ||
              (params.youngs_modulus >= 1e-60 && params.youngs_modulus <= 1e60),
          "wire.youngs_modulus", params.youngs_modulus, "must be between 1e-60 and 1e60");
  require(params.poisson_ratio > -1 && params.poisson_ratio <= 1e6, "wire.poisson_ratio",
          params.poisson_ratio, "must be above -1 and at most 1e6");
  require(positive(params.stretch_multiplier), "wire.stretch_multiplier", params.stretch_multiplier,
          "must be positive and finite");
  require(positive(params.edge_length), "wire.edge_length", params.edge_length,
          "must be positive and finite");
  require(params.rest_darboux.allFinite(), "wire.precurvature", params.rest_darboux.norm(),
          "must be finite");
  return found;
}

}  // namespace wirepack
