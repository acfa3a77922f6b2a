#include "chosen_points.hpp"

namespace wirepack {

MeasuredPoints chosen(const MeasuredPoints& points, const std::vector<Index>& which) {
  MeasuredPoints result;
  result.ordered = points.ordered;
  result.resolution = points.resolution;
  result.position = points.position(Eigen::all, which);
  if (points.arc.size() > 0) result.arc = points.arc(which);
  if (points.sigma.size() > 0) result.sigma = points.sigma(which);
  for (const Index i : which) {
    if (!points.line.empty()) result.line.push_back(points.line[static_cast<std::size_t>(i)]);
  }
  return result;
}

}  // namespace wirepack
