#pragma once

#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/rod/frame_chart.hpp"

namespace wirepack {

/// Steps z about the reference of a FrameChart, bent so that a rotation of the wire about the
/// origin is a straight line in z. A packing in a frictionless sphere turns as a whole almost for
/// free. Straight steps of its nodes would leave that curved valley at once.
///
///   omega = M^-1 sum w_i r_i x z_i,  M = sum w_i^2 (r_i.r_i I - r_i r_i^T) + 1e-3 tr(M) I
///   x_i   = R(w_i omega) (r_i + z_i - w_i omega x r_i),  r_i the reference
///   theta = z_theta - w omega.t0, relative to reference frames turned by R(w omega)
///
/// R(v) is the Cayley transform of v / 2, a rotation about v by 2 atan(|v| / 2). The map is the
/// identity to first order. w = u^2 (3 - 2 u) rises from 0 at the last node, which a nozzle holds,
/// to 1 over the arc length `taper`; u is the arc over it.
class TurningChart {
 public:
  /// `taper` 0: no turning, z is the plain step.
  TurningChart(const FrameChart& chart, double taper);

  /// State at z; like FrameChart::set_state.
  void set_state(const Eigen::VectorXd& z, RodState& out);
  /// Moves of the nodes (3 x N) in the last set_state, without the rotation of the whole wire:
  /// z_i - w_i omega x r_i.
  const Points& moves() const { return moves_; }
  /// Sets the derivatives at the z of the last set_state. `by_node` and `by_frame` are those by
  /// nodes and spins at `state`, `by_move` is that of a function of moves(). by_x leaves `by_move`
  /// out, as FrameChart::pull_back with the frames turned; by_z includes it.
  void pull_back(const RodState& state, const Points& by_node, const Points& by_frame,
                 const Points& by_move, Eigen::VectorXd& by_x, Eigen::VectorXd& by_z);

 private:
  void turn_frames();
  Vec3 by_turning_frames(const RodState& state) const;

  const FrameChart* chart_;
  Eigen::VectorXd node_weight_, frame_weight_;
  Eigen::VectorXd angle_weight_;              // frame weights, 0 where the angle is held
  Index rigid_nodes_ = 0, rigid_frames_ = 0;  // counted from the tip: weight 1
  Points weighted_;                           // w_i r_i
  Mat3 inverse_inertia_ = Mat3::Zero();
  bool turns_ = false;
  Vec3 omega_ = Vec3::Zero();
  Mat3 turn_ = Mat3::Identity();  // R(omega), of the last set_state
  std::vector<Quat> turned_frames_;
  Points turned_tangents_;
  Eigen::VectorXd angle_, by_angle_;
  Points step_, moves_, force_, back_;
};

}  // namespace wirepack
