#include "wirepack/contact/neighbor_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wirepack/contact/segment_distance.hpp"

namespace wirepack {

namespace {

// Midpoints sorted into cells of a box grid; `order` lists edges cell by cell.
struct CellGrid {
  std::array<Index, 3> size;
  std::vector<Index> cell_of, start, order;
};

CellGrid sort_into_cells(const Points& points, double cell) {
  CellGrid grid;
  const Vec3 low = points.rowwise().minCoeff();
  const Vec3 high = points.rowwise().maxCoeff();
  // a stray far-away point must not make the grid larger than the problem
  const double limit = std::max(8.0, 2 * std::cbrt(static_cast<double>(points.cols())));
  Vec3 width;
  for (int c = 0; c < 3; ++c) {
    width[c] = std::max(cell, (high[c] - low[c]) / limit);
    grid.size[static_cast<std::size_t>(c)] = static_cast<Index>((high[c] - low[c]) / width[c]) + 1;
  }
  const Index count = grid.size[0] * grid.size[1] * grid.size[2];
  grid.cell_of.resize(static_cast<std::size_t>(points.cols()));
  grid.start.assign(static_cast<std::size_t>(count) + 1, 0);
  for (Index j = 0; j < points.cols(); ++j) {
    const Vec3 u = (points.col(j) - low).cwiseQuotient(width);
    const Index cell_index =
        (static_cast<Index>(u.x()) * grid.size[1] + static_cast<Index>(u.y())) * grid.size[2] +
        static_cast<Index>(u.z());
    grid.cell_of[static_cast<std::size_t>(j)] = cell_index;
    ++grid.start[static_cast<std::size_t>(cell_index) + 1];
  }
  for (std::size_t c = 1; c < grid.start.size(); ++c) grid.start[c] += grid.start[c - 1];
  std::vector<Index> next(grid.start.begin(), grid.start.end() - 1);
  grid.order.resize(static_cast<std::size_t>(points.cols()));
  for (Index j = 0; j < points.cols(); ++j) {
    const Index c = grid.cell_of[static_cast<std::size_t>(j)];
    grid.order[static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++)] = j;
  }
  return grid;
}

}  // namespace

Index first_touching_neighbor(const ContactRange& range) {
  const double edges = std::ceil(range.excluded_arc_length / range.edge_length - 1e-9);
  return std::max<Index>(4, static_cast<Index>(edges));
}

std::vector<EdgePair> near_edges(const RodState& state, double reach, Index separation) {
  const Index edges = state.edge_count();
  Points midpoints(3, edges);
  for (Index j = 0; j < edges; ++j) {
    midpoints.col(j) = (state.nodes.col(j) + state.nodes.col(next_node(state, j))) / 2;
  }
  const CellGrid grid = sort_into_cells(midpoints, reach);
  std::vector<EdgePair> pairs;
  for (Index j = 0; j < edges; ++j) {
    const auto first_pair = static_cast<std::ptrdiff_t>(pairs.size());
    const Index cell = grid.cell_of[static_cast<std::size_t>(j)];
    const Index z = cell % grid.size[2];
    const Index y = cell / grid.size[2] % grid.size[1];
    const Index x = cell / (grid.size[2] * grid.size[1]);
    for (Index cx = std::max<Index>(0, x - 1); cx <= std::min(grid.size[0] - 1, x + 1); ++cx) {
      for (Index cy = std::max<Index>(0, y - 1); cy <= std::min(grid.size[1] - 1, y + 1); ++cy) {
        // cells along z are neighbours in memory: one run of edges
        const Index row = (cx * grid.size[1] + cy) * grid.size[2];
        const Index from = grid.start[static_cast<std::size_t>(row + std::max<Index>(0, z - 1))];
        const Index to =
            grid.start[static_cast<std::size_t>(row + std::min(grid.size[2] - 1, z + 1) + 1)];
        for (Index p = from; p < to; ++p) {
          const Index k = grid.order[static_cast<std::size_t>(p)];
          if (k - j < separation) continue;
          if (state.ends.closed && j + edges - k < separation) continue;
          if ((midpoints.col(j) - midpoints.col(k)).squaredNorm() > reach * reach) continue;
          pairs.push_back({j, k});
        }
      }
    }
    std::sort(pairs.begin() + first_pair, pairs.end(),
              [](const EdgePair& p, const EdgePair& q) { return p.second < q.second; });
  }
  return pairs;
}

NeighborList::NeighborList(const RodState& state, const ContactRange& range, double skin)
    // both lines of a pair may move
    : built_at_(state.nodes), allowed_move_(skin / 2) {
  double longest = 0;
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 e = state.nodes.col(next_node(state, j)) - state.nodes.col(j);
    longest = std::max(longest, e.norm());
  }
  const double limit = range.touching_distance + skin;
  const auto extended = [&](Index j, double s) -> Vec3 {
    const Vec3 a = state.nodes.col(j);
    const Vec3 b = state.nodes.col(next_node(state, j));
    return (a + b) / 2 + s * (b - a);
  };
  pairs_ = near_edges(state, limit + 3 * longest, first_touching_neighbor(range));
  std::erase_if(pairs_, [&](const EdgePair& pair) {
    return squared_segment_distance(extended(pair.first, -1.5), extended(pair.first, 1.5),
                                    extended(pair.second, -1.5),
                                    extended(pair.second, 1.5)) >= limit * limit;
  });
}

bool NeighborList::covers(const RodState& state) const {
  if (state.nodes.cols() != built_at_.cols()) return false;
  // No point of an extended line moves farther than one of its ends, 2 b - a and 2 a - b for an edge
  // from a to b.
  const double limit = allowed_move_ * allowed_move_;
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Index k = next_node(state, j);
    const Vec3 a = state.nodes.col(j) - built_at_.col(j);
    const Vec3 b = state.nodes.col(k) - built_at_.col(k);
    if ((2 * b - a).squaredNorm() > limit || (2 * a - b).squaredNorm() > limit) return false;
  }
  return true;
}

}  // namespace wirepack
