#include "wirepack/packing/wire_in_nozzle.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/rotation.hpp"

namespace wirepack {

RodState wire_in_nozzle(const PackingModel& model, const Points& nodes,
                        std::span<const Quat> frames, double inserted_length) {
  const double edge = model.wire.edge_length;
  RodState rod = make_rod(nodes, model.wire, {.last_clamped = true});
  const double others = static_cast<double>(rod.edge_count() - 1) * edge;
  rod.inlet_rest_length = inserted_length - others;
  if (!(inserted_length > others && std::isfinite(inserted_length))) {
    throw InvalidInput(fmt::format(
        "inserted_length = {}: must be above {}, the rest length of all edges but the last, and "
        "finite",
        inserted_length, others));
  }
  Quat& clamp = rod.frames.back();
  clamp = initial_wire(model.nozzle, model.wire, edge).frames.back();
  remove_twist(rod);
  if (frames.empty()) return rod;
  if (static_cast<Index>(frames.size()) != rod.edge_count()) {
    throw InvalidInput(
        fmt::format("a wire of {} edges cannot have {} frames", rod.edge_count(), frames.size()));
  }
  std::copy(frames.begin(), frames.end(), rod.frames.begin());
  if (model.nozzle.twist == TwistCondition::free) {  // turns with the wire
    const Quat& last = frames.back();
    clamp = (transport(third_axis(last), model.nozzle.direction) * last).normalized();
  }
  return rod;
}

RodState wire_in_nozzle(const PackingModel& model, const PackingFrame& frame) {
  const auto edges = static_cast<std::size_t>(frame.rod.edge_count());
  return wire_in_nozzle(model, frame.rod.nodes, std::span(frame.rod.frames).first(edges),
                        frame.inserted_length);
}

}  // namespace wirepack
