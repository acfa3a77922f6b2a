#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wirepack/fit/measured_points.hpp"

namespace wirepack {

/// Points of a text file, one to a line: x, y, z, and an arc length and a standard error (of each
/// coordinate), between commas, semicolons, tabs or blanks; decimal commas where no comma
/// separates. Empty lines and comments (#, %) do not count. A header may name the columns, also as
/// a comment: x, y, z (or Points:0, Points:1, Points:2 of ParaView; r, a, s or l, p, s of 3D
/// Slicer), arc (or s, arc_length), sigma, in any case, with a unit behind them; other columns do
/// not count. Without a header, a fourth column is the arc and a fifth sigma. `columns`, where
/// given, says which are x, y, z[, arc[, sigma]], by their names or numbers from 1. A file .json is
/// 3D Slicer's markups.
///
/// Throws InvalidInput, with file, line and column, for text where a number should be, numbers that
/// are not finite, a line with another number of columns, a sigma that is not positive, columns of
/// different units, a file without points or that is no text; FileError when reading fails.
MeasuredPoints read_points(const std::filesystem::path& file,
                           const std::vector<std::string>& columns = {});

}  // namespace wirepack
