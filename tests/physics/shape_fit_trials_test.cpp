#include <gtest/gtest.h>

#include "../support/fit_trials.hpp"

namespace wirepack {
namespace {

using testing::helix_points;
using testing::Trials;
using testing::trials;

constexpr int pairs = 1000;  // the scatter is known to 1 / sqrt(2 * 1000) = 2 %

void expect_sound(const Trials& found) {
  EXPECT_LT(std::abs(found.bias), 0.1);
  EXPECT_NEAR(found.scatter, 1, 0.1);
}

TEST(FitTrials, RadiusAndCurvatureOfArcsScatterByTheirErrorsWithoutBias) {
  for (const auto& [turns, error] :
       {std::pair{1.0, 0.1}, std::pair{0.5, .224920}, std::pair{0.125, 4.201679}}) {
    const Points exact = helix_points(100, 1, 0, turns, turns < 1, 3);
    for (const double sigma : {0.001, 0.005}) {
      expect_sound(
          trials(exact, ShapeModel::circle, testing::curvature, 1, sigma, pairs, error * sigma));
      if (turns == 0.125) continue;  // the radius of short arcs is not normal: 1 / curvature
      expect_sound(
          trials(exact, ShapeModel::circle, testing::radius, 1, sigma, pairs, error * sigma));
    }
  }
}

TEST(FitTrials, CurvatureTorsionRadiusAndPitchOfHelicesScatterByTheirErrorsWithoutBias) {
  struct Case {
    Index count;
    double turns;
    std::array<double, 4> errors;
  };
  for (const Case& c : {Case{100, 1, {.092605, .089182, .108223, 2 * pi * .078521}},
                        Case{200, 5, {.063394, .027376, .071375, 2 * pi * .007930}}}) {
    const Points exact = helix_points(c.count, 1, 0.2, c.turns, true, 4);
    const std::array<double, 4> truth{1 / 1.04, 0.2 / 1.04, 1, 2 * pi * 0.2};
    for (std::size_t k = 0; k < 4; ++k) {
      expect_sound(trials(exact, ShapeModel::helix, static_cast<testing::Number>(k), truth[k], 0.01,
                          pairs, 0.01 * c.errors[k]));
    }
  }
}

TEST(FitTrials, RobustFitsScatterByTheErrorsTheyState) {
  const double sigma = 0.001;
  const Points exact = helix_points(100, 1, 0, 0.5, true, 3);
  Random random(3);
  const testing::Number number = testing::curvature;
  const double stated =
      testing::fitted(testing::measured(exact + testing::normal_noise(100, sigma, random)),
                      ShapeModel::circle, true)
          .numbers[number]
          .standard_error;
  // the error that one fit states is known to 1 / sqrt(2 * 194) = 5 %
  const Trials found = trials(exact, ShapeModel::circle, number, 1, sigma, pairs, stated, true);
  EXPECT_LT(std::abs(found.bias), 0.1);
  EXPECT_NEAR(found.scatter, 1, 0.15);
}

}  // namespace
}  // namespace wirepack
