#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/rod/frame_chart.hpp"

namespace wirepack {

/// Gaps below this, over the wire radius, count as closed in models of the Hessian. A contact that
/// forms during the descent is far stiffer than all else, so a model without it fits badly.
inline constexpr double nearly_touching = 1e-3;

/// Model of the Hessian in the unknowns of a chart, at the chart's reference. It lies between the
/// Gauss-Newton part and the Hessian itself. The Gauss-Newton part is a sum of squares w g g^T, g
/// the gradient of a strain, gap or other scalar; it is positive semidefinite. The Hessian also
/// knows how forces turn with the wire, but may be indefinite. Energy terms add both by nodes,
/// spins and blocks, and see no numbering of unknowns.
class CurvatureModel {
 public:
  struct NodePart {
    Index node;
    Vec3 by_node;
  };
  struct FramePart {
    Index frame;
    Vec3 by_spin;
  };

  /// `exactness` is the Hessian's share: from 0, squares alone, to 1, the Hessian.
  explicit CurvatureModel(const FrameChart& chart, double exactness = 0);

  const FrameChart& chart() const { return *chart_; }
  /// A term that knows its Hessian adds its squares times 1 - exactness and its Hessian times
  /// exactness. Other terms add their squares.
  double exactness() const { return exactness_; }

  /// Adds weight g g^T for a scalar with these derivatives; weight >= 0, at most 4 nodes and 2
  /// frames.
  void add_square(double weight, std::span<const NodePart> nodes,
                  std::span<const FramePart> frames = {});
  /// Adds weight times a symmetric Hessian by these blocks of the chart, each of four slots (x, y,
  /// z, angle). The blocks are all different, at most 4.
  using Hessian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 16, 16>;
  void add_hessian(double weight, const Hessian& hessian, std::span<const Index> blocks);
  /// Adds a symmetric positive semidefinite 3 x 3 block at one node.
  void add_node_block(Index node, const Mat3& value);

  /// Lower triangle in the chart's numbering. `shift` is added on the diagonal of coordinates,
  /// `angle_shift` on that of angles.
  Eigen::SparseMatrix<double> lower_triangle(double shift, double angle_shift) const;

 private:
  // Blocks of four slots by four of the lower triangle are found by their column. The first three
  // of a column, which the wire itself couples, have fixed places. Blocks of contacts are chained
  // from the third.
  static constexpr Index band = 3;
  struct Place {
    Index row;  // -1: not used
    Index next;
  };
  Eigen::Matrix4d& block(Index row, Index column);
  // Calls f(row, value) for the blocks of a column, in no particular order.
  template <class F>
  void for_each_in_column(Index column, F&& f) const;

  const FrameChart* chart_;
  double exactness_;
  Points tangents_;                  // of every frame, at the reference
  Eigen::VectorXd inverse_lengths_;  // of every edge
  std::vector<Place> places_;
  std::vector<Eigen::Matrix4d> blocks_;
};

}  // namespace wirepack
