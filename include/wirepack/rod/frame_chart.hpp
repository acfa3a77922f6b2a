#pragma once

#include <span>
#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Coordinates and frame angles that keep their value.
struct HeldUnknowns {
  std::vector<bool> coordinate;  ///< 3 N: x, y, z of each node
  std::vector<bool> angle;       ///< one per frame: rotation about its own tangent
  /// False: set_state leaves the edge frames as they are, for energies that read positions alone.
  /// Call carry_frames() (rod_state.hpp) afterwards. Needs every angle held.
  bool frames_follow = true;

  static HeldUnknowns none(const RodState& state);
  void hold_node(Index node);
};

/// Flat unknowns x <-> state: positions, and a twist angle theta for each frame. The angle is
/// relative to the frame that parallel transport from the reference tangent t0 gives (Bergou et al.
/// 2010). The spin of an edge frame is t x dt + t (d theta - (t0 x t).dt / (1 + t0.t)), exact for
/// any x. It is singular at t = -t0, so make a new chart before an edge has turned far.
///
/// Unknowns are numbered along the wire, in four slots per node: x, y, z and the angle of the edge
/// that starts there. An open wire has no edge at its last node: the last clamp takes that slot.
/// The first clamp comes last.
class FrameChart {
 public:
  FrameChart(RodState reference, const HeldUnknowns& held);

  Index size() const { return size_; }
  const RodState& reference() const { return reference_; }

  /// Place of slot 0..3 of a node among the unknowns, -1 when held; node N is the first clamp.
  Index unknown(Index node, int slot) const {
    return number_[static_cast<std::size_t>(4 * node + slot)];
  }
  /// Nodes, plus one for the first clamp: the number of blocks of four slots.
  Index block_count() const { return reference_.node_count() + 1; }
  /// Place of the angle of a frame among the unknowns, -1 when held.
  Index angle_unknown(Index frame) const { return angle_number_[static_cast<std::size_t>(frame)]; }
  /// Block of four that holds the angle of a frame (slot 3).
  Index angle_block(Index frame) const;

  /// x of the reference.
  Eigen::VectorXd unknowns() const;
  /// State at x; `out` must be a copy of the reference or a former result (its memory is reused).
  void set_state(const Eigen::VectorXd& x, RodState& out) const;
  /// Derivative by x, from derivatives by nodes (3 x N) and spins (3 x frames) at `state`.
  void pull_back(const RodState& state, const Points& by_node, const Points& by_frame,
                 Eigen::VectorXd& out) const;

  /// Frames that angles are counted from, and their tangents (3 x frames): those of the reference,
  /// or turned ones, which a chart built on this one supplies (TurningChart).
  struct Start {
    std::span<const Quat> frames;
    const Points& tangents;
  };
  Start start() const { return {reference_.frames, reference_tangents_}; }
  /// Sets the frames of a state, whose nodes are set, from the angles of all frames. Only for
  /// charts whose frames follow.
  void set_frames(const Start& start, const Eigen::VectorXd& angle, RodState& out) const;
  /// Converts derivatives by spins (3 x frames) at a fixed start: sets those by angles and adds to
  /// those by nodes.
  void pull_back_frames(const Start& start, const RodState& state, const Points& by_frame,
                        Points& by_node, Eigen::VectorXd& by_angle) const;

  /// Copies the coordinates among the unknowns into vectors by nodes (3 x N), and back. Held
  /// coordinates stay as they are.
  void scatter(const Eigen::VectorXd& by_unknown, Points& by_node) const {
    for (const Run& run : runs_) {
      const double* const from = by_unknown.data() + run.unknown;
      double* const to = by_node.data() + run.coordinate;
      for (Index k = 0; k < run.count; ++k) to[k] = from[k];
    }
  }
  void gather(const Points& by_node, Eigen::VectorXd& by_unknown) const {
    for (const Run& run : runs_) {
      const double* const from = by_node.data() + run.coordinate;
      double* const to = by_unknown.data() + run.unknown;
      for (Index k = 0; k < run.count; ++k) to[k] = from[k];
    }
  }
  /// The same for the angles of all frames; scatter_angles sets held ones to 0.
  void scatter_angles(const Eigen::VectorXd& by_unknown, Eigen::VectorXd& by_frame) const;
  void gather_angles(const Eigen::VectorXd& by_frame, Eigen::VectorXd& by_unknown) const;
  /// Sets held coordinates to those of the reference, and held components of a derivative by nodes
  /// to 0.
  void restore_held(Points& nodes) const {
    for (const Index k : held_coordinates_) nodes.data()[k] = reference_.nodes.data()[k];
  }
  void clear_held(Points& by_node) const {
    for (const Index k : held_coordinates_) by_node.data()[k] = 0;
  }
  bool frames_follow() const { return frames_follow_; }
  /// Tangent of a frame in the reference.
  Vec3 reference_tangent(Index frame) const { return reference_tangents_.col(frame); }

 private:
  /// Successive coordinates that are successive unknowns.
  struct Run {
    Index unknown, coordinate;  ///< the first; coordinate c of node i is 3 i + c
    Index count;
  };
  void add_to_runs(Index unknown, Index coordinate);

  RodState reference_;
  std::vector<Index> number_, angle_number_, held_coordinates_;
  std::vector<Run> runs_;
  bool frames_follow_ = true;
  Points reference_tangents_;
  Index size_ = 0;
};

}  // namespace wirepack
