#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "wirepack/core/types.hpp"

namespace wirepack::testing {

/// Inextensible planar elastica fed through the pole of a sphere: clamped at (0, rho) along the
/// inward normal, its tip sliding without friction on the circle of radius rho, so that the only
/// load is a wall reaction N at the tip, directed to the centre. Exact but for the Runge-Kutta
/// integration (4th order, 400 steps: relative error below 1e-8).
struct FedElastica {
  double rho, bend;

  struct Shape {
    double length;
    double tip_angle;      ///< of the tip's place, from the south pole
    double tip_direction;  ///< of the wire at the tip, from the direction to the north
    double reaction;       ///< N
    double force;          ///< dE/dL = compression along the wire at the clamp - B kappa^2 / 2
    double energy;
    double farthest;  ///< largest distance from the centre of all inner points
  };

  /// The shape of this length, followed from a former one. Throws if Newton's method fails.
  Shape at_length(double length, const Shape& former) const {
    Eigen::Vector3d u(former.tip_angle, former.tip_direction, former.reaction);
    const int parts = 1 + static_cast<int>(std::abs(length - former.length) / (0.005 * rho));
    for (int k = 1; k <= parts; ++k) {
      const double part = former.length + (length - former.length) * k / parts;
      solve(u, [&](const Eigen::Vector3d& v) { return integrate(part, v).miss; });
    }
    return shape(length, u);
  }

  /// The first bent shape after contact: the tip's direction is off the axis by `deflection`.
  Shape first_bent(double deflection) const {
    // unknowns: length, tip angle, reaction; start from the straight wire, at several loads
    double best = 1e300;
    Eigen::Vector3d result;
    for (double load = 1; load < 40; load += 1) {
      Eigen::Vector3d u(2 * rho * (1 + deflection * deflection / 8), deflection / 2,
                        load * bend / (4 * rho * rho));
      try {
        solve(u, [&](const Eigen::Vector3d& v) {
          return integrate(v[0], Eigen::Vector3d(v[1], deflection, v[2])).miss;
        });
      } catch (const std::runtime_error&) {
        continue;
      }
      const bool longer = u[0] > 2 * rho && u[0] < 2.5 * rho;
      if (u[2] > 0 && u[2] < best && longer) {
        best = u[2];
        result = u;
      }
    }
    if (best > 1e299) throw std::runtime_error("no buckled elastica found");
    return shape(result[0], Eigen::Vector3d(result[1], deflection, result[2]));
  }

 private:
  struct Result {
    Eigen::Vector3d miss;
    double energy, farthest, end_curvature, end_compression;
  };

  // From the tip to the clamp in the plane (x, z): theta is measured from +z towards +x.
  Result integrate(double length, const Eigen::Vector3d& v) const {
    const double alpha = v[0], reaction = v[2];
    const Eigen::Vector2d tip(rho * std::sin(alpha), -rho * std::cos(alpha));
    const Eigen::Vector2d pull = -reaction * tip / rho;  // force of the wall on the tip
    // internal force = pull at every section; B theta'' = pull x t (moment balance)
    using Vec5 = Eigen::Matrix<double, 5, 1>;  // x, z, theta, kappa, energy
    const auto rate = [&](const Vec5& y) {
      const double s = std::sin(y[2]), c = std::cos(y[2]);
      Vec5 d;
      // angle from z towards x: torque about that sense of a force f at arm t is f_x t_z - f_z t_x
      d << s, c, y[3], (pull.x() * c - pull.y() * s) / bend, bend * y[3] * y[3] / 2;
      return d;
    };
    Vec5 y;
    y << tip.x(), tip.y(), v[1], 0, 0;
    const int steps = 400;
    const double h = length / steps;
    double farthest = 0;
    for (int i = 0; i < steps; ++i) {
      const Vec5 k1 = rate(y), k2 = rate(y + h / 2 * k1), k3 = rate(y + h / 2 * k2);
      const Vec5 k4 = rate(y + h * k3);
      y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      if (i > steps / 50 && i < steps - steps / 50) {
        farthest = std::max(farthest, std::hypot(y[0], y[1]));
      }
    }
    const Eigen::Vector2d tangent(std::sin(y[2]), std::cos(y[2]));
    return {Eigen::Vector3d(y[0] / rho, y[1] / rho - 1, y[2]), y[4], farthest, y[3],
            pull.dot(tangent)};
  }

  Shape shape(double length, const Eigen::Vector3d& u) const {
    const Result r = integrate(length, u);
    const double force = r.end_compression - bend * r.end_curvature * r.end_curvature / 2;
    return {length, u[0], u[1], u[2], force, r.energy, r.farthest};
  }

  template <class F>
  static void solve(Eigen::Vector3d& u, F&& misses) {
    for (int iteration = 0; iteration < 60; ++iteration) {
      const Eigen::Vector3d f = misses(u);
      if (f.norm() < 1e-11) return;
      Eigen::Matrix3d jacobian;
      for (int k = 0; k < 3; ++k) {
        Eigen::Vector3d v = u;
        const double h = 1e-6 * std::max(1e-3, std::abs(u[k]));
        v[k] += h;
        const Eigen::Vector3d above = misses(v);
        v[k] -= 2 * h;
        jacobian.col(k) = (above - misses(v)) / (2 * h);
      }
      const Eigen::Vector3d step = jacobian.fullPivLu().solve(f);
      if (!step.allFinite() || !f.allFinite()) break;
      u -= step * std::min(1.0, 0.3 / step.cwiseAbs().maxCoeff() * std::max(1.0, u.norm()));
    }
    throw std::runtime_error("the elastica did not converge");
  }
};

}  // namespace wirepack::testing
