#include <gtest/gtest.h>

#include "../support/measured_order.hpp"
#include "../support/stability.hpp"

namespace wirepack {
namespace {

using testing::refine;
using testing::Refinement;

using testing::End;

double relative_error(Index edges, End first, End last, double exact) {
  constexpr double stretch = 400;  // P (1 - P / YA) takes the place of P
  const double load = testing::euler_load(edges, first, last, 1.05 * exact, stretch);
  return std::abs(load * (1 - load / stretch) / exact - 1);
}

void expect_order_two(End first, End last, double exact) {
  const Refinement r =
      refine([&](Index edges) { return relative_error(edges, first, last, exact); });
  EXPECT_GT(r.order, 1.95);
  EXPECT_LT(r.errors.back(), 1.5 * exact / (12.0 * 200 * 200));  // P / (12 N^2), more at clamps
}

// A clamp is half an edge long, so it does not spoil the order.
TEST(EulerLoadConvergence, IsOfOrderTwoForEveryPairOfEnds) {
  expect_order_two(End::clamped, End::free, pi * pi / 4);
  expect_order_two(End::pinned, End::pinned, pi * pi);
  expect_order_two(End::clamped, End::pinned, std::pow(4.493409457909064, 2));
  expect_order_two(End::clamped, End::clamped, 4 * pi * pi);
}

}  // namespace
}  // namespace wirepack
