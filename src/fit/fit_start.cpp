#include "fit_start.hpp"

namespace wirepack {

void keep_arcs(const MeasuredPoints& points, FitStart& start) {
  if (points.arc.size() == 0) return;
  start.feet = points.arc;
  start.basis.first = points.arc.minCoeff();
  start.basis.last = points.arc.maxCoeff();
}

}  // namespace wirepack
