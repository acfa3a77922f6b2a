#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace wirepack {

/// What searches for equilibria have cost. Seconds are for reports alone: they decide nothing.
struct SolverWork {
  std::int64_t evaluations = 0;
  std::int64_t factorizations = 0;
  std::int64_t rounds_taken_back = 0;
  std::int64_t list_builds = 0;

  double energy_seconds = 0;         ///< energies and their gradients
  double list_seconds = 0;           ///< neighbor lists: the test whether they serve, and new ones
  double chart_seconds = 0;          ///< unknowns to state, and derivatives back
  double solve_seconds = 0;          ///< triangular solves of the preconditioner
  double factorization_seconds = 0;  ///< curvature model: assembly, ordering, factor
  double descent_seconds = 0;        ///< L-BFGS: its vectors and its line search
  double passage_seconds = 0;        ///< whether strands have passed through each other
  double stability_seconds = 0;      ///< whether an equilibrium is a minimum

  SolverWork& operator+=(const SolverWork& other);
};

template <class T>
struct WorkEntry {
  std::string_view name;   // in files
  std::string_view label;  // in summaries
  T SolverWork::*value;
};

inline constexpr std::array<WorkEntry<std::int64_t>, 4> work_counts{{
    {"evaluations", "evaluations", &SolverWork::evaluations},
    {"factorizations", "factorizations", &SolverWork::factorizations},
    {"rounds_taken_back", "rounds taken back", &SolverWork::rounds_taken_back},
    {"list_builds", "neighbor lists made", &SolverWork::list_builds},
}};

inline constexpr std::array<WorkEntry<double>, 8> work_seconds{{
    {"energy_seconds", "energies", &SolverWork::energy_seconds},
    {"list_seconds", "neighbor lists", &SolverWork::list_seconds},
    {"chart_seconds", "chart", &SolverWork::chart_seconds},
    {"solve_seconds", "triangular solves", &SolverWork::solve_seconds},
    {"factorization_seconds", "factorizations", &SolverWork::factorization_seconds},
    {"descent_seconds", "L-BFGS", &SolverWork::descent_seconds},
    {"passage_seconds", "passages of strands", &SolverWork::passage_seconds},
    {"stability_seconds", "tests for a minimum", &SolverWork::stability_seconds},
}};

inline SolverWork& SolverWork::operator+=(const SolverWork& other) {
  for (const auto& entry : work_counts) this->*entry.value += other.*entry.value;
  for (const auto& entry : work_seconds) this->*entry.value += other.*entry.value;
  return *this;
}

}  // namespace wirepack
