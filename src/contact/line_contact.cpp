#include "wirepack/contact/line_contact.hpp"

#include <cmath>

#include "wirepack/core/lane_differences.hpp"

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

Eigen::Matrix<double, 9, 9> LineKernel::second_derivative(const Line& first,
                                                          const Line& second) const {
  const Vec3 w = first.midpoint - second.midpoint, e1 = first.vector, e2 = second.vector;
  const double step = 1e-5 * edge_length;
  return wirepack::second_derivative<9>(
      {w.x(), w.y(), w.z(), e1.x(), e1.y(), e1.z(), e2.x(), e2.y(), e2.z()}, step,
      [&](const std::array<Lanes, 9>& x) -> std::array<Lanes, 9> {
        const auto line = [](const Triple<Lanes>& midpoint, const Triple<Lanes>& vector) {
          return LineOf<Lanes>{midpoint, vector, 1.0 / dot(vector, vector)};
        };
        const LineOf<Lanes> one = line({x[0], x[1], x[2]}, {x[3], x[4], x[5]});
        const LineOf<Lanes> other = line({0.0, 0.0, 0.0}, {x[6], x[7], x[8]});
        LineGradientOf<Lanes> g;
        contact_energy(*this, wirepack::meet(*this, one, other, NoEnd(), NoEnd()), one, other, g);
        return {g.midpoint1.x, g.midpoint1.y, g.midpoint1.z, g.vector1.x, g.vector1.y,
                g.vector1.z,   g.vector2.x,   g.vector2.y,   g.vector2.z};
      });
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
