#include "wirepack/energy/curvature_model.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

CurvatureModel::CurvatureModel(const FrameChart& chart, double exactness)
    : chart_(&chart),
      exactness_(exactness),
      places_(static_cast<std::size_t>(band * chart.block_count()), {-1, -1}),
      blocks_(places_.size(), Eigen::Matrix4d::Zero()) {
  const RodState& state = chart.reference();
  tangents_.resize(3, static_cast<Index>(state.frames.size()));
  inverse_lengths_.resize(state.edge_count());
  for (Index j = 0; j < tangents_.cols(); ++j) {
    tangents_.col(j) = third_axis(state.frames[static_cast<std::size_t>(j)]);
  }
  for (Index j = 0; j < state.edge_count(); ++j) {
    inverse_lengths_[j] = 1 / (state.nodes.col(next_node(state, j)) - state.nodes.col(j)).norm();
  }
  // the diagonal is always there, for the shift
  for (Index c = 0; c < chart.block_count(); ++c) block(c, c);
}

Eigen::Matrix4d& CurvatureModel::block(Index row, Index column) {
  const auto at = [this](Index k) -> Place& { return places_[static_cast<std::size_t>(k)]; };
  const Index offset = row - column;
  if (offset < band) {
    const Index k = band * column + offset;
    at(k).row = row;
    return blocks_[static_cast<std::size_t>(k)];
  }
  Index last = band * column + band - 1;
  while (at(last).next >= 0) {
    last = at(last).next;
    if (at(last).row == row) return blocks_[static_cast<std::size_t>(last)];
  }
  at(last).next = static_cast<Index>(places_.size());
  places_.push_back({row, -1});
  return blocks_.emplace_back(Eigen::Matrix4d::Zero());
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

void CurvatureModel::add_hessian(double weight, const Hessian& hessian,
                                 std::span<const Index> blocks) {
  const auto count = static_cast<Index>(blocks.size());
  for (Index p = 0; p < count; ++p) {
    for (Index q = 0; q < count; ++q) {
      const Index row = blocks[static_cast<std::size_t>(p)];
      const Index column = blocks[static_cast<std::size_t>(q)];
      if (row >= column) block(row, column) += weight * hessian.block<4, 4>(4 * p, 4 * q);
    }
  }
}

void CurvatureModel::add_node_block(Index node, const Mat3& value) {
  block(node, node).topLeftCorner<3, 3>() += value;
}

template <class F>
void CurvatureModel::for_each_in_column(Index column, F&& f) const {
  const auto take = [&](Index k) {
    const Place& place = places_[static_cast<std::size_t>(k)];
    if (place.row >= 0) f(place.row, blocks_[static_cast<std::size_t>(k)]);
    return place.next;
  };
  Index next = -1;
  for (Index k = 0; k < band; ++k) next = take(band * column + k);
  while (next >= 0) next = take(next);
}

Eigen::SparseMatrix<double> CurvatureModel::lower_triangle(double shift, double angle_shift) const {
  using Sparse = Eigen::SparseMatrix<double>;
  using Number = Sparse::StorageIndex;
  Sparse lower(chart_->size(), chart_->size());
  const auto free_slots = [&](Index b) {
    Index count = 0;
    for (int i = 0; i < 4; ++i) count += chart_->unknown(b, i) >= 0 ? 1 : 0;
    return count;
  };
  Index entries = 0;
  for (Index c = 0; c < chart_->block_count(); ++c) {
    const Index n = free_slots(c);
    for_each_in_column(c, [&](Index row, const Eigen::Matrix4d&) {
      entries += row == c ? n * (n + 1) / 2 : n * free_slots(row);
    });
  }
  lower.resizeNonZeros(entries);
  Number* const start = lower.outerIndexPtr();
  Number* const row_of = lower.innerIndexPtr();
  double* const value_of = lower.valuePtr();
  Number count = 0;

  struct RowBlock {
    Index row;
    std::array<Index, 4> unknown;
    const Eigen::Matrix4d* value;
  };
  std::vector<RowBlock> rows;
  // Blocks and slots in growing order are unknowns in growing order, so columns come out complete.
  for (Index c = 0; c < chart_->block_count(); ++c) {
    rows.clear();
    for_each_in_column(c, [&](Index row, const Eigen::Matrix4d& value) {
      std::array<Index, 4> unknown;
      for (int i = 0; i < 4; ++i) unknown[static_cast<std::size_t>(i)] = chart_->unknown(row, i);
      rows.push_back({row, unknown, &value});
    });
    std::sort(rows.begin(), rows.end(),
              [](const RowBlock& p, const RowBlock& q) { return p.row < q.row; });
    for (int j = 0; j < 4; ++j) {
      const Index column = chart_->unknown(c, j);
      if (column < 0) continue;
      start[column] = count;
      for (const RowBlock& b : rows) {
        for (int i = b.row == c ? j : 0; i < 4; ++i) {
          const Index row = b.unknown[static_cast<std::size_t>(i)];
          if (row < 0) continue;
          row_of[count] = static_cast<Number>(row);
          value_of[count] = (*b.value)(i, j);
          ++count;
        }
      }
      value_of[start[column]] += j < 3 ? shift : angle_shift;
    }
  }
  start[chart_->size()] = count;
  return lower;
}

}  // namespace wirepack
