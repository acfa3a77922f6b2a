#include "wirepack/verify/known_problem.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace wirepack {
namespace {

TEST(KnownProblem, ErrorIsRelativeUnlessTheAnswerIsZero) {
  EXPECT_DOUBLE_EQ((KnownProblem{"", 4, 5, 0.1, ""}).error(), 0.25);
  EXPECT_DOUBLE_EQ((KnownProblem{"", -4, 4, 0.1, ""}).error(), 2);
  EXPECT_DOUBLE_EQ((KnownProblem{"", 0, -1e-3, 0.1, ""}).error(), 1e-3);
}

TEST(KnownProblem, PassesWithinItsToleranceAndNeverOnNotANumber) {
  EXPECT_TRUE((KnownProblem{"", 2, 2.02, 0.011, ""}).passed());
  EXPECT_FALSE((KnownProblem{"", 2, 2.02, 0.009, ""}).passed());
  EXPECT_FALSE((KnownProblem{"", 2, std::nan(""), 1, ""}).passed());
  EXPECT_FALSE((KnownProblem{"", 0, std::nan(""), 1, ""}).passed());
}

class KnownProblems : public ::testing::TestWithParam<KnownProblemGroup> {};

TEST_P(KnownProblems, AreSolvedWithinTheirTolerances) {
  const auto problems = GetParam().run();
  EXPECT_FALSE(problems.empty());
  for (const KnownProblem& problem : problems) {
    EXPECT_TRUE(problem.passed()) << problem.name << ": " << problem.measured << " for "
                                  << problem.exact << ", error " << problem.error() << " > "
                                  << problem.tolerance << " (" << problem.why << ")";
    EXPECT_LT(problem.tolerance, 0.5);  // none would take a wrong factor of 2
  }
}

std::string test_name(const ::testing::TestParamInfo<KnownProblemGroup>& group) {
  std::string name;
  for (const char c : group.param.name) {
    if (c != ' ') name += c;
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Groups, KnownProblems,
                         ::testing::ValuesIn(known_problem_groups().begin(),
                                             known_problem_groups().end()),
                         test_name);

}  // namespace
}  // namespace wirepack
