#include "block_means.hpp"

#include <algorithm>

namespace wirepack {

BlockMeans block_means(const MeasuredPoints& points, Index most) {
  // all of one size, or their scatter and their shift inwards in a bend would jump
  const Index n = points.count(), size = (n + most - 1) / most, count = (n + size - 1) / size;
  BlockMeans result;
  MeasuredPoints& means = result.points;
  means.ordered = points.ordered;
  means.position = Points::Zero(3, count);
  if (points.arc.size() > 0) means.arc = Eigen::VectorXd::Zero(count);
  if (points.sigma.size() > 0) means.sigma = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd members = Eigen::VectorXd::Zero(count);
  for (Index i = 0; i < n; ++i) {
    const Index b = i / size;
    result.of_point.push_back(b);
    means.position.col(b) += points.position.col(i);
    if (points.arc.size() > 0) means.arc[b] += points.arc[i];
    if (points.sigma.size() > 0) means.sigma[b] += points.sigma[i] * points.sigma[i];
    members[b] += 1;
  }
  for (Index b = 0; b < count; ++b) means.position.col(b) /= members[b];
  if (points.arc.size() > 0) means.arc = means.arc.cwiseQuotient(members);
  if (points.sigma.size() > 0) means.sigma = means.sigma.cwiseSqrt().cwiseQuotient(members);
  return result;
}

Eigen::VectorXd means_over(const BlockMeans& blocks, const Eigen::VectorXd& numbers) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(blocks.points.count()), count = sum;
  for (Index i = 0; i < numbers.size(); ++i) {
    const Index b = blocks.of_point[static_cast<std::size_t>(i)];
    sum[b] += numbers[i];
    count[b] += 1;
  }
  return sum.cwiseQuotient(count);
}

}  // namespace wirepack
