#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/rod/frame_chart.hpp"

namespace wirepack {

/// Positive definite model of the Hessian in the unknowns of a chart, at the chart's reference:
/// a sum of squares w g g^T, g the gradient of a strain, gap or other scalar. Energy terms add
/// their squares by nodes and spins and see no numbering.
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

  explicit CurvatureModel(const FrameChart& chart);

  /// Adds weight g g^T for a scalar with these derivatives; weight >= 0, at most 4 nodes and 2 frames.
  void add_square(double weight, std::span<const NodePart> nodes,
                  std::span<const FramePart> frames = {});
  /// Adds a symmetric positive semidefinite 3 x 3 block at one node.
  void add_node_block(Index node, const Mat3& value);

  /// Lower triangle in the chart's numbering, `shift` added on the diagonal.
  Eigen::SparseMatrix<double> lower_triangle(double shift) const;

 private:
  // A block of four slots by four of the lower triangle is found by its column: the first three, which
  // the wire itself couples, have fixed places; others, of contacts, are chained from the third.
  static constexpr Index band = 3;
  struct Place {
    Index row;  // -1: not used
    Index next;
  };
  Eigen::Matrix4d& block(Index row, Index column);

  const FrameChart* chart_;
  Points tangents_;                  // of every frame, at the reference
  Eigen::VectorXd inverse_lengths_;  // of every edge
  std::vector<Place> places_;
  std::vector<Eigen::Matrix4d> blocks_;
};

}  // namespace wirepack
