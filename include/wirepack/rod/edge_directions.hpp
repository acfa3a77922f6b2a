#pragma once

#include <cmath>

#include "wirepack/core/lanes.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Unit tangent and length of an edge, or of four edges.
template <class T>
struct EdgeDirection {
  Triple<T> tangent;
  T length;
};

template <class T>
[[gnu::always_inline]] inline EdgeDirection<T> edge_direction(const Triple<T>& from,
                                                              const Triple<T>& to) {
  using std::sqrt;
  const Triple<T> e = to - from;
  const T length = sqrt(dot(e, e));
  return {(1.0 / length) * e, length};
}

/// Calls f(j, direction) for the edges that join nodes j and j + 1, four in lanes where there are
/// four, then for the edge that closes the wire.
template <class F>
void for_each_edge_direction(const RodState& state, F&& f) {
  const Points& nodes = state.nodes;
  const Index last = state.node_count() - 1;
  for_each_in_lanes(0, last, [&]<class T>(Index j) {
    f(j, edge_direction(load_columns<T>(nodes, j), load_columns<T>(nodes, j + 1)));
  });
  if (!state.ends.closed) return;
  f(last, edge_direction(load_columns<double>(nodes, last), load_columns<double>(nodes, 0)));
}

}  // namespace wirepack
