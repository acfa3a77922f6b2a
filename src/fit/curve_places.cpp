#include "curve_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wirepack {

double nearest_arc(const DarbouxCurve& curve, double first, double last, const Vec3& point) {
  constexpr Index places = 2000;
  double arc = first, least = std::numeric_limits<double>::infinity();
  const auto distance = [&](double s) { return (curve.at(s).position - point).norm(); };
  for (Index i = 0; i <= places; ++i) {
    const double s = first + (last - first) * static_cast<double>(i) / places;
    if (distance(s) >= least) continue;
    least = distance(s);
    arc = s;
  }
  const double foot = curve.foot(point, arc);
  return distance(foot) < least ? foot : arc;
}

double mean_turning(const DarbouxCurve& curve, double first, double last, Index samples) {
  const auto count = static_cast<double>(samples);
  double mean = 0;
  for (Index i = 0; i < samples; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / count;
    mean += curve.darboux(first + share * (last - first)).norm() / count;
  }
  return mean;
}

Points drawn(const DarbouxCurve& curve, double first, double last, const ScaledPoints& scale) {
  const double turn = mean_turning(curve, first, last, 200) * (last - first);
  const auto count = static_cast<Index>(std::clamp(std::ceil(turn / 0.05), 50.0, 20000.0)) + 1;
  Points points(3, count);
  for (Index i = 0; i < count; ++i) {
    const double arc = first + (last - first) * static_cast<double>(i) / double(count - 1);
    points.col(i) = scale.given(curve.at(arc).position);
  }
  return points;
}

}  // namespace wirepack
