#include "saved_values.hpp"

#include <algorithm>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"

namespace wirepack {

namespace {

void require(bool holds, const char* problem) {
  if (!holds) throw FileError(problem);
}

bool are_there(Index first, Index second, Index count) {
  // a second one of -1 is the wall
  return 0 <= first && first < count && -1 <= second && second < count;
}

void check_motion(const MotionProgress& motion, const RodState& rod) {
  require(motion.nodes.rows() == rod.nodes.size() &&
              motion.spins.rows() == static_cast<Index>(rod.frames.size()),
          "a checkpoint has derivatives of unfitting lengths");
  require(motion.time >= 0, "a checkpoint is before the start");
  for (const auto* anchors : {&motion.friction.strands, &motion.friction.wall}) {
    for (const StickAnchor& anchor : *anchors) {
      require(are_there(anchor.first, anchor.second, rod.node_count()),
              "a checkpoint has a contact of nodes that are not there");
    }
  }
}

}  // namespace

void check_progress(const PackingProgress& progress) {
  const RodState& rod = progress.rod;
  const auto clamps = static_cast<Index>(rod.ends.first_clamped) + rod.ends.last_clamped;
  require(!rod.ends.closed && rod.node_count() >= 2 &&
              static_cast<Index>(rod.frames.size()) == rod.edge_count() + clamps &&
              static_cast<Index>(rod.twist_guide.size()) == rod.node_count(),
          "a checkpoint has lists of unfitting lengths");
  require(rod.inlet_rest_length > 0, "a checkpoint has an inlet edge without length");
  check_state(rod);
  require(smallest_substep <= progress.substep && progress.substep <= 1,
          "a checkpoint has an impossible part of an increment");
  require(progress.snaps >= 0 && progress.rollbacks >= 0, "a checkpoint has negative counts");
  for (const SlipMemory& memory : progress.slip_memory) {
    require(are_there(memory.edges.first, memory.edges.second, rod.node_count()),
            "a checkpoint has a contact of edges that are not there");
  }
  const auto& forces = progress.recent_forces;
  const auto out_of_order = std::adjacent_find(forces.begin(), forces.end(),
                                               [](const ForceReading& a, const ForceReading& b) {
                                                 return !(a.inserted_length < b.inserted_length);
                                               });
  require(out_of_order == forces.end(), "a checkpoint has forces out of order");
  if (progress.motion) check_motion(*progress.motion, rod);
}

void check_history(const std::vector<HistoryRow>& rows) {
  double increment = 0, length = 0;
  for (const HistoryRow& row : rows) {
    require(row.increment == ++increment, "the increments of its history are not 1, 2, 3, ...");
    require(row.inserted_length > length && row.packing_density > 0,
            "the wire of its history does not get longer");
    length = row.inserted_length;
  }
}

void check_frame(const PackingFrame& frame) {
  const Index n = frame.rod.node_count();
  require(n >= 2 && static_cast<Index>(frame.rod.frames.size()) == n - 1 &&
              frame.bend_energy.size() == n && frame.twist_energy.size() == n &&
              frame.wall_force.size() == n,
          "a frame has lists of unfitting lengths");
  for (const SelfContact& contact : frame.contacts) {
    const auto [first, second] = contact.edges;
    require(0 <= first && first < second && second < n - 1,
            "a frame has a contact of edges that are not there");
  }
}

}  // namespace wirepack
