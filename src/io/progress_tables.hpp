#pragma once

#include "wirepack/packing/packing_progress.hpp"

#include "hdf5_values.hpp"

namespace wirepack {

// Lists of a progress or a frame as tables of numbers, and back, bit for bit. Edge and node numbers
// are exact in a double.

/// N x 3 as files keep points; HDF5's row order is the memory order of Points.
Hdf5Table<double> table_of(const Points& points);
Points points_of(const Hdf5Table<double>& table);

/// The first `count` rotations, each as w, x, y, z.
Hdf5Table<double> table_of(const std::vector<Quat>& rotations, Index count);
std::vector<Quat> rotations_of(const Hdf5Table<double>& table);

/// One column.
Hdf5Table<double> table_of(const std::vector<double>& values);

/// A row for each component: the value and its five derivatives.
Hdf5Table<double> table_of(const GearValues& values);
GearValues gear_values_of(const Hdf5Table<double>& table);

/// Columns: first, second, spring (3), normal force, sliding (0 | 1).
Hdf5Table<double> table_of(const std::vector<StickAnchor>& anchors);
std::vector<StickAnchor> anchors_of(const Hdf5Table<double>& table);

/// Columns: first, second, spring (3), slid.
Hdf5Table<double> table_of(const std::vector<SlipMemory>& memory);
std::vector<SlipMemory> memory_of(const Hdf5Table<double>& table);

/// Columns: level, packing density.
Hdf5Table<double> table_of(const std::vector<ForceCrossing>& crossings);
std::vector<ForceCrossing> crossings_of(const Hdf5Table<double>& table);

/// Columns: inserted length, force.
Hdf5Table<double> table_of(const std::vector<ForceReading>& forces);
std::vector<ForceReading> forces_of(const Hdf5Table<double>& table);

}  // namespace wirepack
