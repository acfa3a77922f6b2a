#include "wirepack/rod/rest_strain.hpp"

#include <cmath>

namespace wirepack {

namespace {

// The part of the wire that a joint stands for, by arcs from the tip, and their derivatives by the
// rest length of the inlet edge.
struct Part {
  double first, last;
  double first_by_inlet = 0, last_by_inlet = 0;
  double middle() const { return (first + last) / 2; }
};

Part part_of(const RodState& state, const RodParams& params, Index node) {
  const Index last_node = state.node_count() - 1;
  double arc = static_cast<double>(node) * params.edge_length;
  if (state.ends.closed) {
    const double before = rest_length(state, params, node > 0 ? node - 1 : last_node) / 2;
    const double after = rest_length(state, params, node) / 2;
    return {arc - before, arc + after, node == 0 ? -0.5 : 0, node == last_node ? 0.5 : 0};
  }
  if (node == last_node) {  // a joint to a clamp, which lies at the very end
    arc += state.inlet_rest_length - params.edge_length;
    return {arc - state.inlet_rest_length / 2, arc, 0.5, 1};
  }
  const double before = node > 0 ? params.edge_length / 2 : 0;
  const double after = rest_length(state, params, node) / 2;
  return {arc - before, arc + after, 0, node == last_node - 1 ? 0.5 : 0};
}

// Bending (x, y) turned by an angle about the tangent, without twist.
Vec3 turned(const Vec3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), 0};
}

}  // namespace

Vec3 rest_strain(const RodState& state, const RodParams& params, Index node) {
  const Vec3 uniform = node_length(state, params, node) * params.rest_darboux;
  const ReferenceShape& shape = params.reference_shape;
  if (shape.empty()) return uniform;
  const Part part = part_of(state, params, node);
  return uniform + turned(shape.integral(part.last) - shape.integral(part.first),
                          shape.integral(part.middle()).z());
}

Vec3 rest_strain_by_inlet(const RodState& state, const RodParams& params, Index node) {
  const double share = node_length_by_inlet(state, node);
  const ReferenceShape& shape = params.reference_shape;
  const Vec3 uniform = share * params.rest_darboux;
  if (share == 0 || shape.empty()) return uniform;
  const Part part = part_of(state, params, node);
  const Vec3 strain = shape.integral(part.last) - shape.integral(part.first);
  const Vec3 by_ends = part.last_by_inlet * shape.darboux(part.last) -
                       part.first_by_inlet * shape.darboux(part.first);
  const double turn_by_inlet =
      (part.first_by_inlet + part.last_by_inlet) / 2 * shape.darboux(part.middle()).z();
  return uniform + turned(by_ends + turn_by_inlet * Vec3(-strain.y(), strain.x(), 0),
                          shape.integral(part.middle()).z());
}

bool is_straight(const RodParams& params) {
  return params.reference_shape.empty() && params.rest_darboux.isZero();
}

}  // namespace wirepack
