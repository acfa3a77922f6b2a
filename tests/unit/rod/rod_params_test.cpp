#include "wirepack/rod/rod_params.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace wirepack {
namespace {

using Messages = std::vector<std::string>;

TEST(RodParams, OfThePaperAreValidAndHaveItsStiffnesses) {
  const RodParams paper;
  EXPECT_EQ(problems(paper), Messages{});
  const Stiffness s = stiffness(paper);
  EXPECT_NEAR(s.stretch, 15.708, 1e-3);  // printed digits of a = 1, Y = 5
  EXPECT_NEAR(s.bend, 3.926991, 1e-6);
  EXPECT_NEAR(s.twist, 3.926991 / (1 + 1.0 / 3), 1e-6);
}

TEST(RodParams, TwistStiffnessIsShearModulusTimesThePolarMoment) {
  RodParams params;
  params.radius = 0.6;
  params.youngs_modulus = 11;
  params.poisson_ratio = 0.2;
  const double shear_modulus = 11 / (2 * 1.2), polar_moment = pi * std::pow(0.6, 4) / 2;
  EXPECT_NEAR(stiffness(params).twist, shear_modulus * polar_moment, 1e-15);
}

TEST(RodParams, MessagesNameKeyValueAndWhatIsAllowed) {
  RodParams params;
  params.radius = -1;
  EXPECT_EQ(problems(params), Messages{"wire.radius = -1: must be positive and finite"});
  params = {};
  params.youngs_modulus = 0;
  EXPECT_EQ(problems(params), Messages{"wire.youngs_modulus = 0: must be positive and finite"});
  params = {};
  params.poisson_ratio = 1.5e6;
  EXPECT_EQ(problems(params),
            Messages{"wire.poisson_ratio = 1.5e+06: must be above -1 and at most 1e6"});
  params = {};
  params.poisson_ratio = -1;
  EXPECT_EQ(problems(params),
            Messages{"wire.poisson_ratio = -1: must be above -1 and at most 1e6"});
  params = {};
  params.stretch_multiplier = std::numeric_limits<double>::infinity();
  EXPECT_EQ(problems(params),
            Messages{"wire.stretch_multiplier = inf: must be positive and finite"});
}

TEST(RodParams, AllProblemsAreReportedTogetherAndNotANumberIsOne) {
  RodParams params;
  params.radius = std::nan("");
  params.poisson_ratio = std::nan("");
  params.edge_length = -2;
  params.rest_darboux.y() = std::nan("");
  EXPECT_EQ(problems(params).size(), 4U);
}

}  // namespace
}  // namespace wirepack
