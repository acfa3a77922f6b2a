#include "misfit.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <vector>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

// Of the residuals of neighbours along the curve.
double neighbour_correlation(const CurveSolution& solution) {
  std::vector<Index> order(static_cast<std::size_t>(solution.feet.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return solution.feet[a] < solution.feet[b]; });
  double product = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    product += solution.residual.col(order[k - 1]).dot(solution.residual.col(order[k]));
  }
  const double squares = solution.residual.squaredNorm();
  return squares > 0 ? product / squares : 0;
}

// Root mean square of the residuals along the axis of a circle over that in its plane.
double axial_share(const CurveSolution& solution) {
  const Vec3 k = solution.curve.darboux(0);
  double axial = 0, radial = 0;
  for (Index i = 0; i < solution.residual.cols(); ++i) {
    const Mat3 directors = solution.curve.at(solution.feet[i]).directors;
    const double along = (directors * k).normalized().dot(solution.residual.col(i));
    axial += along * along;
    radial += solution.residual.col(i).squaredNorm() - along * along;
  }
  return std::sqrt(axial / std::max(radial, 1e-300));
}

}  // namespace

std::string misfit_of(ShapeModel model, const MeasuredPoints& points, const CurveSolution& solution,
                      const Uncertainty& uncertainty) {
  constexpr double round_off = 1e-9;  // of the extent of the points
  constexpr double clear = 4;         // standard deviations
  const auto n = static_cast<double>(points.count());
  const double rms = std::sqrt(solution.distance.squaredNorm() / n);
  if (!(rms > std::max(points.resolution, round_off))) return {};
  if (points.sigma.size() > 0 && !(solution.huber > 0)) {
    const auto freedom = static_cast<double>(std::max<Index>(uncertainty.degrees_of_freedom, 1));
    const double share = solution.weighted_distance.squaredNorm() / freedom;
    if (share > 1.5 && share > 1 + clear * std::sqrt(2 / freedom)) {
      return fmt::format("chi_square is {:.3g} per degree of freedom", share);
    }
  }
  const double correlation = neighbour_correlation(solution);
  if (correlation * std::sqrt(n) > clear && correlation > 0.3) {
    return fmt::format(
        "neighbouring points lie off to the same side (their residuals have a correlation of "
        "{:.2f})",
        correlation);
  }
  if (model == ShapeModel::circle && solution.rows == 2 && !uncertainty.planar) {
    const double share = axial_share(solution);
    if (share > 1 + 2 * clear / std::sqrt(n)) {
      return fmt::format(
          "the points leave the plane of the circle by {:.3g} times what they are off it in the "
          "plane",
          share);
    }
  }
  return {};
}

void check_turns(const CurveSolution& solution) {
  const Vec3 k = solution.curve.darboux(0);
  const double curvature = k.head<2>().norm(), rate = k.norm();
  const double length = solution.feet.maxCoeff() - solution.feet.minCoeff();
  if (!(rate * length > 3 * pi)) return;
  double squares = 0;
  for (Index i = 0; i < solution.residual.cols(); ++i) {
    const Mat3 directors = solution.curve.at(solution.feet[i]).directors;
    const Vec3 binormal = directors.leftCols<2>() * k.head<2>() / curvature;
    const double along = binormal.dot(solution.residual.col(i));
    squares += along * along;
  }
  const double scatter = std::sqrt(squares / static_cast<double>(solution.residual.cols()));
  const double apart = 2 * pi * std::abs(k.z()) * curvature / (rate * rate * rate);
  // Points anywhere would scatter by 0.29 of the distance of the turns.
  if (scatter < 0.18 * apart) return;
  throw InvalidInput(
      "the points cannot tell the turns of a helix apart: they come in no order, and scatter by as "
      "much as turns are apart; give them in order, with --ordered, or with their arc lengths");
}

}  // namespace wirepack
