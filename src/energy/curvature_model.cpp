#include "wirepack/energy/curvature_model.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

CurvatureModel::CurvatureModel(const FrameChart& chart)
    : chart_(&chart), columns_(static_cast<std::size_t>(chart.block_count())) {
  const RodState& state = chart.reference();
  tangents_.resize(3, static_cast<Index>(state.frames.size()));
  inverse_lengths_.resize(state.edge_count());
  for (Index j = 0; j < tangents_.cols(); ++j) {
    tangents_.col(j) = third_axis(state.frames[static_cast<std::size_t>(j)]);
  }
  for (Index j = 0; j < state.edge_count(); ++j) {
    inverse_lengths_[j] = 1 / (state.nodes.col(next_node(state, j)) - state.nodes.col(j)).norm();
  }
}

Eigen::Matrix4d& CurvatureModel::block(Index row, Index column) {
  auto& blocks = columns_[static_cast<std::size_t>(column)];
  for (Block& b : blocks) {
    if (b.row == row) return b.value;
  }
  blocks.push_back({row, Eigen::Matrix4d::Zero()});
  return blocks.back().value;
}

void CurvatureModel::add_square(double weight, std::span<const NodePart> nodes,
                                std::span<const FramePart> frames) {
  struct Slot {
    Index block;
    Eigen::Vector4d value;
  };
  std::array<Slot, 10> slots;
  std::size_t count = 0;
  const auto slot = [&](Index b) -> Eigen::Vector4d& {
    for (std::size_t k = 0; k < count; ++k) {
      if (slots[k].block == b) return slots[k].value;
    }
    assert(count < slots.size());
    slots[count] = {b, Eigen::Vector4d::Zero()};
    return slots[count++].value;
  };
  for (const NodePart& part : nodes) slot(part.node).head<3>() += part.by_node;
  const RodState& state = chart_->reference();
  for (const FramePart& part : frames) {
    const Vec3 t = tangents_.col(part.frame);
    if (part.frame < state.edge_count()) {
      const Vec3 by_edge = part.by_spin.cross(t) * inverse_lengths_[part.frame];
      slot(next_node(state, part.frame)).head<3>() += by_edge;
      slot(part.frame).head<3>() -= by_edge;
    }
    slot(chart_->angle_block(part.frame))[3] += part.by_spin.dot(t);
  }
  for (std::size_t p = 0; p < count; ++p) {
    for (std::size_t q = 0; q <= p; ++q) {
      const bool ordered = slots[p].block >= slots[q].block;
      const Slot& row = ordered ? slots[p] : slots[q];
      const Slot& column = ordered ? slots[q] : slots[p];
      block(row.block, column.block).noalias() += weight * row.value * column.value.transpose();
    }
  }
}

void CurvatureModel::add_node_block(Index node, const Mat3& value) {
  block(node, node).topLeftCorner<3, 3>() += value;
}

Eigen::SparseMatrix<double> CurvatureModel::lower_triangle(double shift) const {
  using Sparse = Eigen::SparseMatrix<double>;
  std::vector<Sparse::StorageIndex> starts, rows;
  std::vector<double> values;
  std::vector<const Block*> sorted;
  // Blocks and slots in growing order are unknowns in growing order, so columns come out complete.
  for (Index c = 0; c < chart_->block_count(); ++c) {
    sorted.clear();
    for (const Block& b : columns_[static_cast<std::size_t>(c)]) sorted.push_back(&b);
    std::sort(sorted.begin(), sorted.end(),
              [](const Block* p, const Block* q) { return p->row < q->row; });
    for (int j = 0; j < 4; ++j) {
      const Index column = chart_->unknown(c, j);
      if (column < 0) continue;
      starts.push_back(static_cast<Sparse::StorageIndex>(rows.size()));
      bool has_diagonal = false;
      for (const Block* b : sorted) {
        for (int i = b->row == c ? j : 0; i < 4; ++i) {
          const Index row = chart_->unknown(b->row, i);
          if (row < 0) continue;
          has_diagonal |= row == column;
          rows.push_back(static_cast<Sparse::StorageIndex>(row));
          values.push_back(row == column ? b->value(i, j) + shift : b->value(i, j));
        }
      }
      if (!has_diagonal) {  // nothing acts on this unknown: the shift alone, in front of its column
        rows.insert(rows.begin() + starts.back(), static_cast<Sparse::StorageIndex>(column));
        values.insert(values.begin() + starts.back(), shift);
      }
    }
  }
  starts.push_back(static_cast<Sparse::StorageIndex>(rows.size()));
  return Eigen::Map<const Sparse>(chart_->size(), chart_->size(), static_cast<Index>(rows.size()),
                                  starts.data(), rows.data(), values.data());
}

}  // namespace wirepack
