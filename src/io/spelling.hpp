#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wirepack {

/// The candidate that was probably meant by a word, or an empty one.
std::string nearest(std::string_view given, const std::vector<std::string>& candidates);

}  // namespace wirepack
