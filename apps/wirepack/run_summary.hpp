#pragma once

#include <string>

#include "wirepack/io/recorded_run.hpp"
#include "wirepack/packing/declared_units.hpp"

namespace wirepack {

/// The result in numbers, as lines that start with '#'. Forces and energies also in the unit of the
/// configuration, by its name if it is declared.
std::string summary(const RecordedRun& run, const Scenario& scenario,
                    const DeclaredUnits& names = {});

}  // namespace wirepack
