#include "wirepack/contact/contact_sum.hpp"

#include <array>
#include <cmath>

#include "line_meeting.hpp"

namespace wirepack {

namespace {

using FourPairs = std::array<EdgePair, lane_count>;

template <class Edge>
[[gnu::always_inline]] inline LineOf<Lanes> lines_of(const RodState& state, Edge&& edge) {
  const Triple<Lanes> a = columns_of(state.nodes, edge);
  const Triple<Lanes> b = columns_of(state.nodes, [&](int k) { return next_node(state, edge(k)); });
  return {Lanes(0.5) * (a + b), b - a};
}

[[gnu::always_inline]] inline LineOf<Lanes> first_lines(const RodState& state,
                                                        const FourPairs& pairs) {
  return lines_of(state, [&](int k) { return pairs[static_cast<std::size_t>(k)].first; });
}
[[gnu::always_inline]] inline LineOf<Lanes> second_lines(const RodState& state,
                                                         const FourPairs& pairs) {
  return lines_of(state, [&](int k) { return pairs[static_cast<std::size_t>(k)].second; });
}

void add_to_edge(const RodState& state, Index edge, const Vec3& by_midpoint, const Vec3& by_vector,
                 Points& by_node) {
  by_node.col(edge) += by_midpoint / 2 - by_vector;
  by_node.col(next_node(state, edge)) += by_midpoint / 2 + by_vector;
}

// Pairs waiting until four are together; every pair is handed on once, in order.
struct Batch {
  FourPairs pairs{};
  int size = 0;

  bool add(const EdgePair& pair) {
    pairs[static_cast<std::size_t>(size++)] = pair;
    return size == lane_count;
  }
  // The lanes that are left repeat the first pair, for numbers that are finite.
  void fill_up() {
    for (int k = size; k < lane_count; ++k) pairs[static_cast<std::size_t>(k)] = pairs[0];
  }
};

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
double sum_pairs(const LineKernel& kernel, const RodState& state, std::span<const EdgePair> pairs,
                 Points& by_node, Sink sink) {
  const Index last_edge = state.edge_count() - 1;
  const bool open = !state.ends.closed;
  const NoEnd no_end;
  double energy = 0;
  Batch candidates, touching;

  const auto add_touching = [&] {
    const int count = touching.size;
    touching.fill_up();
    const LineOf<Lanes> first = first_lines(state, touching.pairs);
    const LineOf<Lanes> second = second_lines(state, touching.pairs);
    const Meeting<Lanes> m = meet(kernel, first, second, no_end, no_end);
    LineGradientOf<Lanes> gradient;
    const Lanes energies = contact_energy(kernel, m, first, second, gradient);
    for (int k = 0; k < count; ++k) {
      const EdgePair& pair = touching.pairs[static_cast<std::size_t>(k)];
      energy += energies[static_cast<std::size_t>(k)];
      sink.add(pair, kernel, m, k);
      add_to_edge(state, pair.first, lane(gradient.midpoint1, k), lane(gradient.vector1, k),
                  by_node);
      add_to_edge(state, pair.second, lane(gradient.midpoint2, k), lane(gradient.vector2, k),
                  by_node);
    }
    touching.size = 0;
  };
  const auto sift_candidates = [&] {
    const int count = candidates.size;
    candidates.fill_up();
    const Meeting<Lanes> m = meet(kernel, first_lines(state, candidates.pairs),
                                  second_lines(state, candidates.pairs), no_end, no_end);
    const LaneMask touches = m.touches(kernel);
    candidates.size = 0;
    if (none_of(touches)) return;
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (touches[i] && touching.add(candidates.pairs[i])) add_touching();
    }
  };

  // Pairs with a free end come last, so that the order of the sum depends on what touches alone and
  // not on the other candidates.
  const auto has_end = [&](const EdgePair& pair) {
    return open && (pair.first == 0 || pair.second == last_edge);
  };
  for (const EdgePair& pair : pairs) {
    if (!has_end(pair) && candidates.add(pair)) sift_candidates();
  }
  if (candidates.size > 0) sift_candidates();
  if (touching.size > 0) add_touching();
  LineGradient by_line;
  for (const EdgePair& pair : pairs) {
    if (!has_end(pair)) continue;
    const Line first = line_of(state, pair.first), second = line_of(state, pair.second);
    const double e = kernel.energy(first, second, by_line);
    if (e == 0) continue;
    energy += e;
    sink.add(pair, kernel, first, second);
    add_to_edge(state, pair.first, by_line.midpoint1, by_line.vector1, by_node);
    add_to_edge(state, pair.second, by_line.midpoint2, by_line.vector2, by_node);
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
                          std::span<const EdgePair> pairs, Points& by_node) {
  return sum_pairs(kernel, state, pairs, by_node, Unlisted{});
}

double add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgePair> pairs, Points& by_node,
                          std::vector<SelfContact>& touching) {
  touching.clear();
  return sum_pairs(kernel, state, pairs, by_node, Listed{touching});
}

}  // namespace wirepack
