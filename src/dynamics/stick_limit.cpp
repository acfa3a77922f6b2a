#include "wirepack/dynamics/stick_limit.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

constexpr double undamped_limit = 0.64;
constexpr double damped_limit = 0.08;  // times 1 / zeta
constexpr double round_off = 1e-9;

}  // namespace

double largest_stick_step(double damping_ratio) {
  return damping_ratio > 0 ? std::min(undamped_limit, damped_limit / damping_ratio)
                           : undamped_limit;
}

double longest_stick_step(const StickSlipLaw& law, double stiffness_per_mass) {
  const double frequency = std::sqrt(law.stiffness_ratio * stiffness_per_mass);
  return largest_stick_step(law.relaxation_time * frequency / 2) / frequency;
}

void require_calm_sticking(const StickSlipLaw& law, double stiffness_per_mass, double step) {
  const double frequency = std::sqrt(law.stiffness_ratio * stiffness_per_mass);
  const double damping_ratio = law.relaxation_time * frequency / 2;
  const double largest = largest_stick_step(damping_ratio);
  if (step * frequency <= largest * (1 + round_off)) return;
  std::ostringstream text;
  text
      << "friction would chatter and hold nothing: the time step times the frequency of a sticking "
         "contact is "
      << step * frequency << ", must be at most " << largest << " at its damping ratio of "
      << damping_ratio
      << "; a shorter time step (dynamics.time_step), a shorter relaxation time, or softer "
         "contacts";
  throw InvalidInput(text.str());
}

}  // namespace wirepack
