#include "wirepack/core/random.hpp"

#include <gtest/gtest.h>

namespace wirepack {
namespace {

TEST(RandomNumbers, FollowThePublishedSequence) {
  // SplitMix64 of Steele, Lea, Flood 2014 from seed 1234567, as published with its reference code
  Random random(1234567);
  for (const std::uint64_t expected :
       {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
        4593380528125082431ULL, 16408922859458223821ULL}) {
    EXPECT_EQ(random.next(), expected);
  }
}

TEST(RandomNumbers, GoOnFromAStoredState) {
  Random random(42);
  for (int k = 0; k < 10; ++k) random.next();
  Random resumed(random.state());
  for (int k = 0; k < 10; ++k) EXPECT_EQ(resumed.symmetric(), random.symmetric());
}

TEST(RandomNumbers, FillTheIntervalFromMinusOneToOneEvenly) {
  Random random(7);
  const int count = 100000;
  double sum = 0, squares = 0, low = 1, high = -1;
  for (int k = 0; k < count; ++k) {
    const double x = random.symmetric();
    sum += x;
    squares += x * x;
    low = x < low ? x : low;
    high = x > high ? x : high;
  }
  EXPECT_GE(low, -1);
  EXPECT_LT(high, 1);
  EXPECT_LT(low, -0.999);
  EXPECT_GT(high, 0.999);
  EXPECT_NEAR(sum / count, 0, 0.01);             // 5 standard errors of 1/sqrt(3 count)
  EXPECT_NEAR(squares / count, 1.0 / 3, 0.005);  // 5 standard errors of sqrt(4/45 / count)
}

}  // namespace
}  // namespace wirepack
