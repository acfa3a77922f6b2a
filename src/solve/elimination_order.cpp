#include "elimination_order.hpp"

#include <Eigen/OrderingMethods>
#include <csignal>
#include <metis.h>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

using List = std::vector<int>;

// From so many groups on dissection pays.
constexpr int many_groups = 1000;

List minimum_degree_order(const Graph& graph) {
  using Pattern = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  const std::vector<double> values(graph.list.size(), 1);
  const Pattern pattern =
      Eigen::Map<const Pattern>(graph.size(), graph.size(), graph.start.back(), graph.start.data(),
                                graph.list.data(), values.data());
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().data(), order.indices().data() + graph.size()};
}

// METIS takes SIGTERM for a fault of its own, and jumps: fatal in another thread than the one that
// calls it. While this lives the signal waits, and then meets the handler that it was meant for.
// The threads of computations take none (run_shared).
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t terminate;
    sigemptyset(&terminate);
    sigaddset(&terminate, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &terminate, &mask_);
    sigaction(SIGTERM, nullptr, &on_terminate_);
    sigaction(SIGABRT, nullptr, &on_abort_);
  }
  ~SignalsWait() {
    sigaction(SIGABRT, &on_abort_, nullptr);
    sigaction(SIGTERM, &on_terminate_, nullptr);
    pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t mask_{};
  struct sigaction on_terminate_ {
  }, on_abort_{};
};

List dissection_order(const ColumnGroups& groups) {
  idx_t count = groups.size();
  std::vector<idx_t> start{0}, list, width, order(groups.graph.start.size() - 1), place(order);
  for (int g = 0; g < groups.size(); ++g) {
    groups.graph.for_each_neighbor(g, [&](int other) {
      if (other != g) list.push_back(other);
    });
    start.push_back(static_cast<idx_t>(list.size()));
    width.push_back(groups.width(g));
  }
  std::vector<idx_t> options(METIS_NOPTIONS);
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_COMPRESS] = 0;  // groups are of one pattern already
  const SignalsWait signals;
  if (METIS_NodeND(&count, start.data(), list.data(), width.data(), options.data(), order.data(),
                   place.data()) != METIS_OK) {
    throw NumericalFailure("METIS finds no order of elimination; is there memory left?");
  }
  return {order.begin(), order.end()};
}

}  // namespace

List elimination_order(const ColumnGroups& groups) {
  return groups.size() < many_groups ? minimum_degree_order(groups.graph)
                                     : dissection_order(groups);
}

}  // namespace wirepack
