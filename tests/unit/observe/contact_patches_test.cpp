#include "wirepack/observe/contact_patches.hpp"

#include <gtest/gtest.h>

#include "../../support/strands.hpp"

namespace wirepack {
namespace {

// One wire with two straight legs of length 40 that pass each other at this angle and distance.
RodState two_strands(double angle, double distance, double edge_length) {
  const auto edges = static_cast<Index>(40 / edge_length);
  const Vec3 across(std::cos(angle), std::sin(angle), 0);
  RodState state;
  state.nodes = testing::joined_strands(
                    testing::centred_strand(Vec3::Zero(), Vec3::UnitX(), edge_length, edges),
                    testing::centred_strand({0, 0, distance}, across, edge_length, edges))
                    .nodes;
  return state;
}

std::vector<ContactPatch> patches(const RodState& state, double edge_length) {
  RodParams wire;
  wire.edge_length = edge_length;
  SelfContactEnergy contact(wire, ContactParams{});
  contact.prepare(state);
  return contact_patches(state, contact.contacts(state));
}

TEST(ContactPatches, of_a_crossing_are_one_with_its_angle_and_force_for_any_mesh) {
  const double angle = pi / 2, overlap = 0.01;
  for (const double edge_length : {1.0, 0.5}) {
    const auto found = patches(two_strands(angle, 2 - overlap, edge_length), edge_length);
    ASSERT_EQ(found.size(), 1U) << edge_length;
    EXPECT_NEAR(found[0].angle, angle, 1e-9);
    EXPECT_NEAR(found[0].force, 2 * 5 * overlap, 1e-3 * found[0].force);  // 2 a k overlap
    EXPECT_GT(found[0].pairs, 1);
  }
}

TEST(ContactPatches, of_strands_side_by_side_are_one_with_a_force_per_length) {
  const double overlap = 0.01;
  const auto found = patches(two_strands(0, 2 - overlap, 1), 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].angle, 0, 1e-9);
  EXPECT_NEAR(found[0].force, 40 * 5 * overlap, 0.05 * found[0].force);  // but for the ends
  EXPECT_TRUE(patches(two_strands(0, 2 + overlap, 1), 1).empty());
}

}  // namespace
}  // namespace wirepack
