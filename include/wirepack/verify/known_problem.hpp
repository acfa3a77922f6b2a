#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wirepack {

/// One number of a problem whose answer is known, as the library computes it on this machine.
struct KnownProblem {
  std::string name;      ///< what is computed, with its unit
  double exact;          ///< closed form, or a published number
  double measured;       ///< by the library
  double tolerance;      ///< on error()
  std::string_view why;  ///< where the tolerance comes from

  /// |measured / exact - 1|, or |measured| where the exact answer is 0.
  double error() const;
  bool passed() const { return error() <= tolerance; }  // not for NaN
};

/// Problems that belong together. Running a group takes seconds at most; it may throw
/// NumericalFailure.
struct KnownProblemGroup {
  std::string_view name;
  std::vector<KnownProblem> (*run)();
};

/// All groups, in the order of the layers they test.
std::span<const KnownProblemGroup> known_problem_groups();

}  // namespace wirepack
