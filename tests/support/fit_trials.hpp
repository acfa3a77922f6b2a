#pragma once

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/fit/shape_fit.hpp"

#include "measured_wires.hpp"

namespace wirepack::testing {

/// Places in ShapeFit::numbers.
enum Number : std::size_t { curvature = 0, torsion = 1, radius = 2, pitch = 3 };

inline ShapeFit fitted(const MeasuredPoints& points, ShapeModel model, bool robust = false) {
  ShapeFit fit = fit_shape(points, {model, robust, {}});
  EXPECT_TRUE(fit.converged);
  return fit;
}

// Many fits of the same points with other scatter, each together with its mirror image: what is
// left in their mean is the bias, and hardly the scatter. In standard errors.
struct Trials {
  double bias, scatter;
};

inline Trials trials(const Points& exact, ShapeModel model, Number number, double truth,
                     double sigma, int pairs, double standard_error, bool robust = false) {
  Random random(17);
  double sum = 0, squares = 0;
  for (int i = 0; i < pairs; ++i) {
    const Points noise = normal_noise(exact.cols(), sigma, random);
    for (const double sign : {1.0, -1.0}) {
      const double off =
          fitted(measured(exact + sign * noise), model, robust).numbers[number].value - truth;
      sum += off / standard_error;
      squares += off * off / (standard_error * standard_error);
    }
  }
  return {sum / (2 * pairs), std::sqrt(squares / (2 * pairs))};
}

}  // namespace wirepack::testing
