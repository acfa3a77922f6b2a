#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/observe/coil_report.hpp"
#include "wirepack/observe/contact_patches.hpp"
#include "wirepack/observe/knot.hpp"
#include "wirepack/observe/log_normal.hpp"
#include "wirepack/observe/radial_density.hpp"
#include "wirepack/observe/sample.hpp"
#include "wirepack/observe/shell_order.hpp"
#include "wirepack/observe/strand_spacing.hpp"
#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// One frame of one run with all that is computed from it.
struct ObservedFrame {
  std::string run;
  Scenario scenario;
  HistoryRow row;
  std::int64_t increment = 0;
  CoilReport coils;
  double tangent_order = 0;
  StrandSpacing spacing;
  std::vector<ContactPatch> contacts;
  Sample contact_force, contact_angle;  ///< over the patches [force], [rad]
  LogNormalFit bend_energy;             ///< of the energies of the joints over their mean
  Sample curvature, loops;              ///< [1 / length], [length]
  KnotType knot;
  std::vector<ShellDensity> density;
  std::vector<ShellOrder> order;
};

ObservedFrame observe_frame(const std::string& run, const Scenario& scenario, const HistoryRow& row,
                            PackingFrame frame);

/// A number of a frame: name, unit, and whether it counts something.
struct Quantity {
  std::string_view name, unit;
  double (*of)(const ObservedFrame&);
  bool whole = false;
};
/// What `wirepack analyze` prints; not a number where the packing has too little of it.
std::span<const Quantity> frame_quantities();

}  // namespace wirepack
