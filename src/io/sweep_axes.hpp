#pragma once

#include <string>
#include <vector>

#include "toml_text.hpp"

namespace wirepack {

/// A value of a key in a plan.
struct SweepValue {
  std::string key;    ///< "cavity.radius"
  std::string value;  ///< as TOML
  std::string shown;  ///< as names and tables show it: a string without quotes
  std::string where;  ///< "file:line:column"
};

/// What one point of an axis sets; a case has a name of its own.
struct SweepPoint {
  std::string case_name;
  std::vector<SweepValue> values;
};

/// Points of which each task takes one.
struct SweepAxis {
  std::vector<std::string> keys;  ///< that its points set, or "case"
  std::vector<SweepPoint> points;
};

/// The axes of the table [sweep], in the order of the text. Adds to the problems, a line each.
/// Takes zips and cases out of the table, as a copy of it would not know its places in the text.
std::vector<SweepAxis> sweep_axes(toml::table& sweep, const std::string& source,
                                  std::vector<std::string>& problems);

/// The values of sections of a configuration, in the order of the text; values of keys may be all
/// but tables. `sections` holds sections alone.
std::vector<SweepValue> section_values(const toml::table& sections, const std::string& source,
                                       std::vector<std::string>& problems);

}  // namespace wirepack
