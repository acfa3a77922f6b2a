#pragma once

#include <filesystem>
#include <string>

#include "wirepack/fit/shape_fit.hpp"
#include "wirepack/rod/reference_shape.hpp"

namespace wirepack {

/// Where a shape comes from, for whoever finds the file.
struct ShapeOrigin {
  std::string points_file, command_line;
};

/// A fitted shape as TOML text: model, numbers with their errors, k0(s), quality of the fit,
/// provenance. read_shape() gives its table back to the last bit.
std::string shape_text(const ShapeFit& fit, const ShapeOrigin& origin);

/// Writes shape_text() as a whole or not at all. Throws FileError.
void write_shape(const std::filesystem::path& file, const ShapeFit& fit, const ShapeOrigin& origin);

/// k0(s) of a shape file. Only `[shape] k0 = [[s, k1, k2, k3], ...]` is read, so such files can be
/// written by hand. Throws InvalidInput when there is no such table, or no such file.
DarbouxTable read_shape(const std::filesystem::path& file);

}  // namespace wirepack
