#include "wirepack/observe/radial_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wirepack/observe/order.hpp"

namespace wirepack {

namespace {

/// What a circle cuts out of a disc: its area, and its moment towards the centre of the circle.
struct Lens {
  double area = 0, moment = 0;
};

// Half the angle under which a circle sees the common chord, and its segment's area.
double half_angle(double radius, double other, double distance) {
  const double cosine =
      (distance * distance + radius * radius - other * other) / (2 * distance * radius);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}
double segment(double radius, double angle) {
  return radius * radius * (angle - std::sin(angle) * std::cos(angle));
}

Lens lens(double disc, double circle, double distance) {
  if (distance >= disc + circle) return {};
  if (distance <= circle - disc) return {pi * disc * disc, 0};
  if (distance <= disc - circle) return {pi * circle * circle, pi * circle * circle * distance};
  const double far = segment(circle, half_angle(circle, disc, distance));
  // The moments of both segments about their own centres are 2/3 of the cubed half chord, and
  // cancel.
  return {segment(disc, half_angle(disc, circle, distance)) + far, distance * far};
}

/// The disc of a wire at one place, seen from the origin.
struct Disc {
  double height;    // of its plane
  double offset;    // of its centre from the foot of the origin in that plane
  double bending;   // curvature towards that foot
  double length;    // of wire that it stands for
  double distance;  // of its centre

  double volume_within(double ball, double radius) const {
    if (ball <= std::abs(height)) return 0;
    const Lens cut = lens(radius, std::sqrt(ball * ball - height * height), offset);
    return length * (cut.area - bending * cut.moment);
  }
};

// Curvature vector at each node; zero at the ends of an open wire.
Points curvatures(const RodState& state, const Points& tangents) {
  Points result = Points::Zero(3, state.node_count());
  for_each_joint(state, [&](const Joint& joint) {
    if (std::max(joint.before, joint.after) >= state.edge_count()) return;
    const auto length = [&](Index edge) {
      return (state.nodes.col(next_node(state, edge)) - state.nodes.col(edge)).norm();
    };
    result.col(joint.node) = 2 * (tangents.col(joint.after) - tangents.col(joint.before)) /
                             (length(joint.before) + length(joint.after));
  });
  return result;
}

template <class F>
void for_each_disc(const RodState& state, F&& f) {
  constexpr std::array<double, 4> places{0.06943184420297371, 0.33000947820757187,
                                         0.6699905217924281, 0.9305681557970263};
  constexpr std::array<double, 4> weights{0.17392742256872692, 0.32607257743127307,
                                          0.32607257743127307, 0.17392742256872692};
  const Points tangents = edge_tangents(state), curvature = curvatures(state, tangents);
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Index next = next_node(state, j);
    const Vec3 start = state.nodes.col(j), edge = state.nodes.col(next) - state.nodes.col(j);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Vec3 centre = start + places[k] * edge, t = tangents.col(j);
      const Vec3 kappa = (1 - places[k]) * curvature.col(j) + places[k] * curvature.col(next);
      const Vec3 across = centre - centre.dot(t) * t;
      const double offset = across.norm();
      const double bending = offset > 0 ? -kappa.dot(across) / offset : 0;
      f(Disc{centre.dot(t), offset, bending, weights[k] * edge.norm(), centre.norm()});
    }
  }
}

}  // namespace

std::vector<double> volume_within(const RodState& state, double wire_radius,
                                  const std::vector<double>& radii) {
  std::vector<double> whole(radii.size() + 1, 0.0), volume(radii.size(), 0.0);
  for_each_disc(state, [&](const Disc& disc) {
    auto k = std::lower_bound(radii.begin(), radii.end(), disc.distance - wire_radius);
    for (; k != radii.end() && *k < disc.distance + wire_radius; ++k) {
      volume[static_cast<std::size_t>(k - radii.begin())] += disc.volume_within(*k, wire_radius);
    }
    whole[static_cast<std::size_t>(k - radii.begin())] +=
        disc.length * pi * wire_radius * wire_radius;
  });
  double inside = 0;
  for (std::size_t k = 0; k < radii.size(); ++k) volume[k] += inside += whole[k];
  return volume;
}

std::vector<ShellDensity> radial_density(const RodState& state, double wire_radius,
                                         double cavity_radius, Index count) {
  std::vector<double> radii;
  for (Index k = 0; k <= count; ++k) {
    radii.push_back(cavity_radius * static_cast<double>(k) / static_cast<double>(count));
  }
  const std::vector<double> volume = volume_within(state, wire_radius, radii);
  std::vector<ShellDensity> shells;
  for (std::size_t k = 1; k < radii.size(); ++k) {
    const double space = 4 * pi / 3 * (std::pow(radii[k], 3) - std::pow(radii[k - 1], 3));
    shells.push_back({radii[k - 1], radii[k], (volume[k] - volume[k - 1]) / space});
  }
  return shells;
}

}  // namespace wirepack
