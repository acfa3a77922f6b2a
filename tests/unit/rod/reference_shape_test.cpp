#include "wirepack/rod/reference_shape.hpp"

#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"

namespace wirepack {
namespace {

DarbouxTable sample_table() {
  return DarbouxTable(
      {{0, Vec3(0.1, 0.2, -0.3)}, {2, Vec3(0.3, 0, -0.3)}, {5, Vec3(0, -0.4, 0.6)}});
}

// Composite midpoint rule; exact where k0 is linear over a step.
Vec3 summed(const ReferenceShape& shape, double first, double last, int steps) {
  Vec3 sum = Vec3::Zero();
  const double step = (last - first) / steps;
  for (int i = 0; i < steps; ++i) sum += step * shape.darboux(first + (i + 0.5) * step);
  return sum;
}

TEST(ReferenceShape, IntegralIsThatOfK0InsideAndBeyondTheTable) {
  for (const BeyondShape beyond : {BeyondShape::repeat, BeyondShape::extend}) {
    const ReferenceShape shape{sample_table(), beyond};
    for (const double arc : {-1.5, 0.7, 2.0, 3.1, 5.0, 6.3, 13.0}) {
      const Vec3 expected = summed(shape, 0, arc, 26000);
      // steps that contain a kink or a jump of k0 are off by 1e-3 of a step of 5e-4
      EXPECT_LT((shape.integral(arc) - expected).norm(), 1e-6) << arc;
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
