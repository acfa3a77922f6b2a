#include "wirepack/contact/contact_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "wirepack/core/threads.hpp"

#include "line_meeting.hpp"

namespace wirepack {

namespace {

// Lines of all edges: a column for each of the seven numbers of a line, filled up to whole lanes.
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

// Derivative by the lines of the edges from `start` on. An edge has eight numbers: that by the
// midpoint from the first on, that by the vector from the fifth on.
class ByLines {
 public:
  ByLines(Index start, Index edges)
      : start_(start), values_(Eigen::VectorXd::Zero(8 * (edges - start))) {}

  template <class F>
  [[gnu::always_inline]] void add(int count, F&& edge, const Triple<Lanes>& midpoint,
                                  const Triple<Lanes>& vector) {
    const Lanes zero = 0.0;
    const auto m = transposed(midpoint.x, midpoint.y, midpoint.z, zero);
    const auto v = transposed(vector.x, vector.y, vector.z, zero);
    for (int k = 0; k < count; ++k) {
      double* const p = values_.data() + 8 * (edge(k) - start_);
      store(load<Lanes>(p) + m[static_cast<std::size_t>(k)], p);
      store(load<Lanes>(p + 4) + v[static_cast<std::size_t>(k)], p + 4);
    }
  }
  void add_to_nodes(const RodState& state, Points& by_node) const {
    for (Index j = start_; j < state.edge_count(); ++j) {
      const Index k = 8 * (j - start_);
      const auto midpoint = values_.segment<3>(k), vector = values_.segment<3>(k + 4);
      by_node.col(j) += midpoint / 2 - vector;
      by_node.col(next_node(state, j)) += midpoint / 2 + vector;
    }
  }

 private:
  Index start_;
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

// Receivers of the touching pairs: Unlisted drops them, Listed lists them.
struct Unlisted {
  void add(const EdgePair&, const LineKernel&, const Meeting<Lanes>&, int) const {}
  void add(const EdgePair&, const LineKernel&, const Line&, const Line&) const {}
  void add(const Unlisted&) const {}
};

struct Listed {
  std::vector<SelfContact> touching;

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
    if (overlap <= 0) return;  // picked by round-off
    touching.push_back({pair, line, overlap, line.stiffness * overlap});
  }
  void add(const Listed& more) {
    touching.insert(touching.end(), more.touching.begin(), more.touching.end());
  }
};

// Pairs of a four that have no free end: all of these take the same way. The others come last.
unsigned inner_pairs(const EdgeFour& four, const RodState& state) {
  if (state.ends.closed) return four.listed;
  if (four.first == 0) return 0;
  const Index last_edge = state.edge_count() - 1;
  return last_edge < four.start + lane_count ? four.listed & ((1U << (last_edge - four.start)) - 1U)
                                             : four.listed;
}

// Sum over some pairs.
template <class Sink>
struct Sum {
  Energy energy;
  ByLines by_line;
  Sink sink;
};

template <class Sink>
Sum<Sink> sum_inner_pairs(const LineKernel& kernel, const RodState& state, const LineTable& lines,
                          std::span<const EdgeFour> fours) {
  const NoEnd no_end;
  // Touching pairs are picked without branches, which would be mispredicted: first fours in which a
  // pair touches,
  struct TouchingFour {
    Index first, start;
    std::array<double, lane_count> touches;
  };
  const auto touching = std::make_unique_for_overwrite<TouchingFour[]>(fours.size());
  std::size_t touching_fours = 0;
  for (const EdgeFour& four : fours) {
    const LaneMask touches =
        touch_inside(kernel, lines.repeated(four.first), lines.four(four.start)) &&
        mask_of(inner_pairs(four, state));
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
  Sum<Sink> sum{{}, ByLines(fours.front().first, state.edge_count()), {}};
  for (std::size_t start = 0; start < pair_count; start += lane_count) {
    const EdgePair* const four = pairs.get() + start;
    const int count = static_cast<int>(std::min<std::size_t>(lane_count, pair_count - start));
    // lanes without a pair repeat the last one, so that their numbers are finite
    const auto first_edge = [&](int k) { return four[std::min(k, count - 1)].first; };
    const auto second_edge = [&](int k) { return four[std::min(k, count - 1)].second; };
    const LineOf<Lanes> first = lines.picked(first_edge), second = lines.picked(second_edge);
    const Meeting<Lanes> m = meet(kernel, first, second, no_end, no_end);
    LineGradientOf<Lanes> gradient;
    const Lanes energies = contact_energy(kernel, m, first, second, gradient);
    for (int k = 0; k < count; ++k) {
      sum.energy += energies[static_cast<std::size_t>(k)];
      sum.sink.add(four[k], kernel, m, k);
    }
    sum.by_line.add(count, first_edge, gradient.midpoint1, gradient.vector1);
    sum.by_line.add(count, second_edge, gradient.midpoint2, gradient.vector2);
  }
  return sum;
}

// Pairs are added up in shares, by their first edges. The neighbor list must not decide which share
// a pair goes to, as it depends on earlier states. Shares are few, as each keeps derivatives by
// nearly all edges.
constexpr Index edges_of_a_share = 400, most_shares = 8;

// Pairs of each share. The later an edge comes, the fewer partners with higher numbers it has in
// the mean, so the first share has the fewest edges.
std::vector<std::span<const EdgeFour>> shares_of(std::span<const EdgeFour> fours, Index edges) {
  const Index count = std::clamp<Index>(edges / edges_of_a_share, 1, most_shares);
  std::vector<std::span<const EdgeFour>> shares;
  auto start = fours.begin();
  for (Index k = 1; k <= count; ++k) {
    const double left = 1 - static_cast<double>(k) / static_cast<double>(count);
    const auto last = static_cast<Index>(static_cast<double>(edges) * (1 - std::sqrt(left)));
    const auto end = std::partition_point(start, fours.end(),
                                          [&](const EdgeFour& four) { return four.first < last; });
    if (end != start) shares.emplace_back(start, end);
    start = end;
  }
  return shares;
}

template <class Sink>
Energy sum_pairs(const LineKernel& kernel, const RodState& state, std::span<const EdgeFour> fours,
                 Points& by_node, Sink& sink) {
  const LineTable lines(state);
  const auto shares = shares_of(fours, state.edge_count());
  std::vector<std::optional<Sum<Sink>>> sums(shares.size());
  for_each_tile(static_cast<Index>(shares.size()), 1, true, [&](Index k, Index) {
    const auto share = static_cast<std::size_t>(k);
    sums[share] = sum_inner_pairs<Sink>(kernel, state, lines, shares[share]);
  });
  Energy energy;
  for (const auto& sum : sums) {
    energy += sum->energy;
    sum->by_line.add_to_nodes(state, by_node);
    sink.add(sum->sink);
  }

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
    const EdgeFour ends{four.first, four.start, four.listed & ~inner_pairs(four, state)};
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

Energy add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgeFour> pairs, Points& by_node) {
  Unlisted sink;
  return sum_pairs(kernel, state, pairs, by_node, sink);
}

Energy add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgeFour> pairs, Points& by_node,
                          std::vector<SelfContact>& touching) {
  Listed sink;
  const Energy energy = sum_pairs(kernel, state, pairs, by_node, sink);
  touching = std::move(sink.touching);
  return energy;
}

}  // namespace wirepack
