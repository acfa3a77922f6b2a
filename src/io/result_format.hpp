#pragma once

#include <cstdint>
#include <string_view>

namespace wirepack {

inline constexpr std::string_view result_format = "wirepack";
/// Raised when a reader of the old layout would misread the new one. 2: the checkpoint is in units of
/// the wire, and not in those of the configuration.
inline constexpr std::int64_t result_format_version = 2;

}  // namespace wirepack
