#pragma once

#include <cstdint>
#include <string_view>

namespace wirepack {

inline constexpr std::string_view result_format = "wirepack";
/// Raised when a reader of the old layout would misread the new one.
inline constexpr std::int64_t result_format_version = 1;

}  // namespace wirepack
