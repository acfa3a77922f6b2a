#include "wirepack/rod/elasticity.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace wirepack {
namespace {

TEST(Elasticity, a_solid_wire_has_the_material_that_it_was_made_of) {
  RodParams wire;
  wire.radius = 0.7;
  wire.youngs_modulus = 3;
  wire.poisson_ratio = 0.25;
  wire.stretch_multiplier = 12;
  const Elasticity back = elasticity_of(stiffness(wire), wire.radius);
  EXPECT_NEAR(back.youngs_modulus, 3, 1e-14);
  EXPECT_NEAR(back.poisson_ratio, 0.25, 1e-14);
  EXPECT_NEAR(back.stretch_multiplier, 12, 1e-13);
}

/// Moment (or force) over the deformation of one turn of a bar bent to a circle, by its energy
/// int (M_bend^2 / EI + M_twist^2 / GJ) / 2 ds, summed over pieces of the circle.
struct Turn {
  double radius, bend, twist, pitch;

  template <class Bending, class Twisting>
  double stiffness(Bending bending, Twisting twisting) const {
    constexpr int pieces = 360;
    double compliance = 0;
    for (int i = 0; i < pieces; ++i) {
      const double angle = 2 * pi * (i + 0.5) / pieces;
      const double m = bending(angle), t = twisting(angle);
      compliance += (m * m / bend + t * t / twist) * radius * 2 * pi / pieces;
    }
    return pitch / compliance;
  }
};

TEST(WoundCoil, stiffnesses_are_those_of_the_energy_of_a_turn_under_unit_loads) {
  const WoundCoil coil{0.05, 0.35, 70, 0.3};
  RodParams stock;
  stock.radius = coil.wire_diameter / 2;
  stock.youngs_modulus = coil.youngs_modulus;
  stock.poisson_ratio = coil.poisson_ratio;
  const Stiffness of_stock = stiffness(stock);
  const double radius = (coil.coil_diameter - coil.wire_diameter) / 2;
  const Turn turn{radius, of_stock.bend, of_stock.twist, coil.wire_diameter};
  const Stiffness s = stiffness(coil);
  // a moment across the axis has a part along the bar and one along the coil's radius
  const double bend = turn.stiffness([](double angle) { return std::cos(angle); },
                                     [](double angle) { return std::sin(angle); });
  // a moment along the axis bends the bar everywhere
  const double twist = turn.stiffness([](double) { return 1; }, [](double) { return 0; });
  // a force along the axis twists it everywhere
  const double stretch = turn.stiffness([](double) { return 0; }, [=](double) { return radius; });
  EXPECT_NEAR(s.bend / bend, 1, 1e-12);
  EXPECT_NEAR(s.twist / twist, 1, 1e-12);
  EXPECT_NEAR(s.stretch / stretch, 1, 1e-12);
}

TEST(WoundCoil, a_solid_wire_of_negative_poisson_ratio_stands_for_it) {
  const Elasticity solid = elasticity_of(stiffness(WoundCoil{0.05, 0.35, 70, 0.3}), 0.175);
  EXPECT_NEAR(solid.poisson_ratio, -0.3 / 2.3, 1e-14);
}

}  // namespace
}  // namespace wirepack
