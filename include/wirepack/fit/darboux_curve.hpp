#pragma once

#include <array>
#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// How the Darboux vector of a rod depends on the unknowns of a fit: linearly, with few unknowns at
/// each arc. Constant: unknowns are k1, k2 (and k3, unless `planar`). Spline: cubic B-splines for
/// k1 and k2 over `intervals` equal parts of [first, last], their coefficients one after the other,
/// and k3 = 0, as a centreline does not tell how its material frame turns. Outside of it, k0 stays
/// what it is at the end.
struct DarbouxBasis {
  Index intervals = 0;  ///< 0: constant
  bool planar = false;
  double first = 0, last = 0;  ///< arcs

  double middle() const { return (first + last) / 2; }

  Index size() const { return intervals > 0 ? 2 * (intervals + 3) : planar ? 2 : 3; }
  /// The part of one unknown in k0 at an arc.
  struct Weight {
    Index unknown;
    int component;
    double value;
  };
  std::vector<Weight> weights(double arc) const;
  Vec3 darboux(const Eigen::VectorXd& unknowns, double arc) const;
};

/// A rod's centreline by its Darboux vector: integral of the frame equations from a pose at the
/// middle arc (of the basis), exactly, with k0 constant over each of many short pieces (one piece
/// if it is constant anyway).
///
/// Its unknowns are those of the basis, behind those of the pose, in this order: turns about d1 and
/// d2, shifts along d1, d2 and d3. A turn about d3 would only turn (k1, k2).
class DarbouxCurve {
 public:
  static constexpr Index pose_size = 5;
  /// Place of the shift along d3. Unless arcs are known, a curve only slides along itself by it.
  static constexpr Index shift_along = 4;
  struct Pose {
    Mat3 directors = Mat3::Identity();  ///< d1, d2, d3 as columns
    Vec3 position = Vec3::Zero();
  };

  /// `pose` at `unknowns` whose first five are 0.
  DarbouxCurve(DarbouxBasis basis, Pose pose);

  Index size() const { return pose_size + basis_.size(); }
  const DarbouxBasis& basis() const { return basis_; }
  /// Integrates; with `derivatives`, also what by_unknowns() needs.
  void set_unknowns(const Eigen::VectorXd& unknowns, bool derivatives);
  const Eigen::VectorXd& unknowns() const { return unknowns_; }

  Vec3 darboux(double arc) const { return basis_.darboux(unknowns_, arc); }
  Pose at(double arc) const;
  /// d(position) / d(unknowns) at an arc, times each of the columns of `directions`: 3 or fewer
  /// rows.
  void by_unknowns(double arc, const Pose& there, const Mat3& directions,
                   Eigen::Ref<Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>> out) const;
  /// Arc of the foot of a point on the curve, where the tangent is normal to the way to the point;
  /// the one that Newton's method finds from `arc`.
  double foot(const Vec3& point, double arc) const;

 private:
  struct Piece {
    double from, to;  // arcs, `from` nearer to the middle
    Vec3 darboux;
    Pose start;
    std::vector<DarbouxBasis::Weight> weights;
    // Motion of all that is behind `from`, by each unknown: turn, and shift of the origin.
    Eigen::Matrix3Xd turn, shift;
  };
  const Piece& piece_at(double arc) const;
  void integrate(std::vector<Piece>& side, Pose pose, const Eigen::Matrix3Xd& turn,
                 const Eigen::Matrix3Xd& shift, bool derivatives);

  DarbouxBasis basis_;
  Pose pose_;
  double middle_, step_;
  Eigen::VectorXd unknowns_;
  std::array<std::vector<Piece>, 2> sides_;  // beyond the middle, before it
};

}  // namespace wirepack
