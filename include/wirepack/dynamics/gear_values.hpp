#pragma once

#include <Eigen/Core>
#include <array>

namespace wirepack {

/// Coordinates of the 6-value Gear scheme for x'' = a(x, x', t) in Nordsieck form: column k holds
/// h^k / k! d^k x / dt^k, h the time step; one row per coordinate.
using GearValues = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// How much of the correction each column takes.
using GearWeights = std::array<double, 6>;

/// For accelerations that depend on velocities (damping, friction). Public codes swap this set and
/// the next; here the orders were measured: both have global order 5.
inline constexpr GearWeights gear_weights_velocity{3.0 / 16,  251.0 / 360, 1,
                                                   11.0 / 18, 1.0 / 6,     1.0 / 60};
/// For accelerations that depend on positions only.
inline constexpr GearWeights gear_weights_position{3.0 / 20,  251.0 / 360, 1,
                                                   11.0 / 18, 1.0 / 6,     1.0 / 60};

/// The scheme is only just stable: the spectral radius of its step for an undamped oscillator of
/// frequency omega stays at 1 up to h omega = 0.31, and beyond exceeds it by 2.1e-5 at 0.4, 1.9e-4
/// at 0.5, 1.1e-3 at 0.62. Damping must make up for that, and may not be large either: with damping
/// ratios 0.01, 0.05, 0.1, 0.2, 0.5 it is stable up to h omega = 0.76, 0.63, 0.50, 0.34, 0.16.
inline constexpr double gear_undamped_limit = 0.31;

/// Taylor series to the end of the step.
void gear_predict(GearValues& values);

/// Adds weights[k] (h^2 / 2 a - column 2) to column k, with a the acceleration at the prediction.
void gear_correct(GearValues& values, const Eigen::Ref<const Eigen::VectorXd>& acceleration,
                  double step, const GearWeights& weights = gear_weights_velocity);

}  // namespace wirepack
