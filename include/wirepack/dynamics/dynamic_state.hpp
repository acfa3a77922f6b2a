#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/dynamics/gear_values.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// A moving wire: plain data, everything that the next step depends on but the memory of friction.
///
/// Unknowns are the nodes and, for each frame, its twist angle theta about its own tangent (member
/// `spins`). The frame of an edge stays exactly adapted: a step carries it by parallel transport
/// from the old to the new tangent t (the smallest rotation), then turns it about the new tangent
/// by the change of theta. Its angular velocity is therefore
///
///     omega = t x dt/dt + t dtheta/dt.
///
/// Transport along the path of the tangent differs from that along the chord of a step by the area
/// between them on the unit sphere, h^3 / 12 (t x t').t''. With it, twist, energy and angular
/// momentum have the order of the integrator.
struct DynamicState {
  RodState rod;      ///< nodes and frames where the forces of the last step were taken
  GearValues nodes;  ///< 3N x 6; column 0 holds the coordinates of rod.nodes
  GearValues spins;  ///< frames x 6; column 0 holds turns that frames have not made yet [rad]
  double time = 0;
  double step = 0;        ///< h that nodes and spins are scaled with
  double feed_speed = 0;  ///< d(rod.inlet_rest_length)/dt

  Vec3 velocity(Index node) const { return nodes.col(1).segment<3>(3 * node) / step; }
  double spin_rate(Index frame) const { return spins(frame, 1) / step; }
};

/// The rod at zero velocity.
DynamicState without_velocity(RodState rod, double step);

/// Gives every node and frame a velocity, and zeroes all higher derivatives.
void set_velocities(DynamicState& state, const Points& velocity, const Eigen::VectorXd& spin_rate);

/// Adds to the turns in column 0 of `spins` the angle by which transport along the path of the last
/// step differs from that along its chord. `nodes` are those at the end of the step.
void add_holonomy(DynamicState& state);

/// Takes rod.nodes from column 0 of `nodes` and lets the frames follow: transport to the new
/// tangents, then the turns of column 0 of `spins` about them. Sets that column to 0, as its turns
/// are made. Throws NumericalFailure for an edge without length.
void follow_nodes(DynamicState& state);

/// Velocities of the nodes, and of the edges as rigid bodies, derived from a state.
struct WireMotion {
  Points velocity;          ///< 3 x N
  Points edge;              ///< 3 x E, node to node
  Points tangent;           ///< 3 x E
  Eigen::VectorXd length;   ///< E, as they are now
  Points angular_velocity;  ///< 3 x E, of the frames, world axes
};
/// Sets the motion of a state; reuses the memory of `motion`.
void set_motion(const DynamicState& state, WireMotion& motion);

}  // namespace wirepack
