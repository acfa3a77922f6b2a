#pragma once

#include <optional>
#include <span>
#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Injection force of one row.
struct ForceReading {
  double inserted_length, force;
};

/// Adds the reading of a row and drops those that the mean over `fed` needs no more.
void note_force(double fed, const HistoryRow& row, std::vector<ForceReading>& recent);

/// Mean injection force over the last length of wire `fed`, at least an edge. The force alternates
/// with the phase of the mesh, once an edge, and how high a peak is read depends on the increments;
/// the mean is that of the wire. Trapezoids between readings; where a whole edge was fed between
/// two, they read one phase alone, at which the force is its mean: the reading itself. Nothing
/// before so much has been fed.
std::optional<double> mean_force(double fed, std::span<const ForceReading> recent);

/// That mean at a packing density.
struct MeanForce {
  double packing_density, force;
};

/// The means over `fed`, or over an edge where that is longer, after a run's first coil
/// (first_coil_length): the straight wire before it buckles at a force that says nothing of the
/// packing.
std::vector<MeanForce> mean_forces(const Scenario& scenario, const std::vector<HistoryRow>& history,
                                   double fed = 0);

/// Density at which the mean force first reaches `force`. Nothing where it stays below, nor where
/// it is above from the start: that density would be the first coil's, of whatever packing.
std::optional<double> density_at_force(const std::vector<MeanForce>& means, double force);

}  // namespace wirepack
