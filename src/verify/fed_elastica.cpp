#include "wirepack/verify/fed_elastica.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "wirepack/core/error.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

namespace {

using Vec2 = Eigen::Vector2d;

// What is not known of a shape.
struct Unknowns {
  double length, tip_angle, tip_direction, reaction;
};

struct Integral {
  Vec3 miss;  // of the clamp's place and direction
  double energy, farthest, clamp_curvature, clamp_compression;
};

// From the tip to the clamp, in the plane of x and the axis z; theta is measured from z towards x.
Integral integrate(const FedElastica& wire, const Unknowns& u) {
  constexpr int steps = 400;
  const Vec2 tip(wire.rho * std::sin(u.tip_angle), -wire.rho * std::cos(u.tip_angle));
  const Vec2 push = -u.reaction * tip / wire.rho;  // on the tip
  using Vec5 = Eigen::Matrix<double, 5, 1>;        // x, z, theta, kappa, energy
  // balance of moments: YI theta'' = push x tangent
  const auto rate = [&](const Vec5& y) {
    const double s = std::sin(y[2]), c = std::cos(y[2]);
    Vec5 d;
    d << s, c, y[3], (push.x() * c - push.y() * s) / wire.bend, wire.bend * y[3] * y[3] / 2;
    return d;
  };
  Vec5 y;
  y << tip.x(), tip.y(), u.tip_direction, 0, 0;
  const double h = u.length / steps;
  double farthest = 0;
  for (int i = 0; i < steps; ++i) {
    const Vec5 k1 = rate(y), k2 = rate(y + h / 2 * k1), k3 = rate(y + h / 2 * k2);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(y + h * k3));
    if (i > steps / 50 && i < steps - steps / 50) farthest = std::max(farthest, y.head<2>().norm());
  }
  const Vec2 tangent(std::sin(y[2]), std::cos(y[2]));
  return {Vec3(y[0] / wire.rho, y[1] / wire.rho - 1, y[2]), y[4], farthest, y[3],
          push.dot(tangent)};
}

// Newton's method on three of the unknowns, which `set` puts in their places.
template <class Set>
Unknowns solve(const FedElastica& wire, Vec3 v, Set&& set) {
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vec3 miss = integrate(wire, set(v)).miss;
    if (miss.norm() < 1e-11) return set(v);
    Mat3 jacobian;
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-6 * std::max(1e-3, std::abs(v[k]));
      Vec3 above = v, below = v;
      above[k] += h;
      below[k] -= h;
      jacobian.col(k) =
          (integrate(wire, set(above)).miss - integrate(wire, set(below)).miss) / (2 * h);
    }
    const Vec3 step = jacobian.fullPivLu().solve(miss);
    if (!step.allFinite()) break;
    v -= step * std::min(1.0, 0.3 * std::max(1.0, v.norm()) / step.cwiseAbs().maxCoeff());
  }
  throw NumericalFailure("the fed elastica did not converge");
}

FedElastica::Shape shape_of(const FedElastica& wire, const Unknowns& u) {
  const Integral r = integrate(wire, u);
  const double kappa = r.clamp_curvature;
  return {u.length,
          u.tip_angle,
          u.tip_direction,
          u.reaction,
          r.clamp_compression - wire.bend * kappa * kappa / 2,
          r.energy,
          r.farthest};
}

}  // namespace

FedElastica::Shape FedElastica::first_bent(double tip_direction) const {
  const double length = 2 * rho * (1 + tip_direction * tip_direction / 8);
  // the lowest load at which a slightly bent shape exists, from starts at many loads
  Unknowns lowest{0, 0, 0, HUGE_VAL};
  for (int k = 1; k < 40; ++k) {
    try {
      const Unknowns u = solve(*this, Vec3(length, tip_direction / 2, k * bend / (4 * rho * rho)),
                               [&](const Vec3& v) {
                                 return Unknowns{v[0], v[1], tip_direction, v[2]};
                               });
      const bool slightly_bent = u.length > 2 * rho && u.length < 2.5 * rho && u.reaction > 0;
      if (slightly_bent && u.reaction < lowest.reaction) lowest = u;
    } catch (const NumericalFailure&) {
      // this start leads nowhere; others do
    }
  }
  if (lowest.reaction == HUGE_VAL) throw NumericalFailure("no bent elastica was found");
  return shape_of(*this, lowest);
}

FedElastica::Shape FedElastica::at_length(double length, const Shape& former) const {
  Vec3 v(former.tip_angle, former.tip_direction, former.reaction);
  const int parts = 1 + static_cast<int>(std::abs(length - former.length) / (0.005 * rho));
  for (int k = 1; k <= parts; ++k) {
    const double part = former.length + (length - former.length) * k / parts;
    const Unknowns u = solve(*this, v, [&](const Vec3& w) {
      return Unknowns{part, w[0], w[1], w[2]};
    });
    v = Vec3(u.tip_angle, u.tip_direction, u.reaction);
  }
  return shape_of(*this, {length, v[0], v[1], v[2]});
}

}  // namespace wirepack
