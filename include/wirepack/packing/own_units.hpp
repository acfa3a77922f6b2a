#pragma once

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"
#include "wirepack/packing/units.hpp"
#include "wirepack/packing/work_balance.hpp"

namespace wirepack {

/// The scenario in units of its own wire, in which a = Y = rho = 1. A packing is sensitive to the
/// last bit, and 1e-8 / 1e-9 is not 10: numbers are rounded to 13 digits, so that a scenario in any
/// units becomes the same to the bit.
Scenario in_own_units(const Scenario& scenario);
/// A progress that was computed in the units of the scenario, in those of its wire.
PackingProgress in_own_units(PackingProgress progress, const Units& units);

/// What a run in units of its wire has found, in the units of the scenario.
HistoryRow in_units(HistoryRow row, const Units& units);
WorkBalance in_units(const WorkBalance& balance, const Units& units);
PackingFrame in_units(PackingFrame frame, const Units& units);

}  // namespace wirepack
