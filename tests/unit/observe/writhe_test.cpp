#include "wirepack/observe/writhe.hpp"

#include <functional>
#include <gtest/gtest.h>

#include "../../support/sample_rods.hpp"
#include "../../support/strands.hpp"

namespace wirepack {
namespace {

using testing::random_vector;

using Curve = std::function<Vec3(double)>;

Points polygon(const Curve& curve, Index edges) {
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    nodes.col(i) = curve(2 * pi * static_cast<double>(i) / static_cast<double>(edges));
  }
  return nodes;
}

Vec3 trefoil(double t) {
  return {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
}
Vec3 figure_eight_knot(double t) {
  const double r = 2 + std::cos(2 * t);
  return {r * std::cos(3 * t), r * std::sin(3 * t), std::sin(4 * t)};
}
Curve torus_curve(int p, int q, double tube) {
  return [=](double t) {
    const double r = 2 + tube * std::cos(q * t);
    return Vec3(r * std::cos(p * t), r * std::sin(p * t), tube * std::sin(q * t));
  };
}
Curve lemniscate(double height) {
  return [=](double t) { return Vec3(std::cos(t), std::sin(2 * t) / 2, height * std::sin(t)); };
}

struct KnownWrithe {
  const char* name;
  Curve curve;
  double writhe;
};

// V2.4: of the smooth curves, to six decimals
std::vector<KnownWrithe> known_writhes() {
  return {{"trefoil", trefoil, -3.354126},
          {"figure-eight knot", figure_eight_knot, 0.086316},
          {"torus (2, 3)", torus_curve(2, 3, 1), -3.518239},
          {"torus (3, 2)", torus_curve(3, 2, 1), -3.900787},
          {"torus (1, 4)", torus_curve(1, 4, 0.5), -1.160949},
          {"lemniscate 0.5", lemniscate(0.5), 0.361032},
          {"lemniscate 0.1", lemniscate(0.1), 0.856043}};
}

TEST(Writhe, OfPolygonsConvergesToTheSmoothCurveWithOrderTwo) {
  for (const KnownWrithe& known : known_writhes()) {
    const double w400 = writhe(polygon(known.curve, 400), true);
    const double w800 = writhe(polygon(known.curve, 800), true);
    const double w1600 = writhe(polygon(known.curve, 1600), true);
    EXPECT_NEAR(std::log2((w400 - w800) / (w800 - w1600)), 2, 0.05) << known.name;
    // extrapolated; the catalogue prints six decimals
    EXPECT_NEAR((4 * w1600 - w800) / 3, known.writhe, 1e-6) << known.name;
  }
}

TEST(Writhe, OfGivenPolygonsIsExact) {
  // V2.4, printed to six decimals
  EXPECT_NEAR(writhe(polygon(trefoil, 100), true), -3.354225, 5.1e-7);
  EXPECT_NEAR(writhe(polygon(figure_eight_knot, 200), true), 0.085754, 5.1e-7);
  EXPECT_NEAR(writhe(polygon(torus_curve(2, 3, 1), 400), true), -3.517860, 5.1e-7);
}

TEST(Writhe, OfAnOpenPolylineHasTheSignOfPyElastica) {
  // V2.5, with an end segment of length 10 along each end tangent
  Points nodes(3, 7);
  nodes << 0, 0, 0, 0, 0, 1, 11,  //
      0, 0, 0, 1, 1, 1, 1,        //
      -10, 0, 1, 1, 0, 0, 0;
  EXPECT_NEAR(writhe(nodes, false), -0.477268070084, 1e-11);  // printed to twelve decimals
}

TEST(Writhe, ChangesSignInAMirrorAndNotWithPlaceSizeTurnOrSense) {
  const Points nodes = polygon(torus_curve(2, 3, 1), 60);
  const double w = writhe(nodes, true);
  ASSERT_LT(w, -3);
  Random random(8);
  const Mat3 turn = testing::random_rotation(random).toRotationMatrix();
  EXPECT_NEAR(writhe(-nodes, true), -w, 1e-12);
  EXPECT_NEAR(writhe((3.7 * turn * nodes).colwise() + Vec3(5, -2, 9), true), w, 1e-12);
  EXPECT_NEAR(writhe(nodes.rowwise().reverse(), true), w, 1e-12);
  EXPECT_NEAR(writhe(testing::ring_nodes(3, 17), true), 0, 1e-14);
  EXPECT_NEAR(writhe(testing::helix_strand(3, 0, 0.9, 17), false), 0, 1e-14);
}

// 1 / (4 pi) of |(t x t') . r| / |r|^3 over all pairs of points, by midpoints; pairs near each
// other add nothing on a smooth curve.
double double_integral(const Curve& curve, int parts) {
  const double step = 2 * pi / parts;
  std::vector<Vec3> points, slopes;
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) * step;
    points.push_back(curve(t));
    slopes.push_back((curve(t + 1e-5) - curve(t - 1e-5)) / 2e-5);
  }
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 r = points[i] - points[j];
      sum += std::abs(slopes[i].cross(slopes[j]).dot(r)) / std::pow(r.norm(), 3);
    }
  }
  return 2 * sum * step * step / (4 * pi);
}

TEST(CrossingSums, average_crossing_number_is_the_double_integral) {
  for (const KnownWrithe& known : known_writhes()) {
    const double found = crossing_sums(polygon(known.curve, 1000), true).average_crossing_number;
    const double exact = double_integral(known.curve, 1500);
    EXPECT_NEAR(found, exact, 1e-3 * exact) << known.name;
    EXPECT_GE(found, std::abs(known.writhe) - 1e-3);
  }
}

TEST(CrossingSums,
     of_opposite_edges_of_a_tetrahedron_is_the_share_of_directions_that_see_them_cross) {
  // It looks like a triangle along lines through a corner and the inside, and there is no crossing;
  // else like a quadrangle, in which one of three pairs of opposite edges cross.
  Points nodes(3, 4);
  nodes << 1, -1, 1, -1,  //
      1, -1, -1, 1,       //
      1, 1, -1, -1;
  const double corner = 3 * std::acos(1.0 / 3) - pi;  // its solid angle
  EXPECT_NEAR(crossing_sums(nodes, false).average_crossing_number, (1 - 8 * corner / (4 * pi)) / 3,
              1e-12);
}

TEST(Twist, OfFramesTurnedLikeARightHandedScrewIsPositive) {
  RodState state = make_rod(testing::straight_nodes(40, 40), RodParams{});
  for (std::size_t j = 0; j < state.frames.size(); ++j) {
    // counterclockwise about the tangent on the way along it: 39 joints of a tenth of a turn
    state.frames[j] =
        rotation_about(Vec3::UnitZ(), 2 * pi * 0.1 * static_cast<double>(j)) * state.frames[j];
  }
  EXPECT_NEAR(total_twist(state), 3.9, 1e-12);
  state.twist_guide[7] = 4 * pi;  // two whole turns that were followed at one joint
  EXPECT_NEAR(total_twist(state), 5.9, 1e-12);
}

// A closed rod through the nodes, its frames turned evenly by `turns` on the way, so that they
// close: the joint at node 0 takes what parallel transport leaves over.
RodState closed_ribbon(const Points& nodes, double turns) {
  RodState state = make_rod(nodes, RodParams{}, RodEnds{.closed = true});
  for (std::size_t j = 0; j < state.frames.size(); ++j) {
    const double angle =
        2 * pi * turns * static_cast<double>(j) / static_cast<double>(state.frames.size());
    state.frames[j] = rotation_about(third_axis(state.frames[j]), angle) * state.frames[j];
  }
  return state;
}

TEST(Twist, WithWritheIsTheLinkingNumberOfAnyClosedRibbon) {
  Random random(12);
  for (const KnownWrithe& known : known_writhes()) {
    for (const double turns : {0.0, 3.0, -7.4}) {
      Points nodes = polygon(known.curve, 120);
      for (auto&& node : nodes.colwise()) node += 0.002 * random_vector(random);
      const RodState state = closed_ribbon(nodes, turns);
      const double link = linking_number(state.nodes, ribbon_edge(state, 1e-3));
      EXPECT_NEAR(link, std::round(link), 1e-10) << known.name;  // V2.3
      EXPECT_NEAR(total_twist(state) + writhe(state), std::round(link), 1e-10)
          << known.name << " " << turns;
    }
  }
}

TEST(Twist, WithWritheJumpsByTwoWhenAStrandPassesThroughItself) {
  // the lemniscate's crossing changes its sign with its height
  const auto link = [](double height) {
    const RodState state = closed_ribbon(polygon(lemniscate(height), 200), 0);
    return total_twist(state) + writhe(state);
  };
  // parallel transport follows the curve evenly, so nothing but the passage changes the twist, but
  // for whole turns that the frames of make_rod leave to the last joint
  const double change = link(0.02) - link(-0.02);
  EXPECT_NEAR(change, 2 * std::round(change / 2), 1e-10);
  EXPECT_NEAR(writhe(polygon(lemniscate(0.001), 200), true) -
                  writhe(polygon(lemniscate(-0.001), 200), true),
              2, 0.02);
}

TEST(LinkingNumber, CountsSignedWindings) {
  Points ring = testing::ring_nodes(2, 30);
  // curves around the ring's tube
  const auto around = [](int windings) {
    return polygon(
        [=](double t) {
          const double r = 2 + 0.5 * std::cos(windings * t);
          return Vec3(r * std::cos(t), r * std::sin(t), 0.5 * std::sin(windings * t));
        },
        300);
  };
  // counterclockwise ring, and a curve that goes down outside: left-handed for positive numbers
  for (const int windings : {0, 1, -2, 5}) {
    EXPECT_NEAR(linking_number(ring, around(windings)), -windings, 1e-12);
    EXPECT_NEAR(linking_number(around(windings), ring), -windings, 1e-12);
  }
}

}  // namespace
}  // namespace wirepack
