#pragma once

namespace wirepack {

/// Inextensible planar elastica fed through the pole of a sphere, without friction: clamped at
/// (0, rho) along the inward normal, its tip sliding on the circle of radius rho, so that the only
/// load is a reaction of the wall at the tip, directed to the centre. Exact up to the second
/// contact with the wall, but for the integration (Runge-Kutta of 4th order, relative error below
/// 1e-8).
struct FedElastica {
  double rho;   ///< R - a
  double bend;  ///< YI

  struct Shape {
    double length;
    double tip_angle;      ///< place of the tip on the circle, from the pole opposite the clamp
    double tip_direction;  ///< of the wire at its tip, from the axis
    double reaction;       ///< of the wall on the tip
    double force;          ///< dE/dL = compression of the wire at the clamp - YI kappa^2 / 2 there
    double energy;
    double farthest;  ///< largest distance from the centre, the ends left out
  };

  /// The bent shape just after the first contact (at the length 2 rho), its tip turned off the axis
  /// by this small angle. Throws NumericalFailure if there is none.
  Shape first_bent(double tip_direction) const;
  /// The shape of this length, followed from a former one. Throws NumericalFailure if it is lost.
  Shape at_length(double length, const Shape& former) const;
};

}  // namespace wirepack
