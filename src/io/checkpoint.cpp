#include "checkpoint.hpp"

#include <string>

#include "wirepack/packing/own_units.hpp"

#include "hdf5_checksum.hpp"
#include "progress_tables.hpp"
#include "saved_values.hpp"

namespace wirepack {

namespace {

// Calls f(name, member) for every scalar of its kind; used for both directions.
template <class Progress, class F>
void for_each_checkpoint_scalar(Progress& p, F&& f) {
  f("random_state", p.random_state);
  f("substep", p.substep);
  f("last_frame_density", p.last_frame_density);
}

template <class Progress, class F>
void for_each_count(Progress& p, F&& f) {
  f("snaps", p.snaps);
  f("rollbacks", p.rollbacks);
}

template <class Balance, class F>
void for_each_work(Balance& b, F&& f) {
  f("work", b.work);
  f("released", b.released);
  f("remeshing", b.remeshing);
}

template <class Balance, class F>
void for_each_dissipation(Balance& b, F&& f) {
  f("friction", b.friction);
  f("contact_springs", b.contact_springs);
  f("viscous", b.viscous);
}

template <class Motion, class F>
void for_each_motion_scalar(Motion& m, F&& f) {
  f("time", m.time);
  f("potential", m.flow.potential);
  f("kinetic", m.flow.kinetic);
  f("stick", m.flow.stick);
  f("feed", m.flow.feed);
  f("injection_force", m.flow.injection_force);
  f("friction_power", m.flow.friction);
  f("viscous_power", m.flow.viscous);
  f("medium_power", m.flow.medium);
}

template <class Rod, class F>
void for_each_end(Rod& rod, F&& f) {
  f("closed", rod.ends.closed);
  f("first_clamped", rod.ends.first_clamped);
  f("last_clamped", rod.ends.last_clamped);
}

auto write_to(hid_t group) {
  return [group](const char* name, const auto& value) { write_attribute(group, name, value); };
}

auto read_from(hid_t group) {
  return [group](const char* name, auto& value) {
    value = read_attribute<std::remove_reference_t<decltype(value)>>(group, name);
  };
}

void write_motion(hid_t checkpoint, const MotionProgress& moving) {
  const Hdf5Handle motion = open_or_create_group(checkpoint, "motion");
  for_each_motion_scalar(moving, write_to(motion));
  write_attribute(motion, "step", moving.step);
  replace_table(motion, "nodes", table_of(moving.nodes));
  replace_table(motion, "spins", table_of(moving.spins));
  replace_table(motion, "strand_anchors", table_of(moving.friction.strands));
  replace_table(motion, "wall_anchors", table_of(moving.friction.wall));
}

MotionProgress read_motion(hid_t checkpoint) {
  const Hdf5Handle motion = open_group(checkpoint, "motion");
  MotionProgress moving;
  for_each_motion_scalar(moving, read_from(motion));
  if (has_attribute(motion, "step")) moving.step = read_attribute<double>(motion, "step");
  moving.nodes = gear_values_of(read_table<double>(motion, "nodes", 6));
  moving.spins = gear_values_of(read_table<double>(motion, "spins", 6));
  moving.friction.strands = anchors_of(read_table<double>(motion, "strand_anchors", 7));
  moving.friction.wall = anchors_of(read_table<double>(motion, "wall_anchors", 7));
  return moving;
}

void write_balance(hid_t group, const WorkBalance& balance, const PackingProgress& progress) {
  for_each_work(balance, write_to(group));
  for_each_dissipation(balance, write_to(group));
  for_each_count(progress, write_to(group));
}

void write_work_and_crossings(hid_t location, const PackingProgress& progress) {
  const Hdf5Handle work = open_or_create_group(location, "work");
  for (const auto& entry : work_counts) {
    write_attribute(work, std::string(entry.name), progress.work.*entry.value);
  }
  for (const auto& entry : work_seconds) {
    write_attribute(work, std::string(entry.name), progress.work.*entry.value);
  }
  const Hdf5Handle crossings = open_or_create_group(location, "crossings");
  replace_table(crossings, "scaled_force", table_of(progress.scaled_crossings));
  replace_table(crossings, "force", table_of(progress.absolute_crossings));
}

// Files before format version 3 have `name` beside the checkpoint and not within it.
Hdf5Handle part_of(hid_t file, hid_t checkpoint, const char* name) {
  return open_group(has_link(checkpoint, name) ? checkpoint : file, name);
}

void read_balance(hid_t file, hid_t checkpoint, PackingProgress& progress) {
  const Hdf5Handle balance = part_of(file, checkpoint, "balance");
  for_each_work(progress.balance, read_from(balance));
  if (has_attribute(balance, "friction")) {  // files of 0.1.0 have none
    for_each_dissipation(progress.balance, read_from(balance));
  }
  const bool counted = has_attribute(balance, "snaps");
  const Hdf5Handle shown =
      counted ? part_of(file, checkpoint, "balance") : open_group(file, "balance");
  for_each_count(progress, read_from(shown));
}

void read_work_and_crossings(hid_t file, hid_t checkpoint, PackingProgress& progress) {
  if (has_link(checkpoint, "work") || has_link(file, "work")) {  // files of 0.1.0 have none
    const Hdf5Handle work = part_of(file, checkpoint, "work");
    for (const auto& entry : work_counts) {
      progress.work.*entry.value = read_attribute<std::int64_t>(work, std::string(entry.name));
    }
    for (const auto& entry : work_seconds) {
      progress.work.*entry.value = read_attribute<double>(work, std::string(entry.name));
    }
  }
  const Hdf5Handle crossings = part_of(file, checkpoint, "crossings");
  progress.scaled_crossings = crossings_of(read_table<double>(crossings, "scaled_force", 2));
  progress.absolute_crossings = crossings_of(read_table<double>(crossings, "force", 2));
}

RodState read_rod(hid_t checkpoint) {
  RodState rod;
  for_each_end(rod, [&](const char* name, bool& value) {
    value = read_attribute<std::int64_t>(checkpoint, name) != 0;
  });
  rod.inlet_rest_length = read_attribute<double>(checkpoint, "inlet_rest_length");
  rod.nodes = points_of(read_table<double>(checkpoint, "nodes", 3));
  rod.frames = rotations_of(read_table<double>(checkpoint, "frames", 4));
  rod.twist_guide = read_table<double>(checkpoint, "twist_guide", 0).values;
  return rod;
}

}  // namespace

void write_checkpoint(hid_t file, const std::string& group, const PackingProgress& progress) {
  const Hdf5Handle checkpoint = open_or_create_group(file, group);
  const RodState& rod = progress.rod;
  replace_table(checkpoint, "nodes", table_of(rod.nodes));
  replace_table(checkpoint, "frames", table_of(rod.frames, static_cast<Index>(rod.frames.size())));
  replace_table(checkpoint, "twist_guide", table_of(rod.twist_guide));
  replace_table(checkpoint, "slip_memory", table_of(progress.slip_memory));
  replace_table(checkpoint, "recent_forces", table_of(progress.recent_forces));
  write_attribute(checkpoint, "inlet_rest_length", rod.inlet_rest_length);
  for_each_checkpoint_scalar(progress, write_to(checkpoint));
  write_attribute(checkpoint, "missed_by_edge", progress.work_errors.edge_share);
  write_attribute(checkpoint, "edge_scatter", progress.work_errors.edge_scatter);
  write_attribute(checkpoint, "trapezoid_error", progress.work_errors.trapezoid);
  for_each_end(rod, [&](const char* name, bool value) {
    write_attribute(checkpoint, name, static_cast<std::int64_t>(value));
  });
  const Hdf5Handle last = open_or_create_group(checkpoint, "last");
  for (const HistoryColumn& column : history_columns) {
    write_attribute(last, std::string(column.name), progress.last.*column.value);
  }
  if (progress.motion) write_motion(checkpoint, *progress.motion);
  write_balance(open_or_create_group(checkpoint, "balance"), progress.balance, progress);
  write_work_and_crossings(checkpoint, progress);
  write_checksum(checkpoint);
}

void write_shown(hid_t file, const PackingProgress& progress, const Units& units) {
  const Hdf5Handle balance = open_or_create_group(file, "balance");
  write_balance(balance, in_units(progress.balance, units), progress);
  write_attribute(balance, "energy", progress.last.energy_total * units.energy());
  write_attribute(balance, "residue", residue(progress.balance, progress.last) * units.energy());
  write_work_and_crossings(file, progress);
  write_attribute(open_group(file, "crossings"), "columns", std::string("level packing_density"));
}

PackingProgress read_checkpoint(hid_t file, const std::string& group) {
  PackingProgress progress;
  const Hdf5Handle checkpoint = open_group(file, group);
  progress.rod = read_rod(checkpoint);
  if (has_link(checkpoint, "slip_memory")) {  // files of 0.1.0 have none
    progress.slip_memory = memory_of(read_table<double>(checkpoint, "slip_memory", 6));
  }
  if (has_link(checkpoint, "recent_forces")) {  // files of 0.1.0 have none
    progress.recent_forces = forces_of(read_table<double>(checkpoint, "recent_forces", 2));
  }
  for_each_checkpoint_scalar(progress, read_from(checkpoint));
  if (has_attribute(checkpoint, "trapezoid_error")) {  // files of 0.1.0 have none
    progress.work_errors.edge_share = read_attribute<double>(checkpoint, "missed_by_edge");
    progress.work_errors.trapezoid = read_attribute<double>(checkpoint, "trapezoid_error");
  }
  if (has_attribute(checkpoint, "edge_scatter")) {  // older files have none
    progress.work_errors.edge_scatter = read_attribute<double>(checkpoint, "edge_scatter");
  }
  const Hdf5Handle last = open_group(checkpoint, "last");
  for (const HistoryColumn& column : history_columns) {
    const bool optional = column.of != ColumnOf::every_run || column.added_later;
    if (optional && !has_attribute(last, std::string(column.name))) continue;
    progress.last.*column.value = read_attribute<double>(last, std::string(column.name));
  }
  if (has_link(checkpoint, "motion")) progress.motion = read_motion(checkpoint);
  read_balance(file, checkpoint, progress);
  read_work_and_crossings(file, checkpoint, progress);
  check_progress(progress);
  return progress;
}

}  // namespace wirepack
