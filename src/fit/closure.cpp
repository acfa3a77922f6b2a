#include "closure.hpp"

namespace wirepack {

namespace {

double mean_step(const CurveSolution& solution) {
  return solution.length() / static_cast<double>(solution.feet.size() - 1);
}

Closure closure_of_circle(const CurveSolution& solution, const ShapeNumber& radius, double unit) {
  if (!radius.determined) return {};
  const double gap = 2 * pi * radius.value / unit - solution.length();
  return {gap < 3 * mean_step(solution), gap};
}

// The curve goes on from its end to its start, and is not open by more than the usual step there.
Closure closure_of_loop(const CurveSolution& solution) {
  const double step = mean_step(solution);
  const DarbouxCurve::Pose start = solution.curve.at(solution.first());
  const DarbouxCurve::Pose end = solution.curve.at(solution.last());
  const Vec3 way = start.position - end.position;
  const double gap = way.norm();
  const Vec3 tangent = end.directors.col(2);
  const bool straight_on = way.dot(tangent) > 0.7 * gap || gap < 0.1 * step;
  const bool smooth = start.directors.col(2).dot(tangent) > 0.5 && straight_on;
  return {solution.length() > 6 * gap && gap < 3 * step && smooth, gap};
}

}  // namespace

Closure closure_of(ShapeModel model, const CurveSolution& solution,
                   const std::vector<ShapeNumber>& numbers, double unit) {
  if (model == ShapeModel::helix) return {};
  if (model == ShapeModel::circle) return closure_of_circle(solution, numbers[2], unit);
  return closure_of_loop(solution);
}

}  // namespace wirepack
