#pragma once

#include <string>
#include <vector>

namespace wirepack {

/// Throws InvalidInput with the problems, a line each, unless there are none; of very many only the
/// first.
void require_none(const std::vector<std::string>& problems);

}  // namespace wirepack
