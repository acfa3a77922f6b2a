#include <gtest/gtest.h>

#include "../support/helices.hpp"
#include "../support/localised_helix.hpp"
#include "../support/measured_order.hpp"
#include "../support/twisted_rods.hpp"

namespace wirepack {
namespace {

using testing::refine;
using testing::Refinement;

TEST(TwistConvergence, GreenhillTorquesAreOfOrderTwo) {
  const Refinement hinged = refine([](Index edges) {
    return std::abs(testing::greenhill_torque(edges, 10, false) / (2 * std::sqrt(pi * pi + 10)) -
                    1);
  });
  EXPECT_GT(hinged.order, 1.9);
  EXPECT_LT(hinged.errors.back(), 5e-4);  // waves of (2 pi / N)^2 / 2
  const Refinement clamped = refine([](Index edges) {
    return std::abs(testing::greenhill_torque(edges, 0, true) / (2 * 4.493409457909064) - 1);
  });
  EXPECT_GT(clamped.order, 1.9);
  EXPECT_LT(clamped.errors.back(), 5e-4);
}

TEST(TwistConvergence, LocalisedHelixIsOfOrderTwo) {
  const std::vector<Index> edges{200, 400, 800};  // below, joints turn by up to 0.4
  std::vector<double> moment, tension, envelope;
  for (const Index n : edges) {
    const testing::LocalisedHelix found = testing::localised_helix(n);
    moment.push_back(std::abs(found.moment / testing::ExactEnvelope::moment - 1));
    tension.push_back(std::abs(found.tension / testing::ExactEnvelope::tension - 1));
    envelope.push_back(found.envelope_error);
  }
  EXPECT_GT(testing::measured_order(edges, moment), 1.9);
  EXPECT_GT(testing::measured_order(edges, tension), 1.9);
  EXPECT_GT(testing::measured_order(edges, envelope), 1.9);
  EXPECT_LT(tension.back(), 2e-3);
}

TEST(TwistConvergence, StressFreeHelixIsOfOrderTwo) {
  const testing::Helix shape{1, 0.5};
  std::vector<double> radius, pitch;
  for (const Index edges : testing::refinements()) {
    const testing::MeasuredHelix found = testing::released_helix(edges, shape).shape;
    radius.push_back(std::abs(found.radius / shape.radius() - 1));
    pitch.push_back(std::abs(found.pitch / shape.pitch() - 1));
  }
  EXPECT_GT(testing::measured_order(testing::refinements(), radius), 1.9);
  EXPECT_GT(testing::measured_order(testing::refinements(), pitch), 1.9);
  EXPECT_LT(radius.back(), 5e-4);  // (l k)^2 / 12 with l k = 0.06
  EXPECT_LT(pitch.back(), 5e-4);
}

TEST(TwistConvergence, WrenchOfTheHeldHelixIsOfOrderTwo) {
  const testing::Helix held{0.9, 0.3};
  const testing::Wrench exact = testing::exact_wrench(held, 1, 0, 1, 2.0 / 3);
  std::vector<double> force, moment;
  for (const Index edges : testing::refinements()) {
    const testing::Wrench found = testing::held_helix(edges, held);
    force.push_back(std::abs(found.force - exact.force));
    moment.push_back(std::abs(found.moment - exact.moment));
  }
  EXPECT_GT(testing::measured_order(testing::refinements(), force), 1.9);
  EXPECT_GT(testing::measured_order(testing::refinements(), moment), 1.9);
  EXPECT_LT(force.back(), 5e-4);
  EXPECT_LT(moment.back(), 5e-4);
}

}  // namespace
}  // namespace wirepack
