#include "wirepack/contact/contact_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "line_meeting.hpp"

namespace wirepack {

namespace {

// The lines of all edges: seven numbers of each, a column for each, filled up to whole lanes.
class LineTable {
 public:
  explicit LineTable(const RodState& state)
      : rows_((state.edge_count() + lane_count - 1) / lane_count * lane_count),
        values_(Eigen::VectorXd::Zero(7 * rows_)) {
    const auto keep = [&]<class T>(Index edge, const Triple<T>& a, const Triple<T>& b) {
      const Triple<T> e = b - a;
      const LineOf<T> line{T(0.5) * (a + b), e, T(1.0) / dot(e, e)};
      double* const p = values_.data() + edge;
      store(line.midpoint.x, p);
      store(line.midpoint.y, p + rows_);
      store(line.midpoint.z, p + 2 * rows_);
      store(line.vector.x, p + 3 * rows_);
      store(line.vector.y, p + 4 * rows_);
      store(line.vector.z, p + 5 * rows_);
      store(line.inverse_n, p + 6 * rows_);
    };
    const Index last = state.node_count() - 1;
    for_each_in_lanes(0, last, [&]<class T>(Index j) {
      keep(j, load_columns<T>(state.nodes, j), load_columns<T>(state.nodes, j + 1));
    });
    if (!state.ends.closed) return;
    keep(last, load_columns<double>(state.nodes, last), load_columns<double>(state.nodes, 0));
  }

  /// Four successive lines.
  [[gnu::always_inline]] LineOf<Lanes> four(Index start) const {
    return lines([&](const double* column) { return load<Lanes>(column + start); });
  }
  /// A line in all lanes.
  [[gnu::always_inline]] LineOf<Lanes> repeated(Index edge) const {
    return lines([&](const double* column) { return Lanes(column[edge]); });
  }
  /// The lines of the edges edge(0) ... edge(3).
  template <class F>
  [[gnu::always_inline]] LineOf<Lanes> picked(F&& edge) const {
    const std::array<Index, lane_count> at{edge(0), edge(1), edge(2), edge(3)};
    return lines([&](const double* column) {
      return lanes_of([&](int k) { return column[at[static_cast<std::size_t>(k)]]; });
    });
  }

 private:
  template <class F>
  [[gnu::always_inline]] LineOf<Lanes> lines(F&& from) const {
    const double* const p = values_.data();
    return {{from(p), from(p + rows_), from(p + 2 * rows_)},
            {from(p + 3 * rows_), from(p + 4 * rows_), from(p + 5 * rows_)},
            from(p + 6 * rows_)};
  }

  Index rows_;
  Eigen::VectorXd values_;
};

// The derivative by the lines of all edges: midpoint and vector of each, four numbers apart.
class ByLines {
 public:
  explicit ByLines(Index edges) : values_(Eigen::VectorXd::Zero(8 * edges)) {}

  template <class F>
  [[gnu::always_inline]] void add(int count, F&& edge, const Triple<Lanes>& midpoint,
                                  const Triple<Lanes>& vector) {
    const Lanes zero = 0.0;
    const auto m = transposed(midpoint.x, midpoint.y, midpoint.z, zero);
    const auto v = transposed(vector.x, vector.y, vector.z, zero);
    for (int k = 0; k < count; ++k) {
      double* const p = values_.data() + 8 * edge(k);
      store(load<Lanes>(p) + m[static_cast<std::size_t>(k)], p);
      store(load<Lanes>(p + 4) + v[static_cast<std::size_t>(k)], p + 4);
    }
  }
  void add_to_nodes(const RodState& state, Points& by_node) const {
    for (Index j = 0; j < state.edge_count(); ++j) {
      const auto midpoint = values_.segment<3>(8 * j), vector = values_.segment<3>(8 * j + 4);
      by_node.col(j) += midpoint / 2 - vector;
      by_node.col(next_node(state, j)) += midpoint / 2 + vector;
    }
  }

 private:
  Eigen::VectorXd values_;
};

void add_to_edge(const RodState& state, Index edge, const Vec3& by_midpoint, const Vec3& by_vector,
                 Points& by_node) {
  by_node.col(edge) += by_midpoint / 2 - by_vector;
  by_node.col(next_node(state, edge)) += by_midpoint / 2 + by_vector;
}

static_assert(lane_count == 4, "an EdgeFour is a pair in each lane");

// Lane k is set where bit k is.
LaneMask mask_of(unsigned bits) {
  static constexpr auto rows = [] {
    std::array<std::array<double, lane_count>, 1U << lane_count> table{};
    for (unsigned b = 0; b < table.size(); ++b) {
      for (unsigned k = 0; k < lane_count; ++k) table[b][k] = b >> k & 1U;
    }
    return table;
  }();
  return load<Lanes>(rows[bits].data()) > 0.0;
}

// What becomes of the touching pairs beside their energy: nothing, or a list.
struct Unlisted {
  void add(const EdgePair&, const LineKernel&, const Meeting<Lanes>&, int) const {}
  void add(const EdgePair&, const LineKernel&, const Line&, const Line&) const {}
};

struct Listed {
  std::vector<SelfContact>& touching;

  void add(const EdgePair& pair, const LineKernel& kernel, const Meeting<Lanes>& m,
           int lane_index) {
    const auto k = static_cast<std::size_t>(lane_index);
    add(pair, kernel,
        {m.s.value[k], m.t.value[k],
         m.weight1.value[k] * m.weight2.value[k] * kernel.pair_stiffness<double>(m.parallel[k]),
         lane(m.separation, lane_index), std::sqrt(m.squared_distance[k])});
  }
  void add(const EdgePair& pair, const LineKernel& kernel, const Line& first, const Line& second) {
    if (const auto touch = kernel.touch(first, second)) add(pair, kernel, *touch);
  }
  void add(const EdgePair& pair, const LineKernel& kernel, const LineContact& line) {
    const double overlap = kernel.touching_distance - line.distance;
    touching.push_back({pair, line, overlap, line.stiffness * overlap});
  }
};

template <class Sink>
double sum_pairs(const LineKernel& kernel, const RodState& state, std::span<const EdgeFour> fours,
                 Points& by_node, Sink sink) {
  const Index last_edge = state.edge_count() - 1;
  const bool open = !state.ends.closed;
  // The pairs of four without those that have a free end. These come last, for all others take the
  // same way.
  const auto inner = [&](const EdgeFour& four) -> unsigned {
    if (!open) return four.listed;
    if (four.first == 0) return 0;
    return last_edge < four.start + lane_count
               ? four.listed & ((1U << (last_edge - four.start)) - 1U)
               : four.listed;
  };
  const NoEnd no_end;
  const LineTable lines(state);
  // What touches is picked without branches that depend on it, for they would be mispredicted:
  // first fours of pairs,
  struct TouchingFour {
    Index first, start;
    std::array<double, lane_count> touches;
  };
  const auto touching = std::make_unique_for_overwrite<TouchingFour[]>(fours.size());
  std::size_t touching_fours = 0;
  for (const EdgeFour& four : fours) {
    const Meeting<Lanes> m =
        meet(kernel, lines.repeated(four.first), lines.four(four.start), no_end, no_end);
    const LaneMask touches = m.touches(kernel) && mask_of(inner(four));
    TouchingFour& kept = touching[touching_fours];
    kept.first = four.first;
    kept.start = four.start;
    store(select(touches, 1.0, 0.0), kept.touches.data());
    touching_fours += any_of(touches) ? 1 : 0;
  }
  // then the pairs in them.
  const auto pairs = std::make_unique_for_overwrite<EdgePair[]>(lane_count * touching_fours + 1);
  std::size_t pair_count = 0;
  for (std::size_t i = 0; i < touching_fours; ++i) {
    for (Index k = 0; k < lane_count; ++k) {
      pairs[pair_count] = {touching[i].first, touching[i].start + k};
      pair_count += touching[i].touches[static_cast<std::size_t>(k)] > 0 ? 1 : 0;
    }
  }
  ByLines by_line(last_edge + 1);
  double energy = 0;
  for (std::size_t start = 0; start < pair_count; start += lane_count) {
    const EdgePair* const four = pairs.get() + start;
    const int count = static_cast<int>(std::min<std::size_t>(lane_count, pair_count - start));
    // the lanes that are left repeat the last pair, for numbers that are finite
    const auto first_edge = [&](int k) { return four[std::min(k, count - 1)].first; };
    const auto second_edge = [&](int k) { return four[std::min(k, count - 1)].second; };
    const LineOf<Lanes> first = lines.picked(first_edge), second = lines.picked(second_edge);
    const Meeting<Lanes> m = meet(kernel, first, second, no_end, no_end);
    LineGradientOf<Lanes> gradient;
    const Lanes energies = contact_energy(kernel, m, first, second, gradient);
    for (int k = 0; k < count; ++k) {
      energy += energies[static_cast<std::size_t>(k)];
      sink.add(four[k], kernel, m, k);
    }
    by_line.add(count, first_edge, gradient.midpoint1, gradient.vector1);
    by_line.add(count, second_edge, gradient.midpoint2, gradient.vector2);
  }
  by_line.add_to_nodes(state, by_node);

  LineGradient by_ends;
  const auto add_end_pair = [&](const EdgePair& pair) {
    const Line first = line_of(state, pair.first), second = line_of(state, pair.second);
    const double e = kernel.energy(first, second, by_ends);
    if (e == 0) return;
    energy += e;
    sink.add(pair, kernel, first, second);
    add_to_edge(state, pair.first, by_ends.midpoint1, by_ends.vector1, by_node);
    add_to_edge(state, pair.second, by_ends.midpoint2, by_ends.vector2, by_node);
  };
  for (const EdgeFour& four : fours) {
    const EdgeFour ends{four.first, four.start, four.listed & ~inner(four)};
    if (ends.listed != 0) for_each_pair(std::span(&ends, 1), add_end_pair);
  }
  return energy;
}

}  // namespace

Line line_of(const RodState& state, Index edge) {
  const Vec3 a = state.nodes.col(edge);
  const Vec3 b = state.nodes.col(next_node(state, edge));
  const bool open = !state.ends.closed;
  return {(a + b) / 2, b - a, open && edge == 0, open && edge == state.edge_count() - 1};
}

double add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgeFour> pairs, Points& by_node) {
  return sum_pairs(kernel, state, pairs, by_node, Unlisted{});
}

double add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgeFour> pairs, Points& by_node,
                          std::vector<SelfContact>& touching) {
  touching.clear();
  return sum_pairs(kernel, state, pairs, by_node, Listed{touching});
}

}  // namespace wirepack
