#pragma once

#include <span>
#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

struct EdgePair {
  Index first, second;  ///< first < second
};

/// Pairs of the edge `first` with some of the edges start ... start + 3: those whose bit is set.
/// `start` is a multiple of four. Strands run side by side, so pairs come in such groups, and the
/// four edges are neighbours in memory.
struct EdgeFour {
  Index first, start;
  unsigned listed;  ///< bit k stands for the pair (first, start + k)
};

/// Calls f(EdgePair) for every pair, in order.
template <class F>
void for_each_pair(std::span<const EdgeFour> fours, F&& f) {
  for (const EdgeFour& four : fours) {
    for (Index k = 0; k < 4; ++k) {
      if (four.listed >> k & 1U) f(EdgePair{four.first, four.start + k});
    }
  }
}

/// Limits within which pairs of edges may touch.
struct ContactRange {
  double touching_distance;    ///< 2 a
  double edge_length;          ///< l
  double excluded_arc_length;  ///< nearer neighbours along the wire do not touch
};

/// Smallest difference between the numbers of two edges that may touch, four at least: the extended
/// lines of nearer edges of a bent wire meet within the support of the contact kernel.
Index first_touching_neighbor(const ContactRange& range);

/// All pairs of edges whose lines come within touching distance plus a skin; from a cell grid,
/// sorted. Lines are extended by one edge length to both sides (the support of the contact kernel).
/// A superset of the touching pairs as long as `covers` holds, so it changes cost, never values.
class NeighborList {
 public:
  NeighborList() = default;
  NeighborList(const RodState& state, const ContactRange& range, double skin);

  /// True if no edge has moved so far that a pair outside the list could come within `margin` of
  /// touching.
  bool covers(const RodState& state, double margin = 0) const;
  std::span<const EdgeFour> fours() const { return fours_; }
  std::vector<EdgePair> pairs() const;

 private:
  std::vector<EdgeFour> fours_;
  Points built_at_;
  double skin_ = 0;
};

/// Pairs of edges with midpoints within `reach`, edge numbers at least `separation` apart (also
/// around a closed rod); sorted.
std::vector<EdgePair> near_edges(const RodState& state, double reach, Index separation);

}  // namespace wirepack
