#pragma once

#include <optional>
#include <string>
#include <vector>

#include "palette.hpp"
#include "tube.hpp"

namespace wirepack {

/// Where a wire is seen from, in parallel projection: the viewer is at `right` x `up`, and sees a
/// square about the origin.
struct Camera {
  Vec3 right, up;             ///< unit, at a right angle
  double half_width;          ///< of the square
  std::optional<double> cut;  ///< nothing is left that is nearer to the viewer than this height
};

/// Pixels, row by row from the top.
struct Picture {
  int width, height;
  std::vector<Colour> pixels;
};

/// A square picture of a wire of round section with round ends. `line.colour` are shares of the
/// palette. Every pixel's line of sight is met with the cylinder of each piece of the line and the
/// spheres at its points exactly. Cut faces are flat, in the very colours of the palette, within a
/// dark border; where strands overlap, a point belongs to the nearer axis. What lies deep among
/// other strands is dark, what lies far behind is pale.
Picture wire_picture(const SmoothLine& line, double radius, const Camera& camera, int width);

/// A white one.
Picture blank_picture(int width, int height);

/// Puts a part into a picture that has room for it.
void put(Picture& picture, const Picture& part, int left, int top);

/// The picture as a file, portable pixmap: its pixels follow the header, three bytes each.
std::string pixmap(const Picture& picture);
std::string pixmap_header(const Picture& picture);

}  // namespace wirepack
