#include "tube.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

SmoothLine smooth_line(const Points& nodes, const Eigen::VectorXd& colour, Index parts) {
  const Index n = nodes.cols();
  const auto slope = [&](Index i) -> Vec3 {
    return (nodes.col(std::min(i + 1, n - 1)) - nodes.col(std::max<Index>(i - 1, 0))) /
           static_cast<double>(std::min(i + 1, n - 1) - std::max<Index>(i - 1, 0));
  };
  SmoothLine line{Points(3, (n - 1) * parts + 1), Eigen::VectorXd((n - 1) * parts + 1)};
  for (Index k = 0; k < line.points.cols(); ++k) {
    const Index i = std::min(k / parts, n - 2);
    const double u = static_cast<double>(k - i * parts) / static_cast<double>(parts);
    line.points.col(k) = (1 + 2 * u) * (1 - u) * (1 - u) * nodes.col(i) +
                         u * (1 - u) * (1 - u) * slope(i) + u * u * (3 - 2 * u) * nodes.col(i + 1) +
                         u * u * (u - 1) * slope(i + 1);
    line.colour[k] = (1 - u) * colour[i] + u * colour[i + 1];
  }
  return line;
}

Points tube_rings(const Points& line, double radius, Index around) {
  const Index n = line.cols();
  const auto direction = [&](Index k) -> Vec3 {
    return (line.col(std::min(k + 1, n - 1)) - line.col(std::max<Index>(k - 1, 0))).normalized();
  };
  Points rings(3, n * around);
  Quat frame = frame_with_tangent(direction(0));
  for (Index k = 0; k < n; ++k) {
    frame = (transport(third_axis(frame), direction(k)) * frame).normalized();
    for (Index j = 0; j < around; ++j) {
      const double angle = 2 * pi * static_cast<double>(j) / static_cast<double>(around);
      rings.col(k * around + j) =
          line.col(k) + frame * Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
  }
  return rings;
}

}  // namespace wirepack
