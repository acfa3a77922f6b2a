#include "shape_numbers.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace wirepack {

namespace {

constexpr double straight = 1e-9;  // curvature of round-off, over the extent of the points
constexpr double straight_significance = 11.8;  // chi^2 of two numbers, as rare as three sigma

/// Numbers of a shape as functions of the unknowns: curvature, torsion[, radius, pitch].
Eigen::VectorXd numbers_of(ShapeModel model, const DarbouxCurve& curve,
                           const Eigen::VectorXd& unknowns, double first, double last) {
  if (model != ShapeModel::spline) {
    const Vec3 k = curve.basis().darboux(unknowns, 0);
    const double curvature = k.head<2>().norm(), torsion = k.z();
    const double rate2 = curvature * curvature + torsion * torsion;
    return Eigen::Vector4d(curvature, torsion, curvature / rate2, 2 * pi * torsion / rate2);
  }
  // Means along the wire. In frames without twist, torsion is the rate at which the direction of
  // bending turns.
  const Index parts = 32 * curve.basis().intervals;
  const double step = (last - first) / static_cast<double>(parts);
  double curvature = 0, turn = 0;
  Vec3 before = curve.basis().darboux(unknowns, first);
  for (Index i = 0; i < parts; ++i) {
    const double arc = first + step * static_cast<double>(i);
    curvature += curve.basis().darboux(unknowns, arc + step / 2).norm();
    const Vec3 after = curve.basis().darboux(unknowns, arc + step);
    turn += std::atan2(before.cross(after).z(), before.dot(after));
    before = after;
  }
  return Eigen::Vector2d(curvature / static_cast<double>(parts), turn / (last - first));
}

// The curvature differs from 0 by more than its errors, all along the curve.
bool is_bent(const CurveSolution& solution, const Uncertainty& uncertainty, double first,
             double last) {
  const DarbouxBasis& basis = solution.curve.basis();
  const Index samples = basis.intervals > 0 ? 4 * basis.intervals + 1 : 1;
  for (Index i = 0; i < samples; ++i) {
    const double arc = samples > 1 ? first + (last - first) * static_cast<double>(i) /
                                                 static_cast<double>(samples - 1)
                                   : 0;
    Eigen::Matrix2Xd rows = Eigen::Matrix2Xd::Zero(2, solution.curve.size());
    for (const auto& w : basis.weights(arc)) {
      if (w.component < 2) rows(w.component, DarbouxCurve::pose_size + w.unknown) = w.value;
    }
    const Eigen::Vector2d k = rows * solution.curve.unknowns();
    const Eigen::Matrix2d covariance = rows * uncertainty.covariance * rows.transpose();
    if (!(k.norm() > straight)) return false;
    if (!(k.dot(covariance.fullPivLu().solve(k)) > straight_significance)) return false;
  }
  return true;
}

}  // namespace

ShapeNumbers shape_numbers(ShapeModel model, const CurveSolution& solution,
                           const Uncertainty& uncertainty, double first, double last, double unit) {
  ShapeNumbers result;
  const Eigen::VectorXd& unknowns = solution.curve.unknowns();
  const Eigen::VectorXd values = numbers_of(model, solution.curve, unknowns, first, last);
  const bool bent = is_bent(solution, uncertainty, first, last);
  const Index count = values.size();
  Eigen::MatrixXd by_unknown = Eigen::MatrixXd::Zero(count, unknowns.size());
  for (Index i = DarbouxCurve::pose_size; i < unknowns.size(); ++i) {
    const double h = 1e-5 * std::max(1e-3, unknowns.tail(solution.curve.basis().size()).norm());
    Eigen::VectorXd up = unknowns, down = unknowns;
    up[i] += h;
    down[i] -= h;
    by_unknown.col(i) = (numbers_of(model, solution.curve, up, first, last) -
                         numbers_of(model, solution.curve, down, first, last)) /
                        (2 * h);
  }
  Eigen::MatrixXd covariance = by_unknown * uncertainty.covariance * by_unknown.transpose();
  const std::array<const char*, 4> names{"curvature", "torsion", "radius", "pitch"};
  const std::array<double, 4> units{1 / unit, 1 / unit, unit, unit};
  std::vector<bool> counts;
  for (Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    ShapeNumber number{names[k], values[i] * units[k], std::sqrt(covariance(i, i)) * units[k]};
    number.fixed = model == ShapeModel::circle && (i == 1 || i == 3);
    const bool hidden = uncertainty.unknown_directions.cols() > 0 &&
                        (by_unknown.row(i) * uncertainty.unknown_directions).norm() >
                            (uncertainty.planar ? 0.1 : 1e-6) * by_unknown.row(i).norm();
    number.determined = (number.fixed && (bent || i == 1)) || (!hidden && (bent || i == 0));
    if (i == 0 && !bent && model != ShapeModel::spline) {
      // the length of (k1, k2) has no derivative at 0; either component has this error
      const auto block =
          uncertainty.covariance.block<2, 2>(DarbouxCurve::pose_size, DarbouxCurve::pose_size);
      number.standard_error = std::sqrt(block.trace() / (uncertainty.planar ? 1 : 2)) * units[k];
      if (values[i] < straight) number.value = 0;
      number.determined = true;
    }
    number.fixed = number.fixed && number.determined;
    if (!number.determined) number.value = number.standard_error = 0;
    counts.push_back(number.determined && !number.fixed);
    result.numbers.push_back(number);
  }
  result.correlation = Eigen::MatrixXd::Zero(count, count);
  for (Index i = 0; i < count; ++i) {
    for (Index j = 0; j < count; ++j) {
      if (!counts[static_cast<std::size_t>(i)] || !counts[static_cast<std::size_t>(j)]) continue;
      const double both = std::sqrt(covariance(i, i) * covariance(j, j));
      if (both > 0) result.correlation(i, j) = covariance(i, j) / both;
    }
  }
  return result;
}

}  // namespace wirepack
