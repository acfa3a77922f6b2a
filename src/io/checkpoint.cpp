#include "checkpoint.hpp"

#include <algorithm>
#include <string>

namespace wirepack {

namespace {

using CrossingList = std::vector<ForceCrossing>;

// Calls f(name, member) for every scalar of /checkpoint and /balance; used for both directions.
template <class Progress, class F>
void for_each_checkpoint_scalar(Progress& p, F&& f) {
  f("inlet_rest_length", p.rod.inlet_rest_length);
  f("random_state", p.random_state);
  f("substep", p.substep);
  f("last_frame_density", p.last_frame_density);
}

template <class Progress, class F>
void for_each_balance_scalar(Progress& p, F&& f) {
  f("work", p.balance.work);
  f("released", p.balance.released);
  f("remeshing", p.balance.remeshing);
  f("snaps", p.snaps);
  f("rollbacks", p.rollbacks);
}

template <class Progress, class F>
void for_each_end(Progress& p, F&& f) {
  f("closed", p.rod.ends.closed);
  f("first_clamped", p.rod.ends.first_clamped);
  f("last_clamped", p.rod.ends.last_clamped);
}

Hdf5Table<double> table_of(const CrossingList& crossings) {
  Hdf5Table<double> table{{}, crossings.size(), 2};
  for (const ForceCrossing& c : crossings) {
    table.values.push_back(c.level);
    table.values.push_back(c.packing_density);
  }
  return table;
}

CrossingList crossings_of(const Hdf5Table<double>& table) {
  CrossingList crossings;
  for (std::size_t i = 0; i < table.values.size(); i += 2) {
    crossings.push_back({table.values[i], table.values[i + 1]});
  }
  return crossings;
}

Hdf5Table<double> list_of(const std::vector<double>& values) { return {values, values.size(), 0}; }

void require_sizes(const RodState& rod) {
  const auto clamps = static_cast<Index>(rod.ends.first_clamped) + rod.ends.last_clamped;
  if (rod.node_count() < 2 || static_cast<Index>(rod.frames.size()) != rod.edge_count() + clamps ||
      static_cast<Index>(rod.twist_guide.size()) != rod.node_count()) {
    throw FileError("checkpoint has lists of unfitting lengths");
  }
}

}  // namespace

Hdf5Table<double> table_of(const Points& points) {
  return {std::vector<double>(points.data(), points.data() + points.size()),
          static_cast<hsize_t>(points.cols()), 3};
}

Points points_of(const Hdf5Table<double>& table) {
  return Eigen::Map<const Points>(table.values.data(), 3, static_cast<Index>(table.rows));
}

Hdf5Table<double> table_of(const std::vector<Quat>& rotations, Index count) {
  Hdf5Table<double> table{{}, static_cast<hsize_t>(count), 4};
  for (Index i = 0; i < count; ++i) {
    const Quat& q = rotations[static_cast<std::size_t>(i)];
    table.values.insert(table.values.end(), {q.w(), q.x(), q.y(), q.z()});
  }
  return table;
}

std::vector<Quat> rotations_of(const Hdf5Table<double>& table) {
  std::vector<Quat> rotations;
  for (std::size_t i = 0; i < table.values.size(); i += 4) {
    const double* v = table.values.data() + i;
    rotations.emplace_back(v[0], v[1], v[2], v[3]);
  }
  return rotations;
}

void write_progress(hid_t file, const PackingProgress& progress) {
  const auto write_to = [](hid_t group) {
    return [group](const char* name, const auto& value) { write_attribute(group, name, value); };
  };
  const Hdf5Handle checkpoint = open_or_create_group(file, "checkpoint");
  const RodState& rod = progress.rod;
  replace_table(checkpoint, "nodes", table_of(rod.nodes));
  replace_table(checkpoint, "frames", table_of(rod.frames, static_cast<Index>(rod.frames.size())));
  replace_table(checkpoint, "twist_guide", list_of(rod.twist_guide));
  for_each_checkpoint_scalar(progress, write_to(checkpoint));
  for_each_end(progress, [&](const char* name, bool value) {
    write_attribute(checkpoint, name, static_cast<std::int64_t>(value));
  });
  const Hdf5Handle last = open_or_create_group(checkpoint, "last");
  for (const HistoryColumn& column : history_columns) {
    write_attribute(last, std::string(column.name), progress.last.*column.value);
  }

  const Hdf5Handle balance = open_or_create_group(file, "balance");
  for_each_balance_scalar(progress, write_to(balance));
  const WorkBalance& b = progress.balance;
  write_attribute(balance, "energy", progress.last.energy_total);
  write_attribute(balance, "residue",
                  b.work - progress.last.energy_total - b.released - b.remeshing);

  const Hdf5Handle work = open_or_create_group(file, "work");
  for (const auto& entry : work_counts) {
    write_attribute(work, std::string(entry.name), progress.work.*entry.value);
  }
  for (const auto& entry : work_seconds) {
    write_attribute(work, std::string(entry.name), progress.work.*entry.value);
  }

  const Hdf5Handle crossings = open_or_create_group(file, "crossings");
  write_attribute(crossings, "columns", std::string("level packing_density"));
  replace_table(crossings, "scaled_force", table_of(progress.scaled_crossings));
  replace_table(crossings, "force", table_of(progress.absolute_crossings));
}

PackingProgress read_progress(hid_t file) {
  const auto read_from = [](hid_t group) {
    return [group](const char* name, auto& value) {
      value = read_attribute<std::remove_reference_t<decltype(value)>>(group, name);
    };
  };
  PackingProgress progress;
  const Hdf5Handle checkpoint = open_group(file, "checkpoint");
  RodState& rod = progress.rod;
  for_each_end(progress, [&](const char* name, bool& value) {
    value = read_attribute<std::int64_t>(checkpoint, name) != 0;
  });
  rod.nodes = points_of(read_table<double>(checkpoint, "nodes", 3));
  rod.frames = rotations_of(read_table<double>(checkpoint, "frames", 4));
  rod.twist_guide = read_table<double>(checkpoint, "twist_guide", 0).values;
  for_each_checkpoint_scalar(progress, read_from(checkpoint));
  require_sizes(rod);
  const Hdf5Handle last = open_group(checkpoint, "last");
  for (const HistoryColumn& column : history_columns) {
    const bool optional = column.of != ColumnOf::every_run;
    if (optional && !has_attribute(last, std::string(column.name))) continue;
    progress.last.*column.value = read_attribute<double>(last, std::string(column.name));
  }
  for_each_balance_scalar(progress, read_from(open_group(file, "balance")));
  if (has_link(file, "work")) {  // files of 0.1.0 have none
    const Hdf5Handle work = open_group(file, "work");
    for (const auto& entry : work_counts) {
      progress.work.*entry.value = read_attribute<std::int64_t>(work, std::string(entry.name));
    }
    for (const auto& entry : work_seconds) {
      progress.work.*entry.value = read_attribute<double>(work, std::string(entry.name));
    }
  }
  const Hdf5Handle crossings = open_group(file, "crossings");
  progress.scaled_crossings = crossings_of(read_table<double>(crossings, "scaled_force", 2));
  progress.absolute_crossings = crossings_of(read_table<double>(crossings, "force", 2));
  return progress;
}

}  // namespace wirepack
