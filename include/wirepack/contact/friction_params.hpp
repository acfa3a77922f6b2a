#pragma once

#include <string>
#include <vector>

namespace wirepack {

enum class FrictionModel { none, coulomb };

/// Dry friction between strands and with the wall.
struct FrictionParams {
  FrictionModel model = FrictionModel::none;
  double static_coefficient = 0.2;    ///< mu_s (Stoop et al. 2011)
  double dynamic_coefficient = 0.18;  ///< mu_d <= mu_s (Stoop et al. 2011)
  double slip_tolerance = 0.01;  ///< over the wire radius: surfaces that stick give way by this
                                 ///< much before they carry all they can; not published
};

/// Every impossible value as "key = value: what is allowed"; empty when the parameters are valid.
std::vector<std::string> problems(const FrictionParams& params);

}  // namespace wirepack
