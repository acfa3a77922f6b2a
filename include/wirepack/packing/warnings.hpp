#pragma once

#include <string>
#include <vector>

#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// What is possible but hardly meant, or spoils the result, a sentence each: a rest shape that
/// bends tighter than the wire's own radius, or that looks as if it was in another unit of length
/// than the cavity; a wire that twists more easily than any solid one; edges that resolve neither
/// wire nor cavity; fewer than five frames up to the expected length.
std::vector<std::string> warnings(const Scenario& scenario, double expected_length);

/// The same of a run: overlaps of surfaces beyond what contacts are meant for (`largest_overlap` in
/// the unit of the scenario), a wire that ends bent tighter than its own radius.
std::vector<std::string> warnings(const Scenario& scenario, const PackingProgress& progress,
                                  double largest_overlap);

}  // namespace wirepack
