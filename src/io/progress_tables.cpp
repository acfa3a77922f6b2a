#include "progress_tables.hpp"

namespace wirepack {

Hdf5Table<double> table_of(const GearValues& values) {
  Hdf5Table<double> table{{}, static_cast<hsize_t>(values.rows()), 6};
  for (Index i = 0; i < values.rows(); ++i) {
    for (Index k = 0; k < 6; ++k) table.values.push_back(values(i, k));
  }
  return table;
}

GearValues gear_values_of(const Hdf5Table<double>& table) {
  GearValues values(static_cast<Index>(table.rows), 6);
  for (Index i = 0; i < values.rows(); ++i) {
    for (Index k = 0; k < 6; ++k) values(i, k) = table.values[static_cast<std::size_t>(6 * i + k)];
  }
  return values;
}

Hdf5Table<double> table_of(const std::vector<StickAnchor>& anchors) {
  Hdf5Table<double> table{{}, anchors.size(), 7};
  for (const StickAnchor& a : anchors) {
    table.values.insert(table.values.end(),
                        {static_cast<double>(a.first), static_cast<double>(a.second), a.spring.x(),
                         a.spring.y(), a.spring.z(), a.normal_force, a.sliding ? 1.0 : 0.0});
  }
  return table;
}

std::vector<StickAnchor> anchors_of(const Hdf5Table<double>& table) {
  std::vector<StickAnchor> anchors;
  for (std::size_t i = 0; i < table.values.size(); i += 7) {
    const double* v = table.values.data() + i;
    anchors.push_back({static_cast<Index>(v[0]), static_cast<Index>(v[1]), Vec3(v[2], v[3], v[4]),
                       v[5], v[6] != 0});
  }
  return anchors;
}

Hdf5Table<double> table_of(const std::vector<ForceCrossing>& crossings) {
  Hdf5Table<double> table{{}, crossings.size(), 2};
  for (const ForceCrossing& c : crossings) {
    table.values.push_back(c.level);
    table.values.push_back(c.packing_density);
  }
  return table;
}

Hdf5Table<double> table_of(const std::vector<ForceReading>& forces) {
  Hdf5Table<double> table{{}, forces.size(), 2};
  for (const auto& [length, force] : forces) {
    table.values.insert(table.values.end(), {length, force});
  }
  return table;
}

std::vector<ForceReading> forces_of(const Hdf5Table<double>& table) {
  std::vector<ForceReading> forces;
  for (std::size_t i = 0; i < table.values.size(); i += 2) {
    forces.push_back({table.values[i], table.values[i + 1]});
  }
  return forces;
}

std::vector<ForceCrossing> crossings_of(const Hdf5Table<double>& table) {
  std::vector<ForceCrossing> crossings;
  for (std::size_t i = 0; i < table.values.size(); i += 2) {
    crossings.push_back({table.values[i], table.values[i + 1]});
  }
  return crossings;
}

Hdf5Table<double> table_of(const std::vector<SlipMemory>& memory) {
  Hdf5Table<double> table{{}, memory.size(), 6};
  for (const SlipMemory& m : memory) {
    table.values.insert(table.values.end(),
                        {static_cast<double>(m.edges.first), static_cast<double>(m.edges.second),
                         m.spring.x(), m.spring.y(), m.spring.z(), m.slid});
  }
  return table;
}

std::vector<SlipMemory> memory_of(const Hdf5Table<double>& table) {
  std::vector<SlipMemory> memory;
  for (std::size_t i = 0; i < table.values.size(); i += 6) {
    const double* v = table.values.data() + i;
    memory.push_back(
        {{static_cast<Index>(v[0]), static_cast<Index>(v[1])}, Vec3(v[2], v[3], v[4]), v[5]});
  }
  return memory;
}

Hdf5Table<double> table_of(const std::vector<double>& values) { return {values, values.size(), 0}; }

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

}  // namespace wirepack
