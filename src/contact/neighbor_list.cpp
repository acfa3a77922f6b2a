#include "wirepack/contact/neighbor_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wirepack/contact/segment_distance.hpp"
#include "wirepack/core/threads.hpp"

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

// Finds the edges near an edge, by their midpoints.
class Neighborhoods {
 public:
  Neighborhoods(const RodState& state, double reach, Index separation)
      : edges_(state.edge_count()),
        separation_(separation),
        closed_(state.ends.closed),
        reach2_(reach * reach),
        midpoints_(3, edges_) {
    for (Index j = 0; j < edges_; ++j) {
      midpoints_.col(j) = (state.nodes.col(j) + state.nodes.col(next_node(state, j))) / 2;
    }
    // Cells are half the reach wide: five in a row hold less than three twice as wide would.
    grid_ = sort_into_cells(midpoints_, reach / 2);
    by_cell_ = Rows::Zero(edges_ + lane_count, 3);
    for (Index p = 0; p < edges_; ++p) {
      by_cell_.row(p) = midpoints_.col(grid_.order[static_cast<std::size_t>(p)]).transpose();
    }
  }

  // Calls f(j, near) for the edges j of `start` to `end` with the edges k > j within reach, in no
  // particular order.
  template <class F>
  void for_each(Index start, Index end, F&& f) const {
    std::vector<Index> found(static_cast<std::size_t>(edges_ + 1)), near;
    for (Index j = start; j < end; ++j) {
      const std::size_t count = find(j, found);
      near.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
      f(j, near);
    }
  }
  // The same for all edges, in tiles that threads may share: f(tile, j, near).
  Index tiles() const { return (edges_ + tile_edges - 1) / tile_edges; }
  template <class F>
  void for_each_in_tiles(F&& f) const {
    for_each_tile(edges_, tile_edges, true, [&](Index start, Index end) {
      for_each(start, end,
               [&](Index j, std::vector<Index>& near) { f(start / tile_edges, j, near); });
    });
  }

 private:
  static constexpr Index tile_edges = 128;
  // Midpoints in the order of cells, a column for each coordinate: neighbours in space are
  // neighbours in memory. Four may be read from any place on.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

  std::size_t find(Index j, std::vector<Index>& found) const {
    constexpr Index span = 2;
    std::size_t count = 0;
    const Triple<double> middle = triple(midpoints_.col(j));
    // in a closed wire the last edges are neighbours of the first
    const Index first_far = j + separation_;
    const Index last_far = closed_ ? j + edges_ - separation_ : edges_;
    const Index cell = grid_.cell_of[static_cast<std::size_t>(j)];
    const Index z = cell % grid_.size[2];
    const Index y = cell / grid_.size[2] % grid_.size[1];
    const Index x = cell / (grid_.size[2] * grid_.size[1]);
    const auto from = [](Index c) { return std::max<Index>(0, c - span); };
    const auto to = [&](Index c, std::size_t axis) {
      return std::min(grid_.size[axis] - 1, c + span);
    };
    for (Index cx = from(x); cx <= to(x, 0); ++cx) {
      for (Index cy = from(y); cy <= to(y, 1); ++cy) {
        // cells along z are neighbours in memory: one run of edges
        const Index row = (cx * grid_.size[1] + cy) * grid_.size[2];
        const Index first = grid_.start[static_cast<std::size_t>(row + from(z))];
        const Index end = grid_.start[static_cast<std::size_t>(row + to(z, 2) + 1)];
        for (Index p = first; p < end; p += lane_count) {
          const auto coordinate = [&](Index c) { return load<Lanes>(&by_cell_(p, c)); };
          const Triple<Lanes> apart{coordinate(0) - middle.x, coordinate(1) - middle.y,
                                    coordinate(2) - middle.z};
          std::array<double, lane_count> within;
          store(select(dot(apart, apart) <= Lanes(reach2_), 1.0, 0.0), within.data());
          // written always and kept if near: a branch on this would be mispredicted
          for (Index q = p; q < std::min(p + lane_count, end); ++q) {
            const Index k = found[count] = grid_.order[static_cast<std::size_t>(q)];
            const bool far = k >= first_far && k <= last_far;
            count += within[static_cast<std::size_t>(q - p)] > 0 && far ? 1 : 0;
          }
        }
      }
    }
    return count;
  }

  Index edges_, separation_;
  bool closed_;
  double reach2_;
  Points midpoints_;
  CellGrid grid_;
  Rows by_cell_;
};

}  // namespace

Index first_touching_neighbor(const ContactRange& range) {
  const double edges = std::ceil(range.excluded_arc_length / range.edge_length - 1e-9);
  return std::max<Index>(4, static_cast<Index>(edges));
}

std::vector<EdgePair> near_edges(const RodState& state, double reach, Index separation) {
  std::vector<EdgePair> pairs;
  const Neighborhoods neighborhoods(state, reach, separation);
  neighborhoods.for_each(0, state.edge_count(), [&](Index j, std::vector<Index>& near) {
    std::sort(near.begin(), near.end());
    for (const Index k : near) pairs.push_back({j, k});
  });
  return pairs;
}

NeighborList::NeighborList(const RodState& state, const ContactRange& range, double skin)
    : built_at_(state.nodes), skin_(skin) {
  double longest = 0;
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 e = state.nodes.col(next_node(state, j)) - state.nodes.col(j);
    longest = std::max(longest, e.norm());
  }
  const double limit = range.touching_distance + skin;
  // Lines from s = -1.5 to 1.5 about the midpoint of the edge from a to b.
  struct Extended {
    Triple<Lanes> from, to;
  };
  const auto extended = [&](auto&& edge) -> Extended {
    const Triple<Lanes> a = columns_of(state.nodes, edge);
    const Triple<Lanes> b =
        columns_of(state.nodes, [&](int k) { return next_node(state, edge(k)); });
    return {Lanes(2.0) * a - b, Lanes(2.0) * b - a};
  };
  const auto keep_near_lines = [&](Index j, std::vector<Index>& near) {
    const Extended first = extended([&](int) { return j; });
    const auto count = static_cast<Index>(near.size());
    std::size_t kept = 0;
    // four at a time; the last one is repeated to fill up
    for (Index start = 0; start < count; start += lane_count) {
      const auto place = [&](Index k) { return static_cast<std::size_t>(std::min(k, count - 1)); };
      const Extended second = extended([&](int k) { return near[place(start + k)]; });
      const LaneMask is_near =
          squared_segment_distance(first.from, first.to, second.from, second.to) < limit * limit;
      for (Index k = start; k < std::min(start + lane_count, count); ++k) {
        if (is_near[static_cast<std::size_t>(k - start)]) near[kept++] = near[place(k)];
      }
    }
    near.resize(kept);
  };
  const Neighborhoods neighborhoods(state, limit + 3 * longest, first_touching_neighbor(range));
  std::vector<std::vector<EdgeFour>> by_tile(static_cast<std::size_t>(neighborhoods.tiles()));
  neighborhoods.for_each_in_tiles([&](Index tile, Index j, std::vector<Index>& near) {
    keep_near_lines(j, near);
    std::sort(near.begin(), near.end());
    std::vector<EdgeFour>& fours = by_tile[static_cast<std::size_t>(tile)];
    for (const Index k : near) {
      const Index start = k - k % 4;
      if (fours.empty() || fours.back().first != j || fours.back().start != start) {
        fours.push_back({j, start, 0});
      }
      fours.back().listed |= 1U << (k - start);
    }
  });
  for (const auto& fours : by_tile) fours_.insert(fours_.end(), fours.begin(), fours.end());
}

std::vector<EdgePair> NeighborList::pairs() const {
  std::vector<EdgePair> pairs;
  for_each_pair(fours_, [&](const EdgePair& pair) { pairs.push_back(pair); });
  return pairs;
}

bool NeighborList::covers(const RodState& state, double margin) const {
  if (state.nodes.cols() != built_at_.cols()) return false;
  const double allowed_move = (skin_ - margin) / 2;  // both lines of a pair may move
  const double limit = allowed_move * allowed_move;
  const auto move = [&]<class T>(T, Index node) {
    return load_columns<T>(state.nodes, node) - load_columns<T>(built_at_, node);
  };
  // No point of an extended line moves farther than one of its ends, 2 b - a and 2 a - b for an
  // edge from a to b.
  const auto stays = [&]<class T>(const Triple<T>& a, const Triple<T>& b) {
    const Triple<T> start = T(2.0) * a - b, end = T(2.0) * b - a;
    return dot(start, start) <= T(limit) && dot(end, end) <= T(limit);
  };
  const Index last = state.node_count() - 1;
  Index j = 0;
  for (; j + lane_count <= last; j += lane_count) {
    if (!all_of(stays(move(Lanes(), j), move(Lanes(), j + 1)))) return false;
  }
  for (; j < last; ++j) {
    if (!stays(move(double(), j), move(double(), j + 1))) return false;
  }
  return !state.ends.closed || stays(move(double(), last), move(double(), 0));
}

}  // namespace wirepack
