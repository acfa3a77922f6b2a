#pragma once

#include <string>
#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/rod/reference_shape.hpp"

namespace wirepack {

/// Material and mesh of one wire; constant during a run. Any consistent units (the paper: a = 1,
/// Y = 5).
struct RodParams {
  double radius = 1;                 ///< a, of the round cross-section
  double youngs_modulus = 5;         ///< Y [force / length^2]
  double poisson_ratio = 1.0 / 3;    ///< nu; not published, so a choice
  double stretch_multiplier = 1;     ///< scales YA alone; > 1 approaches the inextensible wire
  double edge_length = 1;            ///< rest length l of every edge but the inlet edge
  Vec3 rest_darboux = Vec3::Zero();  ///< (k1, k2, k3) of the stress-free shape [1 / length]
  ReferenceShape reference_shape;    ///< adds a k0 that varies along the wire; may be empty
};

/// Stiffnesses of the Kirchhoff rod (Stoop et al. 2011, Eq. 1).
struct Stiffness {
  double stretch;  ///< YA = Y pi a^2, times the stretch multiplier [force]
  double bend;     ///< YI = Y pi a^4 / 4 [force length^2]
  double twist;    ///< GJ = YI / (1 + nu), J = 2 I [force length^2]; the paper prints G
};

Stiffness stiffness(const RodParams& params);

/// Every impossible value as "key = value: what is allowed"; empty when the parameters are valid.
std::vector<std::string> problems(const RodParams& params);

}  // namespace wirepack
