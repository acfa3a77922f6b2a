#include "wirepack/contact/line_contact.hpp"

#include <cmath>

#include "line_meeting.hpp"

namespace wirepack {

namespace {

LineOf<double> plain(const Line& line) {
  return {triple(line.midpoint), triple(line.vector), 1 / line.vector.squaredNorm()};
}

Meeting<double> meet(const LineKernel& kernel, const Line& first, const Line& second) {
  return meet(kernel, plain(first), plain(second), FreeEnd{first.ends_before, first.ends_after},
              FreeEnd{second.ends_before, second.ends_after});
}

}  // namespace

LineKernel LineKernel::per_length(double stiffness, double wire_radius, double edge_length) {
  return {2 * wire_radius, edge_length, stiffness * edge_length / parallel_weight,
          stiffness * 2 * wire_radius};
}

std::optional<LineContact> LineKernel::touch(const Line& first, const Line& second) const {
  const Meeting<double> m = meet(*this, first, second);
  if (!m.touches(*this)) return std::nullopt;
  const double stiffness = m.weight1.value * m.weight2.value * pair_stiffness(m.parallel);
  return LineContact{m.s.value, m.t.value, stiffness, vec3(m.separation),
                     std::sqrt(m.squared_distance)};
}

double LineKernel::energy(const Line& first, const Line& second, LineGradient& gradient) const {
  const Meeting<double> m = meet(*this, first, second);
  if (!m.touches(*this)) return 0;
  LineGradientOf<double> by_line;
  const double energy = contact_energy(*this, m, plain(first), plain(second), by_line);
  gradient = {vec3(by_line.midpoint1), vec3(by_line.vector1), vec3(by_line.midpoint2),
              vec3(by_line.vector2)};
  return energy;
}

}  // namespace wirepack
