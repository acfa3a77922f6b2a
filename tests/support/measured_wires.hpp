#pragma once

#include <cmath>
#include <functional>

#include "wirepack/core/random.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/fit/measured_points.hpp"

#include "sample_rods.hpp"

namespace wirepack::testing {

inline double uniform(Random& random) { return (random.symmetric() + 1 + 0x1p-53) / 2; }

/// Standard normal numbers (Box and Muller).
inline double normal(Random& random) {
  const double radius = std::sqrt(-2 * std::log(uniform(random)));
  return radius * std::cos(2 * pi * uniform(random));
}

inline Points normal_noise(Index count, double sigma, Random& random) {
  Points noise(3, count);
  for (double& v : noise.reshaped()) v = sigma * normal(random);
  return noise;
}

/// Points r(cos phi, sin phi, slope phi), phi equally spaced over `turns`, turned and moved.
inline Points helix_points(Index count, double radius, double slope, double turns, bool closed_end,
                           std::uint64_t seed) {
  Random random(seed);
  const Quat turn = random_rotation(random);
  const Vec3 shift = 3 * random_vector(random);
  Points points(3, count);
  const auto steps = static_cast<double>(closed_end ? count - 1 : count);
  for (Index i = 0; i < count; ++i) {
    const double phi = 2 * pi * turns * static_cast<double>(i) / steps;
    points.col(i) =
        shift + turn * Vec3(radius * std::cos(phi), radius * std::sin(phi), slope * phi);
  }
  return points;
}

inline MeasuredPoints measured(const Points& position, bool ordered = true) {
  MeasuredPoints points;
  points.position = position;
  points.ordered = ordered;
  return points;
}

inline MeasuredPoints shuffled(MeasuredPoints points, std::uint64_t seed) {
  Random random(seed);
  for (Index i = points.count() - 1; i > 0; --i) {
    const auto j = static_cast<Index>(uniform(random) * static_cast<double>(i + 1));
    points.position.col(i).swap(points.position.col(j));
  }
  points.ordered = false;
  return points;
}

}  // namespace wirepack::testing
