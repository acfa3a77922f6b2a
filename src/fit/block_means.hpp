#pragma once

#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/fit/measured_points.hpp"

namespace wirepack {

/// Means of runs of successive points: less scatter, and an order that it does not disturb.
struct BlockMeans {
  MeasuredPoints points;        ///< at most `most`; as many as there are of fewer points
  std::vector<Index> of_point;  ///< the mean that each point is in
};
constexpr Index most_block_means = 600;
BlockMeans block_means(const MeasuredPoints& points, Index most = most_block_means);

/// Means of numbers of all points over the same runs.
Eigen::VectorXd means_over(const BlockMeans& blocks, const Eigen::VectorXd& numbers);

}  // namespace wirepack
