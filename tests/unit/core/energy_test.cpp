#include "wirepack/core/energy.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace wirepack {
namespace {

// As many terms as a large packing has nodes, with its energy.
constexpr Index count = 20000;

std::vector<double> large_packing() {
  std::vector<double> terms(count);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    terms[k] = 0.05 * (1 + std::sin(static_cast<double>(k)));
  }
  return terms;
}

Energy sum_in_lanes(const std::vector<double>& terms) {
  EnergySum sum;
  for_each_in_lanes(0, static_cast<Index>(terms.size()),
                    [&]<class T>(Index j) { sum.add(load<T>(terms.data() + j)); });
  return sum.total();
}

TEST(EnergySum, a_change_far_below_the_last_place_of_the_sum_is_seen_in_the_difference) {
  std::vector<double> terms = large_packing();
  const Energy before = sum_in_lanes(terms);
  EXPECT_NEAR(before, 1000, 10);
  for (const std::size_t changed : {3U, 7777U, 19999U}) {
    const double old = terms[changed], change = 1e-15;
    terms[changed] += change;
    const double exact = terms[changed] - old;  // as it is rounded
    EXPECT_NEAR(difference(sum_in_lanes(terms), before) / exact, 1, 1e-3);
    terms[changed] = old;
  }
}

TEST(EnergySum, sums_of_energies_keep_their_round_off) {
  Energy total(1000);
  for (int k = 0; k < 1000; ++k) total += Energy(1e-17);
  EXPECT_NEAR(difference(total, Energy(1000)), 1e-14, 1e-20);
  EXPECT_NEAR(difference(Energy(2) + Energy(1e-20), Energy(2)), 1e-20, 1e-26);
}

}  // namespace
}  // namespace wirepack
