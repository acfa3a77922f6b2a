#pragma once

#include <string>

#include "wirepack/fit/measured_points.hpp"

namespace wirepack {

/// The control points of 3D Slicer's markups (.mrk.json), in the order of the file: the one list in
/// it that has points. Points that are not placed do not count. Its coordinate system, RAS or LPS,
/// does not matter: half a turn leads from one to the other. Throws InvalidInput.
MeasuredPoints markups_points(const std::string& text, const std::string& name);

}  // namespace wirepack
