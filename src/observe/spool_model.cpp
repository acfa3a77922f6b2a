#include "wirepack/observe/spool_model.hpp"

#include <cmath>
#include <string>

#include "wirepack/core/error.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

namespace {

// x = sqrt(k) phi^(1/3) with k = (3 d_s^4 / (4 pi^2 a^4))^(1/3), i.e. x^3 = phi / phi_largest.
double filling(const SpoolModel& spool, double density) {
  const double largest = spool.largest_density();
  if (!(density >= 0 && density < largest)) {
    throw InvalidInput("density = " + std::to_string(density) +
                       ": an inverse spool needs 0 <= density < " + std::to_string(largest));
  }
  return std::cbrt(density / largest);
}

}  // namespace

double SpoolModel::largest_density() const {
  const double ratio = wire_radius / spacing;
  return 2 * pi / std::sqrt(3.0) * ratio * ratio;
}

double SpoolModel::bend_energy(double density) const {
  const double x = filling(*this, density);
  // atanh x - x loses all its digits for small x
  const double difference =
      x > 0.01 ? std::atanh(x) - x : x * x * x * (1.0 / 3 + x * x * (1.0 / 5 + x * x / 7));
  return 4 * pi / std::sqrt(3.0) * cavity.radius * bend_stiffness / (spacing * spacing) *
         difference;
}

double SpoolModel::injection_force(double density) const {
  const double r = inner_radius(density);
  return bend_stiffness / (2 * r * r);
}

double SpoolModel::inner_radius(double density) const {
  const double x = filling(*this, density);
  return cavity.radius * std::sqrt(1 - x * x);
}

}  // namespace wirepack
