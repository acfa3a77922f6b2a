#include "wirepack/core/value_problems.hpp"

#include <cmath>
#include <sstream>

namespace wirepack {

bool is_positive(double value) { return std::isfinite(value) && value > 0; }

bool is_not_negative(double value) { return std::isfinite(value) && value >= 0; }

void require(bool ok, std::string_view key, double value, std::string_view allowed,
             std::vector<std::string>& problems) {
  if (ok) return;
  std::ostringstream text;
  text << key << " = " << value << ": " << allowed;
  problems.push_back(text.str());
}

}  // namespace wirepack
