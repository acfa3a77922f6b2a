#pragma once

#include <vector>

#include "column_groups.hpp"

namespace wirepack {

/// Order in which groups are eliminated, so that their factor has few new entries: place -> group.
/// Few groups: Eigen's approximate minimum degree (Amestoy, Davis and Duff 1996). Many: nested
/// dissection by METIS (Karypis and Kumar 1998), which takes longer and saves a third to a half of
/// the work of the factorization.
std::vector<int> elimination_order(const ColumnGroups& groups);

}  // namespace wirepack
