#include "wirepack/energy/gradient.hpp"

namespace wirepack {

void set_zero(Gradient& gradient, const RodState& state) {
  gradient.node.setZero(3, state.node_count());
  gradient.frame.setZero(3, static_cast<Index>(state.frames.size()));
  gradient.inlet_length = 0;
}

}  // namespace wirepack
