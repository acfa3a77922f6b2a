#include "wirepack/observe/coil_report.hpp"

#include <cmath>

#include "wirepack/observe/order.hpp"
#include "wirepack/observe/writhe.hpp"

namespace wirepack {

CoilReport coil_report(const RodState& state, const Vec3& feed) {
  CoilReport report;
  const Points axes = coil_axes(state);
  const AxialOrder order = axial_order(axes);
  report.axis_order = order.order();
  report.feed_alignment = alignment(axes, feed);
  double sense = 0;
  for (Index k = 0; k < axes.cols(); ++k) {
    const double along = axes.col(k).dot(order.director);
    if (std::abs(along) < 0.5) continue;
    if (sense * along < 0) ++report.reversals;
    sense = along;
  }
  report.twist = total_twist(state);
  const CrossingSums crossings = crossing_sums(state.nodes, state.ends.closed);
  report.writhe = crossings.writhe;
  report.average_crossing_number = crossings.average_crossing_number;
  return report;
}

}  // namespace wirepack
