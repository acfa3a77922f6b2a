#pragma once

#include <cstdint>
#include <string_view>

namespace wirepack {

inline constexpr std::string_view result_format = "wirepack";
/// Raised when a reader of the old layout would misread the new one. 2: the checkpoint is in units
/// of the wire, and not in those of the configuration. 3: what is read has checksums, and the
/// checkpoint holds all of a progress.
inline constexpr std::int64_t result_format_version = 3;

// What wirepack reads of the attributes of /, with a checksum.
inline constexpr const char* provenance_group = "provenance";
inline constexpr const char* checkpoint_group = "checkpoint";
inline constexpr const char* checkpoint_before_group = "checkpoint_before";

}  // namespace wirepack
