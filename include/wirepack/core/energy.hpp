#pragma once

#include "wirepack/core/lanes.hpp"

namespace wirepack {

/// Rounded sum of a and b, and what the rounding took from it: a + b = sum + error exactly (TwoSum,
/// Knuth 1969). Needs arithmetic that keeps to the standard, so no -ffast-math.
template <class T>
struct RoundedSum {
  T sum, error;
};

template <class T>
[[gnu::always_inline]] inline RoundedSum<T> rounded_sum(const T& a, const T& b) {
  const T sum = a + b;
  const T from_b = sum - a;
  return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// Energy together with the round-off of the sum that it came from. A minimum is flat: the last
/// steps to it change the energy by less than one unit in the last place of its value. So energies
/// are compared by their difference, in which the round-off counts.
class Energy {
 public:
  Energy(double value = 0, double round_off = 0) : value_(value), round_off_(round_off) {}

  operator double() const { return value_ + round_off_; }
  Energy& operator+=(const Energy& other) {
    const auto [sum, error] = rounded_sum(value_, other.value_);
    value_ = sum;
    round_off_ += other.round_off_ + error;
    return *this;
  }
  friend Energy operator+(Energy a, const Energy& b) { return a += b; }
  /// a - b, right to the last digits of the difference if the terms of both sums are far smaller
  /// than the sums.
  friend double difference(const Energy& a, const Energy& b) {
    return (a.value_ - b.value_) + (a.round_off_ - b.round_off_);
  }

 private:
  double value_, round_off_;
};

/// Compensated sum of energies, numbers or lanes, always added up in the same order.
class EnergySum {
 public:
  [[gnu::always_inline]] void add(const Lanes& v) {
    const auto [sum, error] = rounded_sum(lanes_, v);
    lanes_ = sum;
    lane_errors_ += error;
  }
  void add(const Energy& v) { rest_ += v; }
  void add(double v) { rest_ += v; }
  Energy total() const {
    Energy sum = rest_;
    for (std::size_t k = 0; k < lane_count; ++k) sum += Energy(lanes_[k], lane_errors_[k]);
    return sum;
  }

 private:
  Lanes lanes_ = 0.0, lane_errors_ = 0.0;
  Energy rest_;
};

}  // namespace wirepack
