#pragma once

#include <filesystem>

#include "wirepack/fit/measured_points.hpp"

namespace wirepack {

/// Points of a text file, one to a line: x, y, z, and an arc length and a standard error (of each
/// coordinate) where there are more columns, separated by commas, semicolons or blanks. Empty lines and those
/// that start with # do not count. A header line may name the columns: x, y, z, arc (or s, arc_length),
/// sigma; without one, a fourth column is the arc and a fifth sigma.
///
/// Throws InvalidInput, with file, line and column, for text where a number should be, numbers that
/// are not finite, a line with another number of columns, a sigma that is not positive, a file
/// without points or that is no text; FileError when reading fails.
MeasuredPoints read_points(const std::filesystem::path& file);

}  // namespace wirepack
