#include "fit_outliers.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "cannot_tell.hpp"
#include "curve_places.hpp"
#include "far_points.hpp"
#include "misfit.hpp"
#include "point_order.hpp"

namespace wirepack {

std::vector<Index> errors_of_measurement(const Points& points) {
  std::vector<Index> found;
  const std::vector<Index> far = far_points(points), spikes = spikes_of_list(points);
  std::set_union(far.begin(), far.end(), spikes.begin(), spikes.end(), std::back_inserter(found));
  return found;
}

bool lies_on(const OrderedFit& fit, const Vec3& given) {
  const CurveSolution& solution = fit.solution;
  const Vec3 point = fit.scale.scaled(given);
  const double beyond = solution.length() / 2;
  const double arc =
      nearest_arc(solution.curve, solution.first() - beyond, solution.last() + beyond, point);
  const double off = (solution.curve.at(arc).position - point).norm();
  return off < std::max(5 * solution.rms_distance(), 1e-9);
}

std::vector<Index> outliers_of(ShapeModel model, const OrderedFit& fit,
                               const Uncertainty& uncertainty) {
  const MeasuredPoints& points = fit.scale.points;
  const CurveSolution& solution = fit.solution;
  const auto n = static_cast<double>(points.count());
  const Index dimensions = uncertainty.dimensions;
  const double limit = std::sqrt(2 * std::log(20 * n) + static_cast<double>(dimensions - 2));
  const double usual =
      std::max(median_scale(solution, dimensions), upper_scale(solution, dimensions));
  const double sigma =
      points.sigma.size() > 0 ? 1 : std::max(std::min(uncertainty.noise, usual), 1e-12);
  const double least = std::max(points.resolution, finest_residual(model));
  std::vector<Index> outliers;
  for (Index i = 0; i < points.count(); ++i) {
    const bool far = solution.weighted_distance[i] > limit * sigma;
    if (far && solution.distance[i] > least) outliers.push_back(i);
  }
  return outliers;
}

void require_outliers_are_few(Index outliers, Index given) {
  if (outliers < 2 || 50 * outliers < given) return;
  throw cannot_tell(fmt::format("{} of {} lie far off, and {}", outliers, given, no_order));
}

}  // namespace wirepack
