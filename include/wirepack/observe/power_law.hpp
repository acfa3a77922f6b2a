#pragma once

#include <cstdint>
#include <span>

namespace wirepack {

/// y = factor x^exponent by least squares of log y against log x. Errors are standard deviations
/// over bootstrap samples of the points (runs), drawn with replacement.
struct PowerLaw {
  double exponent, exponent_error;
  double factor, factor_error;
};

/// Of positive x and y. Samples in which all x are equal say nothing and are drawn again.
/// Throws InvalidInput unless there are two different x, and as many y, all above zero.
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y, std::uint64_t seed = 1,
                       int samples = 2000);

}  // namespace wirepack
