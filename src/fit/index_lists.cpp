#include "index_lists.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace wirepack {

std::vector<Index> consecutive(Index first, Index count) {
  std::vector<Index> list(static_cast<std::size_t>(count));
  std::iota(list.begin(), list.end(), first);
  return list;
}

std::vector<Index> order_by(const Eigen::VectorXd& values) {
  std::vector<Index> order = consecutive(0, values.size());
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return values[a] < values[b]; });
  return order;
}

std::vector<Index> picked(const std::vector<Index>& list, const std::vector<Index>& places) {
  std::vector<Index> result;
  for (const Index i : places) result.push_back(list[static_cast<std::size_t>(i)]);
  return result;
}

std::vector<Index> all_without(Index count, const std::vector<Index>& sorted) {
  const std::vector<Index> all = consecutive(0, count);
  std::vector<Index> rest;
  std::set_difference(all.begin(), all.end(), sorted.begin(), sorted.end(),
                      std::back_inserter(rest));
  return rest;
}

}  // namespace wirepack
