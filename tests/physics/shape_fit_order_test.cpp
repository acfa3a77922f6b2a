#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/fit/shape_fit.hpp"

#include "../support/fit_trials.hpp"
#include "../support/measured_wires.hpp"

namespace wirepack {
namespace {

using testing::curvature;
using testing::fitted;
using testing::helix_points;
using testing::measured;
using testing::normal_noise;
using testing::pitch;
using testing::radius;
using testing::shuffled;
using testing::torsion;

enum class Listing { forward, backward, shuffled };

struct Coil {
  double turn_distance, turns, hand, noise;  // distances over the radius
  Index points_per_turn;
  Listing listing;

  double length() const { return 2 * pi * turns * std::hypot(1.0, turn_distance / (2 * pi)); }
  MeasuredPoints points(std::uint64_t seed) const {
    Random random(seed);
    const auto count = static_cast<Index>(turns * static_cast<double>(points_per_turn)) + 1;
    Points exact = helix_points(count, 1, hand * turn_distance / (2 * pi), turns, true, seed);
    exact += normal_noise(count, noise * turn_distance, random);
    if (listing == Listing::backward) exact = exact.rowwise().reverse().eval();
    const MeasuredPoints list = measured(exact, false);
    return listing == Listing::shuffled ? shuffled(list, seed) : list;
  }
  std::string name() const {
    return "turns " + std::to_string(turns) + ", apart by " + std::to_string(turn_distance) +
           ", points to a turn " + std::to_string(points_per_turn) + ", hand " +
           std::to_string(hand) + ", noise " + std::to_string(noise) + ", listing " +
           std::to_string(static_cast<int>(listing));
  }
};

std::vector<Coil> coils() {
  std::vector<Coil> result;
  for (const double distance : {0.02, 0.1, 0.4, 2.0}) {
    for (const double turns : {1.5, 4.0, 20.0}) {
      for (const Index points_per_turn : {6, 25}) {
        for (const double noise : {0.0, 0.03}) {
          for (const Listing listing : {Listing::forward, Listing::backward, Listing::shuffled}) {
            const double hand = result.size() % 2 == 0 ? 1 : -1;
            result.push_back({distance, turns, hand, noise, points_per_turn, listing});
          }
        }
      }
    }
  }
  return result;
}

// Of such points the first and the last, or neighbours, lie exactly opposite each other.
TEST(FitOfCoils,
     of_whole_and_half_turns_about_an_axis_of_the_coordinates_are_exact_in_both_directions) {
  for (const double turns : {0.5, 1.0, 1.5, 2.0, 3.0, 8.0}) {
    for (const double rise : {1.0, 4.0}) {
      for (const bool down : {false, true}) {
        const Index count = 60;
        Points nodes(3, count);
        for (Index i = 0; i < count; ++i) {
          const double turn = turns * static_cast<double>(i) / static_cast<double>(count - 1);
          nodes.col(i) << 3 * std::cos(2 * pi * turn), 3 * std::sin(2 * pi * turn), rise * turn;
        }
        if (down) nodes = nodes.rowwise().reverse().eval();
        const ShapeFit fit = fitted(measured(nodes, true), ShapeModel::helix);
        EXPECT_NEAR(fit.numbers[pitch].value, rise, 1e-6) << turns << " turns, down " << down;
        EXPECT_NEAR(fit.numbers[radius].value, 3, 1e-6) << turns << " turns, down " << down;
      }
    }
  }
}

TEST(FitOfCoils, of_which_two_turns_are_missing_or_halves_are_swapped_are_exact) {
  const Points whole = helix_points(181, 3, 4 / (2 * pi), 6, true, 1);
  Points missing(3, 121), swapped(3, 181);
  missing << whole.leftCols(61), whole.rightCols(60);
  swapped << whole.rightCols(90).rowwise().reverse(), whole.leftCols(91);
  for (const Points& nodes : {missing, swapped}) {
    const ShapeFit fit = fitted(measured(nodes, false), ShapeModel::helix);
    EXPECT_NEAR(std::abs(fit.numbers[pitch].value), 4, 1e-6);
    EXPECT_NEAR(fit.length, 6 * 2 * pi * std::hypot(3, 4 / (2 * pi)), 1e-4);
    EXPECT_TRUE(fit.misfit.empty()) << fit.misfit;
  }
}

TEST(FitOfCoils, of_a_few_turns_as_a_circle_are_said_to_misfit) {
  const ShapeFit fit =
      fitted(measured(helix_points(120, 3, 4 / (2 * pi), 3, true, 1), false), ShapeModel::circle);
  EXPECT_NE(fit.misfit.find("neighbouring points"), std::string::npos) << fit.misfit;
}

// Where they scatter as far as they are apart, a line through them is a zigzag.
TEST(FitOfSplines, of_points_that_scatter_as_far_as_they_are_apart_have_the_length_of_the_wire) {
  const Index count = 250;
  const double length = 5 * 3.4;
  Points arc(3, count);
  for (Index i = 0; i < count; ++i) {
    const double angle = 3.4 * static_cast<double>(i) / static_cast<double>(count - 1);
    arc.col(i) << 5 * std::cos(angle), 5 * std::sin(angle), 0;
  }
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const Points nodes = arc + normal_noise(count, 0.1, random);
    const ShapeFit fit = fitted(measured(nodes, false), ShapeModel::spline);
    EXPECT_NEAR(fit.length / length, 1, 0.03) << seed;
    EXPECT_NEAR(fit.numbers[curvature].value, 0.2, 0.02) << seed;
  }
}

TEST(FitOfCoils, has_the_right_hand_and_length_for_any_pitch_and_order_or_cannot_tell) {
  Index refused = 0;
  const std::vector<Coil> all = coils();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Coil& coil = all[i];
    try {
      const ShapeFit fit = fitted(coil.points(i), ShapeModel::helix);
      const ShapeNumber& found = fit.numbers[pitch];
      // distances of 144 fits: one in a thousand is beyond 3.3 standard errors
      EXPECT_NEAR(found.value, coil.hand * coil.turn_distance, 5 * found.standard_error + 1e-9)
          << coil.name();
      EXPECT_NEAR(fit.length / coil.length(), 1, 0.02 + 0.1 * coil.noise) << coil.name();
      EXPECT_TRUE(fit.misfit.empty()) << coil.name() << ": " << fit.misfit;
      if (coil.noise == 0) {
        EXPECT_TRUE(fit.outliers.empty()) << coil.name();
      }
    } catch (const InvalidInput& error) {
      ++refused;
      EXPECT_TRUE(coil.listing == Listing::shuffled) << coil.name() << ": " << error.what();
    }
  }
  EXPECT_LT(refused, std::ssize(all) / 10);
}

TEST(FitOfCoils, of_hundreds_of_turns_has_the_right_hand_and_length) {
  for (const Listing listing : {Listing::forward, Listing::shuffled}) {
    const Coil coil{0.1, 151.3, -1, 0, 40, listing};
    const ShapeFit fit = fitted(coil.points(5), ShapeModel::helix);
    EXPECT_NEAR(fit.numbers[pitch].value, -0.1, 1e-9);
  }
}

TEST(FitOfCoils, of_a_spline_has_the_right_length_in_any_order_or_cannot_tell) {
  Index refused = 0;
  for (const double distance : {0.02, 0.1, 0.4}) {
    for (const Listing listing : {Listing::forward, Listing::backward, Listing::shuffled}) {
      for (const double noise : {0.0, 0.03}) {
        const Coil coil{distance, 4, -1, noise, 20, listing};
        try {
          const ShapeFit fit = fitted(coil.points(3), ShapeModel::spline);
          EXPECT_NEAR(fit.length / coil.length(), 1, 0.01) << coil.name();
        } catch (const InvalidInput& error) {
          ++refused;
          EXPECT_TRUE(listing == Listing::shuffled) << coil.name() << ": " << error.what();
        }
      }
    }
  }
  EXPECT_LE(refused, 2);
}

TEST(FitOfCoils, of_a_spline_through_many_turns_of_few_points_has_the_right_length) {
  for (const Coil& coil :
       {Coil{0.1, 20, 1, 0, 5, Listing::forward}, Coil{0.1, 20, -1, 0.2, 12, Listing::backward},
        Coil{0.1, 80, 1, 0.03, 6, Listing::forward}}) {
    const ShapeFit fit = fitted(coil.points(7), ShapeModel::spline);
    // half a turn too many of 80 would be 0.006
    EXPECT_NEAR(fit.length / coil.length(), 1, coil.noise > 0 ? 2e-3 : 1e-4) << coil.name();
    const double per_radian = coil.turn_distance / (2 * pi);
    EXPECT_NEAR(fit.numbers[torsion].value, coil.hand * per_radian / (1 + per_radian * per_radian),
                1e-3)
        << coil.name();
    EXPECT_TRUE(fit.misfit.empty()) << coil.name() << ": " << fit.misfit;
  }
}

TEST(FitOfCoils, of_a_spline_through_exact_points_names_no_outliers) {
  Points cone(3, 161);
  for (Index i = 0; i < 161; ++i) {
    const double share = static_cast<double>(i) / 160, angle = 20 * pi * share;
    const double r = 1 + 0.5 * share;
    cone.col(i) << r * std::cos(angle), r * std::sin(angle), share;
  }
  const ShapeFit fit = fitted(measured(cone, false), ShapeModel::spline);
  EXPECT_TRUE(fit.outliers.empty());
  EXPECT_TRUE(fit.misfit.empty()) << fit.misfit;
}

TEST(FitOfCoils, with_many_errors_of_measurement_in_no_order_has_the_right_length_or_cannot_tell) {
  Index refused = 0;
  for (const double turns : {2.0, 5.0}) {
    for (const Index errors : {1, 3, 9, 21}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Coil coil{1, turns, 1, 0, static_cast<Index>(300 / turns), Listing::forward};
        MeasuredPoints points = coil.points(seed);
        Random random(seed + 10);
        for (Index k = 0; k < errors; ++k) {
          points.position.col((97 * k + 31) % points.count()) += normal_noise(1, 1, random).col(0);
        }
        try {
          const ShapeFit fit = fitted(shuffled(points, seed), ShapeModel::helix);
          EXPECT_NEAR(fit.length / coil.length(), 1, 0.02)
              << turns << " turns, " << errors << " errors, seed " << seed;
        } catch (const InvalidInput&) {
          ++refused;
          EXPECT_GE(50 * errors, points.count());  // fewer raise no doubt
        }
      }
    }
  }
  EXPECT_LE(refused, 12);  // of 24
}

TEST(FitOfCoils, in_no_order_is_refused_from_one_point_far_off_of_fifty_that_are_given) {
  for (const Index count : {100, 101}) {
    const Points exact = helix_points(count, 1, 0.3, 2, true, 3);
    MeasuredPoints points = measured(exact, false);
    points.position.col(20) += Vec3(30, 0, 0);  // so far off that no curve is drawn to them
    points.position.col(70) += Vec3(0, -50, 0);
    points = shuffled(points, 6);
    if (count == 100) {
      EXPECT_THROW(fit_shape(points, {ShapeModel::helix, false, {}}), InvalidInput);
      continue;
    }
    const ShapeFit fit = fitted(points, ShapeModel::helix);
    EXPECT_EQ(fit.left_out.size(), 2U);
    EXPECT_EQ(fit.outliers, fit.left_out);
    EXPECT_NEAR(fit.length / (4 * pi * std::hypot(1.0, 0.3)), 1, 1e-9);
  }
}

TEST(FitOfLoops, knows_a_closed_loop_in_no_order) {
  Random random(4);
  Points loop(3, 120);
  double around = 0;
  for (Index i = 0; i < 120; ++i) {
    const double a = 2 * pi * static_cast<double>(i) / 120;
    loop.col(i) = Vec3(3 * std::cos(a), 2 * std::sin(a), 0.3 * std::cos(2 * a));
  }
  for (Index i = 0; i < 120; ++i) around += (loop.col((i + 1) % 120) - loop.col(i)).norm();
  loop += normal_noise(120, 1e-3, random);
  const ShapeFit fit = fitted(shuffled(measured(loop), 2), ShapeModel::spline);
  EXPECT_TRUE(fit.closed);
  EXPECT_NEAR(fit.length / around, 1, 2e-3);
  // a coil whose turns end beside each other is none
  const Coil coil{0.1, 3, 1, 0, 20, Listing::forward};
  EXPECT_FALSE(fitted(coil.points(1), ShapeModel::spline).closed);
}

TEST(FitOfPartsOfAWire, joins_them_at_their_nearest_ends) {
  const Points exact = helix_points(200, 1, 0.3, 2, true, 5);
  Points parts(3, 200);
  parts.leftCols(80) = exact.leftCols(80).rowwise().reverse();
  parts.rightCols(120) = exact.rightCols(120);
  const double length = 4 * pi * std::hypot(1.0, 0.3);
  for (const ShapeModel model : {ShapeModel::helix, ShapeModel::spline}) {
    EXPECT_NEAR(fitted(measured(parts, false), model).length / length, 1, 1e-4);
  }
}

TEST(FitWithOneOutlier, of_any_size_at_any_place_is_the_fit_without_it_and_names_it) {
  Random random(8);
  const Points exact = helix_points(100, 1, 0.2, 1.5, true, 3) + normal_noise(100, 1e-3, random);
  for (const ShapeModel model : {ShapeModel::helix, ShapeModel::spline}) {
    const ShapeFit clean = fitted(measured(exact, false), model);
    for (const double size : {1.0, 1e2, 1e6, 1e20, 1e80}) {
      for (const Index place : {0, 1, 50, 99}) {
        Points spoilt = exact;
        spoilt.col(place) += size * Vec3(0.36, -0.48, 0.8);
        const ShapeFit fit = fitted(measured(spoilt, false), model);
        EXPECT_EQ(fit.outliers, std::vector<Index>{place}) << size;
        EXPECT_NEAR(fit.length / clean.length, 1, 0.012) << size << " at " << place;
        EXPECT_TRUE(std::isfinite(fit.distance[place]));
      }
    }
  }
}

TEST(FitOfAPicture, has_errors_of_two_dimensions) {
  Random random(6);
  double squares = 0, error = 0;
  constexpr int fits = 300;
  for (int i = 0; i < fits; ++i) {
    Points points = Points::Zero(3, 60);
    for (Index k = 0; k < 60; ++k) {
      const double a = 2.0 * static_cast<double>(k) / 59;
      points.col(k) << std::cos(a) + 0.004 * testing::normal(random),
          std::sin(a) + 0.004 * testing::normal(random), 0;
    }
    const ShapeFit fit = fitted(measured(points), ShapeModel::circle);
    EXPECT_TRUE(fit.planar);
    squares += std::pow(fit.numbers[radius].value - 1, 2) / fits;
    error += fit.numbers[radius].standard_error / fits;
  }
  // known to 1 / sqrt(2 * 300) = 4 %; counting the third dimension would make it 1.4
  EXPECT_NEAR(std::sqrt(squares) / error, 1, 0.12);
}

TEST(FitInAnyUnit, gives_the_same_shape) {
  Random random(2);
  const Points points = helix_points(150, 1, 0.2, 2, true, 4) + normal_noise(150, 0.01, random);
  for (const ShapeModel model : {ShapeModel::helix, ShapeModel::spline}) {
    const ShapeFit one = fitted(measured(points), model);
    for (const double unit : {1e-12, 1e-3, 1e3, 1e12}) {
      const ShapeFit other = fitted(measured(unit * points), model);
      EXPECT_NEAR(other.length / unit / one.length, 1, 1e-12);
      EXPECT_NEAR(other.numbers[curvature].value * unit / one.numbers[curvature].value, 1, 1e-12);
      EXPECT_NEAR(other.numbers[torsion].value * unit / one.numbers[torsion].value, 1, 1e-12);
    }
  }
}

TEST(FitWithArcs, refuses_arcs_that_are_shorter_than_their_chords) {
  Random random(3);
  MeasuredPoints points =
      measured(helix_points(60, 1, 0.1, 4, true, 1) + normal_noise(60, 0.01, random));
  const double length = 8 * pi * std::hypot(1.0, 0.1);
  points.arc = Eigen::VectorXd::LinSpaced(60, 0, length);
  EXPECT_NEAR(fitted(points, ShapeModel::helix).numbers[radius].value, 1, 0.02);
  for (const double factor : {0.0, 0.1, 0.5}) {
    MeasuredPoints wrong = points;
    wrong.arc *= factor;
    EXPECT_THROW(fit_shape(wrong, {ShapeModel::helix, false, {}}), InvalidInput) << factor;
  }
}

TEST(FitOfACircle, says_when_the_points_are_those_of_a_helix) {
  Random random(7);
  const Points helix = helix_points(120, 1, 0.1, 4, true, 2) + normal_noise(120, 0.01, random);
  for (const bool ordered : {true, false}) {
    MeasuredPoints points = measured(helix, ordered);
    if (!ordered) points = shuffled(points, 3);
    EXPECT_FALSE(fit_shape(points, {ShapeModel::circle, false, {}}).misfit.empty());
  }
  const Points circle = helix_points(120, 1, 0, 0.7, true, 2) + normal_noise(120, 0.01, random);
  EXPECT_TRUE(fitted(measured(circle, false), ShapeModel::circle).misfit.empty());
}

}  // namespace
}  // namespace wirepack
