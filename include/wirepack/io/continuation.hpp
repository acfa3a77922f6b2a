#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// What keeps a run of one scenario from being continued with another: every key that differs, as
/// "section.key: was x, is now y" on lines of their own: those of `given`, then the others, in the
/// order of resolved_config(). Stop limits and [output] may differ.
std::optional<std::string> continuation_conflict(const Scenario& was, const Scenario& now,
                                                 const std::vector<std::string>& given = {});

/// Differences in [minimizer] and [insertion], which say how the next equilibrium is looked for: a
/// run that has found none may go on with other values.
std::vector<std::string> search_changes(const Scenario& was, const Scenario& now);

}  // namespace wirepack
