#include "misfit.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <vector>

#include "index_lists.hpp"

namespace wirepack {

namespace {

constexpr double clear = 4;  // standard deviations

// Root mean square of the residuals along the binormal of the curve (the axis of a circle, and
// nearly that of a flat coil) over that along its normal.
double binormal_share(const CurveSolution& solution) {
  double along = 0, across = 0;
  for (Index i = 0; i < solution.residual.cols(); ++i) {
    const double s = solution.feet[i];
    const Vec3 k = solution.curve.darboux(s);
    const Mat3 directors = solution.curve.at(s).directors;
    const Vec3 binormal = directors.leftCols<2>() * k.head<2>().normalized();
    const Vec3 normal = directors.col(2).cross(binormal);
    along += std::pow(binormal.dot(solution.residual.col(i)), 2);
    across += std::pow(normal.dot(solution.residual.col(i)), 2);
  }
  return std::sqrt(along / std::max(across, 1e-300));
}

// Beyond what scatter alike in both directions leads to.
bool scatters_along_binormal(const CurveSolution& solution) {
  return binormal_share(solution) > 1 + 2 * clear / std::sqrt(double(solution.feet.size()));
}

// Of the residuals of points that follow on each other in an order.
double correlation_in(const std::vector<Index>& order, const CurveSolution& solution) {
  double product = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    product += solution.residual.col(order[k - 1]).dot(solution.residual.col(order[k]));
  }
  const double squares = solution.residual.squaredNorm();
  return squares > 0 ? product / squares : 0;
}

// A curve that is far off mixes points of several turns along it; in the order of the wire its
// residuals still go together.
double list_correlation(const MeasuredPoints& points, const CurveSolution& solution) {
  if (!points.ordered) return 0;
  std::vector<Index> order(static_cast<std::size_t>(points.count()));
  std::iota(order.begin(), order.end(), Index{0});
  return correlation_in(order, solution);
}

}  // namespace

double neighbour_correlation(const CurveSolution& solution) {
  return correlation_in(order_by(solution.feet), solution);
}

std::string misfit_of(ShapeModel model, const MeasuredPoints& points, const CurveSolution& solution,
                      const Uncertainty& uncertainty) {
  const auto n = static_cast<double>(points.count());
  if (!(solution.rms_distance() > std::max(points.resolution, finest_residual(model)))) return {};
  if (points.sigma.size() > 0 && !(solution.huber > 0)) {
    const auto freedom = static_cast<double>(std::max<Index>(uncertainty.degrees_of_freedom, 1));
    const double share = solution.weighted_distance.squaredNorm() / freedom;
    if (share > 1.5 && share > 1 + clear * std::sqrt(2 / freedom)) {
      return fmt::format("chi_square is {:.3g} per degree of freedom", share);
    }
  }
  const double correlation =
      std::max(neighbour_correlation(solution), list_correlation(points, solution));
  if (correlation * std::sqrt(n) > 3 && correlation > 0.3) {
    return fmt::format(
        "neighbouring points lie off to the same side (their residuals have a correlation of "
        "{:.2f})",
        correlation);
  }
  if (model == ShapeModel::circle && solution.rows == 2 && !uncertainty.planar) {
    if (scatters_along_binormal(solution)) {
      return fmt::format(
          "the points leave the plane of the circle by {:.3g} times what they are off it in the "
          "plane",
          binormal_share(solution));
    }
  }
  return {};
}

bool tells_turns(const CurveSolution& solution) {
  const Vec3 k = solution.curve.darboux(0);
  const double curvature = k.head<2>().norm(), rate = k.norm();
  double squares = 0;
  for (Index i = 0; i < solution.residual.cols(); ++i) {
    const Mat3 directors = solution.curve.at(solution.feet[i]).directors;
    const Vec3 binormal = directors.leftCols<2>() * k.head<2>() / curvature;
    squares += std::pow(binormal.dot(solution.residual.col(i)), 2);
  }
  const double scatter = std::sqrt(squares / static_cast<double>(solution.residual.cols()));
  const double apart = 2 * pi * std::abs(k.z()) * curvature / (rate * rate * rate);
  // Points anywhere would scatter by 0.29 of the distance of the turns, few of them also by less.
  const double few = 3 / std::sqrt(static_cast<double>(solution.residual.cols()));
  return scatter < 0.18 * (1 - few) * apart;
}

bool may_join_turns(const CurveSolution& solution, const Uncertainty& uncertainty) {
  return !uncertainty.planar && solution.rms_distance() > 5e-4 && scatters_along_binormal(solution);
}

}  // namespace wirepack
