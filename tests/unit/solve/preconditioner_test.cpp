#include "wirepack/solve/preconditioner.hpp"

#include <Eigen/Eigenvalues>
#include <atomic>
#include <csignal>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include "wirepack/core/random.hpp"
#include "wirepack/core/threads.hpp"

namespace wirepack {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Definiteness = Preconditioner::Definiteness;

Eigen::VectorXd random_vector(Index size, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXd v(size);
  for (double& value : v) value = random.symmetric();
  return v;
}

// Lower triangle of what a packing couples: nodes of three unknowns in a chain, and `contacts`
// pairs of others; squares of random vectors, so positive definite with the shift.
Sparse packing_matrix(Index nodes, Index contacts, double shift, std::uint64_t seed) {
  Random random(seed);
  std::map<std::pair<Index, Index>, double> entries;
  const auto add_square = [&](const std::vector<Index>& of_nodes) {
    std::vector<std::pair<Index, double>> g;
    for (const Index node : of_nodes) {
      for (Index c = 0; c < 3; ++c) g.emplace_back(3 * node + c, random.symmetric());
    }
    for (const auto& [row, a] : g) {
      for (const auto& [column, b] : g) {
        if (row >= column) entries[{column, row}] += a * b;
      }
    }
  };
  for (Index i = 0; i + 2 < nodes; ++i) {
    for (int k = 0; k < 3; ++k) add_square({i, i + 1, i + 2});
  }
  const auto any_node = [&] {
    return static_cast<Index>((random.symmetric() + 1) / 2 * static_cast<double>(nodes - 1));
  };
  for (Index k = 0; k < contacts; ++k) {
    const Index i = any_node(), j = any_node();
    if (std::abs(i - j) > 2) add_square({i, i + 1, j, j + 1});
  }
  for (Index u = 0; u < 3 * nodes; ++u) entries[{u, u}] += shift;
  Sparse lower(3 * nodes, 3 * nodes);
  for (const auto& [place, value] : entries) lower.insert(place.second, place.first) = value;
  lower.makeCompressed();
  return lower;
}

Eigen::VectorXd step_to_minimum(const Sparse& lower, double smallest,
                                const Eigen::VectorXd& force) {
  auto p = Preconditioner::factored(lower, smallest, Definiteness::positive);
  EXPECT_TRUE(p);
  Eigen::VectorXd y, step;
  p->to_gradient(force, y);
  p->to_step(y, step);
  return step;
}

TEST(Preconditioner, BothSolvesTogetherInvertTheMatrix) {
  // a chain alone, few contacts (small fronts alone), and so many that fronts are cut into tiles
  for (const auto& [nodes, contacts] :
       {std::pair<Index, Index>{2, 0}, {40, 0}, {150, 200}, {700, 4000}}) {
    const Sparse lower = packing_matrix(nodes, contacts, 1e-3, 7);
    const Eigen::VectorXd x = random_vector(lower.rows(), 1);
    const Eigen::VectorXd force = lower.selfadjointView<Eigen::Lower>() * x;
    const double exact = (step_to_minimum(lower, 1e-12, force) - x).norm() / x.norm();
    EXPECT_LT(exact, 1e-10) << nodes << " nodes in double precision";
    const double rounded = (step_to_minimum(lower, 1e-1, force) - x).norm() / x.norm();
    EXPECT_LT(rounded, 1e-2) << nodes << " nodes in single precision";
    EXPECT_GT(rounded, 1e-12) << "that was double precision";
  }
}

TEST(Preconditioner, StepAndGradientAreEachOthersTranspose) {
  const Sparse lower = packing_matrix(300, 500, 1e-3, 3);
  auto p = Preconditioner::factored(lower, 1e-1, Definiteness::positive);
  ASSERT_TRUE(p);
  const Eigen::VectorXd y = random_vector(lower.rows(), 1), g = random_vector(lower.rows(), 2);
  Eigen::VectorXd step, by_y;
  p->to_step(y, step);
  p->to_gradient(g, by_y);
  EXPECT_NEAR(g.dot(step) / by_y.dot(y), 1, 1e-12);
}

// Lower triangle of a cube of nodes, three unknowns each, coupled to all 26 around them.
Sparse cube_matrix(Index side) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto in_reach = [](Index i, Index j) { return std::abs(i - j) <= 1; };
  const auto layer = side * side;
  for (Index n = 0; n < side * layer; ++n) {
    for (Index m = n; m < std::min(side * layer, n + layer + side + 2); ++m) {
      if (!in_reach(n / layer, m / layer) || !in_reach(n / side % side, m / side % side) ||
          !in_reach(n % side, m % side)) {
        continue;
      }
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < (m == n ? a + 1 : 3); ++b) {
          const bool diagonal = m == n && a == b;
          entries.emplace_back(3 * m + a, 3 * n + b, diagonal ? 30 : a == b ? -1 : 0.01);
        }
      }
    }
  }
  Sparse lower(3 * side * layer, 3 * side * layer);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

TEST(Preconditioner, ALargeCubeIsDissectedAndItsFactorHasFewerEntries) {
  // 2.6 million by minimum degree
  const Sparse lower = cube_matrix(13);
  auto p = Preconditioner::factored(lower, 1e-12, Definiteness::positive);
  ASSERT_TRUE(p);
  EXPECT_LT(p->factor_size(), 2.4e6);
  const Eigen::VectorXd x = random_vector(lower.rows(), 1);
  const Eigen::VectorXd force = lower.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((step_to_minimum(lower, 1e-12, force) - x).norm(), 1e-10 * x.norm());
}

TEST(Preconditioner, AnOrderServesMatricesOfOtherPatternsToo) {
  const Sparse before = packing_matrix(300, 500, 1e-3, 3),
               after = packing_matrix(300, 600, 1e-3, 9);
  const auto first = Preconditioner::factored(before, 1e-12, Definiteness::positive);
  const auto again =
      Preconditioner::factored(before, 1e-12, Definiteness::positive, first->order());
  EXPECT_EQ(again->factor_size(), first->factor_size());
  auto other = Preconditioner::factored(after, 1e-12, Definiteness::positive, first->order());
  ASSERT_TRUE(other);
  const Eigen::VectorXd x = random_vector(after.rows(), 1);
  Eigen::VectorXd y, step;
  other->to_gradient(after.selfadjointView<Eigen::Lower>() * x, y);
  other->to_step(y, step);
  EXPECT_LT((step - x).norm(), 1e-10 * x.norm());
  EXPECT_TRUE(is_positive_definite(after, 1e-12, first->order()));
}

std::atomic<int> terminations = 0;

TEST(Preconditioner, NoSignalIsLostWhileAnOrderIsSought) {
  struct sigaction told {
  }, before{}, after{};
  told.sa_handler = [](int) { ++terminations; };
  sigaction(SIGTERM, &told, &before);
  std::atomic<bool> ended = false;
  std::atomic<int> sent = 0;
  std::thread sender([&] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    while (!ended) {
      const int seen = terminations;
      kill(getpid(), SIGTERM);
      ++sent;
      while (terminations == seen && !ended) std::this_thread::yield();
    }
  });
  const Sparse lower = cube_matrix(13);
  while (sent < 20) EXPECT_TRUE(is_positive_definite(lower, 1e-1));
  ended = true;
  sender.join();
  sigaction(SIGTERM, &before, &after);
  EXPECT_EQ(after.sa_handler, told.sa_handler);
  EXPECT_GE(terminations, sent - 1);
}

TEST(Preconditioner, NumberOfThreadsChangesNoBit) {
  const Sparse lower = packing_matrix(700, 4000, 1e-3, 5);
  const Eigen::VectorXd force = random_vector(lower.rows(), 1);
  for (const double smallest : {1e-1, 1e-12}) {
    use_threads(1);
    const Eigen::VectorXd alone = step_to_minimum(lower, smallest, force);
    for (const int threads : {2, 5}) {
      use_threads(threads);
      EXPECT_EQ(step_to_minimum(lower, smallest, force), alone) << threads << " threads";
    }
  }
  use_threads(1);
}

// Where the heap has room differs between threads and between a run and its continuation.
TEST(Preconditioner, PlaceInMemoryChangesNoBit) {
  for (const auto& [nodes, contacts] : {std::pair<Index, Index>{400, 50}, {700, 4000}}) {
    const Sparse lower = packing_matrix(nodes, contacts, 1e-3, 6);
    const Eigen::VectorXd force = random_vector(lower.rows(), 1);
    for (const double smallest : {1e-1, 1e-12}) {
      const Eigen::VectorXd first = step_to_minimum(lower, smallest, force);
      std::vector<std::unique_ptr<char[]>> in_the_way;
      for (std::size_t k = 1; k <= 10; ++k) {
        for (std::size_t i = 0; i < 200; ++i) {
          in_the_way.push_back(std::make_unique<char[]>(16 * ((7 * i + k) % 50) + 24));
        }
        for (std::size_t i = k % 3; i < in_the_way.size(); i += 3) in_the_way[i].reset();
        EXPECT_EQ(step_to_minimum(lower, smallest, force), first) << nodes << " nodes, " << k;
      }
    }
  }
}

TEST(Preconditioner, MatrixThatIsNotPositiveDefiniteHasNone) {
  Sparse lower = packing_matrix(200, 300, 1e-3, 2);
  lower.coeffRef(301, 301) -= 2 * lower.coeff(301, 301);
  for (const Definiteness definiteness : {Definiteness::positive, Definiteness::unknown}) {
    EXPECT_FALSE(Preconditioner::factored(lower, 1e-1, definiteness));
    EXPECT_FALSE(Preconditioner::factored(lower, 1e-12, definiteness));
  }
}

TEST(Preconditioner, AMatrixIsPositiveDefiniteWhereItHasAFactor) {
  const Sparse lower = packing_matrix(200, 300, 1e-3, 3);
  const Eigen::MatrixXd whole = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  const double lowest = whole.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
  Sparse shifted = lower;
  for (const double smallest : {1e-1, 1e-12}) {
    for (const double share : {0.9, 1.1}) {
      for (Index k = 0; k < lower.rows(); ++k) {
        shifted.coeffRef(k, k) = lower.coeff(k, k) - share * lowest;
      }
      EXPECT_EQ(is_positive_definite(shifted, smallest), share < 1) << smallest;
      EXPECT_EQ(Preconditioner::factored(shifted, smallest, Definiteness::unknown).has_value(),
                share < 1);
    }
  }
}

// Rounding in single precision can make pivots negative that are not.
TEST(Preconditioner, DoublePrecisionServesWhereSingleFindsNoPositivePivot) {
  // the end of a chain without squares of its own: nothing but a billionth holds it
  Sparse lower(2, 2);
  lower.insert(0, 0) = 1;
  lower.insert(1, 0) = 1 / 3.;
  lower.insert(1, 1) = 1 / 9. + 1e-9;
  lower.makeCompressed();
  const Eigen::VectorXd step = step_to_minimum(lower, 1e-1, Eigen::Vector2d(0, 1));
  EXPECT_NEAR(step[1] * 1e-9, 1, 1e-6);
  EXPECT_FALSE(Preconditioner::factored(lower, 1e-1, Definiteness::unknown))
      << "an indefinite matrix would be factored twice in vain";
}

}  // namespace
}  // namespace wirepack
