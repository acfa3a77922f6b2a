#include "wirepack/rod/reference_shape.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"

namespace wirepack {
namespace {

DarbouxTable sample_table() {
  return DarbouxTable(
      {{0, Vec3(0.1, 0.2, -0.3)}, {2, Vec3(0.3, 0, -0.3)}, {5, Vec3(0, -0.4, 0.6)}});
}

// Midpoint rule from 0 with steps of 0.1, between which all kinks and jumps of k0 lie: exact.
Vec3 summed(const ReferenceShape& shape, double last) {
  Vec3 sum = Vec3::Zero();
  const long steps = std::lround(10 * std::abs(last));
  const double step = last / static_cast<double>(steps);
  for (long i = 0; i < steps; ++i) {
    sum += step * shape.darboux((static_cast<double>(i) + 0.5) * step);
  }
  return sum;
}

TEST(ReferenceShape, IntegralIsThatOfK0InsideAndBeyondTheTable) {
  for (const BeyondShape beyond : {BeyondShape::repeat, BeyondShape::extend}) {
    const ReferenceShape shape{sample_table(), beyond};
    for (const double arc : {-1.5, 0.7, 2.0, 3.1, 5.0, 6.3, 13.0}) {
      const Vec3 expected = summed(shape, arc);
      EXPECT_LT((shape.integral(arc) - expected).norm(), 1e-12) << arc;
    }
  }
}

TEST(ReferenceShape, RepeatsOrExtendsBeyondItsLength) {
  const ReferenceShape repeated{sample_table(), BeyondShape::repeat};
  EXPECT_LT((repeated.darboux(5 + 1.3) - repeated.darboux(1.3)).norm(), 1e-14);
  const ReferenceShape extended{sample_table(), BeyondShape::extend};
  EXPECT_EQ(extended.darboux(9), Vec3(0, -0.4, 0.6));
}

TEST(ReferenceShape, TablesThatCannotBeAreRefusedWithTheirRow) {
  const auto message = [](std::vector<DarbouxRow> rows) -> std::string {
    try {
      DarbouxTable table(std::move(rows));
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  const Vec3 k(0, 1, 0);
  EXPECT_EQ(message({{0, k}}), "k0 needs two rows at least");
  EXPECT_EQ(message({{1, k}, {2, k}}), "k0, row 1: the first arc must be 0");
  EXPECT_EQ(message({{0, k}, {1, k}, {1, k}}), "k0, row 3: arcs must grow from row to row");
  EXPECT_EQ(message({{0, k}, {1, Vec3(0, 0, NAN)}}), "k0, row 2: all numbers must be finite");
}

}  // namespace
}  // namespace wirepack
