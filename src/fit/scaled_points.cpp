#include "scaled_points.hpp"

#include "extent.hpp"

namespace wirepack {

ScaledPoints scaled_points(const MeasuredPoints& given) {
  const double unit = extent_of(given.position);
  ScaledPoints result{given, given.position.rowwise().mean(), unit};
  MeasuredPoints& points = result.points;
  points.position = (given.position.colwise() - result.centre) / unit;
  if (given.arc.size() > 0) points.arc = (given.arc.array() - given.arc.minCoeff()) / unit;
  points.resolution = given.resolution / unit;
  if (given.sigma.size() > 0) points.sigma = given.sigma / unit;
  return result;
}

}  // namespace wirepack
