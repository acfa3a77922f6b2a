#include "wire_picture.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace wirepack {

namespace {

constexpr double nowhere = -std::numeric_limits<double>::infinity();

// Of a pixel in a list row by row.
std::size_t place_of(int column, int row, int width) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(column);
}

/// A piece of wire, in axes of the picture: right, up, towards the viewer.
struct Capsule {
  Vec3 start, axis;
  double length, radius;
};

/// What a line of sight meets.
struct Seen {
  double height = nowhere;      ///< towards the viewer
  Vec3 normal = Vec3::UnitZ();  ///< of the surface, or of the one that goes through a face's point
  double share = 0;             ///< of the piece's length
  double from_axis = -1;        ///< of a point of a cut face, else negative
  Index piece = 0;
  bool is_face() const { return from_axis >= 0; }
};

std::optional<Seen> cut_face(const Capsule& c, const Vec3& point) {
  const double along = std::clamp((point - c.start).dot(c.axis), 0.0, c.length);
  const Vec3 from_axis = point - c.start - along * c.axis;
  const double distance = from_axis.norm();
  if (distance > c.radius) return std::nullopt;
  return Seen{point.z(), from_axis / std::max(distance, 1e-12), along / c.length, distance, 0};
}

// The surface that is nearest to the viewer: that of the cylinder, or of the spheres at its ends.
Seen surface(const Capsule& c, double x, double y) {
  Seen seen;
  const Vec3 m = Vec3(x, y, 0) - c.start;
  const Vec3 across = m - m.dot(c.axis) * c.axis;
  const double square = 1 - c.axis.z() * c.axis.z();
  const double root =
      across.z() * across.z() - square * (across.squaredNorm() - c.radius * c.radius);
  if (square > 1e-12 && root >= 0) {
    const double height = (std::sqrt(root) - across.z()) / square;
    const double along = m.dot(c.axis) + height * c.axis.z();
    if (along >= 0 && along <= c.length) {
      const Vec3 normal = across + height * (Vec3::UnitZ() - c.axis.z() * c.axis);
      seen = {height, normal / c.radius, along / c.length, -1, 0};
    }
  }
  for (const double share : {0.0, 1.0}) {
    const Vec3 centre = c.start + share * c.length * c.axis;
    const double beside = (x - centre.x()) * (x - centre.x()) + (y - centre.y()) * (y - centre.y());
    if (beside > c.radius * c.radius) continue;
    const double up = std::sqrt(c.radius * c.radius - beside);
    if (centre.z() + up <= seen.height) continue;
    seen = {centre.z() + up, (Vec3(x, y, centre.z() + up) - centre) / c.radius, share, -1, 0};
  }
  return seen;
}

/// Pieces of the line, the nearest to the viewer first: most of what they hide costs little then.
std::vector<Index> from_the_front(const Points& points) {
  std::vector<Index> pieces;
  for (Index k = 0; k + 1 < points.cols(); ++k) {
    if (points.col(k) != points.col(k + 1)) pieces.push_back(k);
  }
  std::sort(pieces.begin(), pieces.end(), [&](Index i, Index j) {
    return points(2, i) + points(2, i + 1) > points(2, j) + points(2, j + 1);
  });
  return pieces;
}

/// Lines of sight through the middles of pixels, and which piece of wire each meets first.
class Sights {
 public:
  Sights(const SmoothLine& line, double radius, const Camera& camera, int width)
      : camera_(camera), width_(width), met_(place_of(0, width, width)) {
    for (Index k = 0; k + 1 < line.points.cols(); ++k) {
      const Vec3 step = line.points.col(k + 1) - line.points.col(k);
      capsules_.push_back({line.points.col(k), step.normalized(), step.norm(), radius});
    }
    for (const Index k : from_the_front(line.points)) meet(k);
  }

  int width() const { return width_; }
  /// Of pixels beside the picture: as at its border.
  double height(int column, int row) const { return met(column, row).height; }
  Seen seen(int column, int row) const {
    const Met& found = met(column, row);
    if (found.height == nowhere) return {};
    Seen result = nearest(capsules_[static_cast<std::size_t>(found.piece)], column, row);
    result.piece = found.piece;
    return result;
  }

 private:
  // Small, as there are millions.
  struct Met {
    float height = nowhere, from_axis = -1;
    std::int32_t piece = 0;
  };

  const Met& met(int column, int row) const {
    return met_[place_of(std::clamp(column, 0, width_ - 1), std::clamp(row, 0, width_ - 1),
                         width_)];
  }
  void meet(Index piece) {
    const Capsule& c = capsules_[static_cast<std::size_t>(piece)];
    const Vec3 end = c.start + c.length * c.axis;
    const Vec3 low = c.start.cwiseMin(end).array() - c.radius;
    const Vec3 high = c.start.cwiseMax(end).array() + c.radius;
    const auto top = static_cast<float>(std::min(high.z(), camera_.cut.value_or(high.z())));
    if (top < low.z()) return;
    for (int row = pixel(-high.y()); row <= pixel(-low.y()); ++row) {
      for (int column = pixel(low.x()); column <= pixel(high.x()); ++column) {
        Met& before = met_[place_of(column, row, width_)];
        if (before.height > top) continue;
        const Seen seen = nearest(c, column, row);
        const Met now{static_cast<float>(seen.height), static_cast<float>(seen.from_axis),
                      static_cast<std::int32_t>(piece)};
        // of faces at the same height the one about the nearer axis
        if (now.height > before.height ||
            (now.height == before.height && seen.is_face() && now.from_axis < before.from_axis)) {
          before = now;
        }
      }
    }
  }
  double place(int pixel) const { return ((pixel + 0.5) / width_ * 2 - 1) * camera_.half_width; }
  int pixel(double place) const {
    const double at = (place / camera_.half_width + 1) / 2 * width_;
    return static_cast<int>(std::clamp(at, 0.0, width_ - 1.0));
  }
  // A capsule is convex: what its front has lost to the cut shows a face, or nothing of it is left.
  Seen nearest(const Capsule& c, int column, int row) const {
    const double x = place(column), y = -place(row);
    Seen front = surface(c, x, y);
    if (!camera_.cut || front.height <= *camera_.cut) return front;
    return cut_face(c, {x, y, *camera_.cut}).value_or(Seen{});
  }

  Camera camera_;
  int width_;
  std::vector<Capsule> capsules_;
  std::vector<Met> met_;
};

/// Means of heights over squares around pixels, from sums over all pixels above and to the left.
class MeanHeights {
 public:
  MeanHeights(const Sights& sights, double of_nothing)
      : stride_(sights.width() + 1), sums_(place_of(0, stride_, stride_)) {
    for (int row = 0; row < sights.width(); ++row) {
      for (int column = 0; column < sights.width(); ++column) {
        const double height = std::max(of_nothing, sights.height(column, row));
        sum(column + 1, row + 1) =
            height + sum(column, row + 1) + sum(column + 1, row) - sum(column, row);
      }
    }
  }
  double around(int column, int row, int reach) {
    const int left = std::max(0, column - reach), right = std::min(stride_ - 1, column + reach + 1);
    const int top = std::max(0, row - reach), bottom = std::min(stride_ - 1, row + reach + 1);
    const double total = sum(right, bottom) - sum(left, bottom) - sum(right, top) + sum(left, top);
    return total / ((right - left) * (bottom - top));
  }

 private:
  double& sum(int column, int row) { return sums_[place_of(column, row, stride_)]; }
  int stride_;
  std::vector<double> sums_;
};

constexpr int finer = 2;  // pixels are means of so many each way, which smooths edges

using Channels = Eigen::Array3d;

constexpr double dark = 45;  // of borders

/// Paints what is seen.
class Painter {
 public:
  Painter(const Sights& sights, const Camera& camera, const SmoothLine& line, double radius)
      : sights_(sights),
        line_(line),
        heights_(sights, -camera.half_width),
        radius_(radius),
        nearest_(camera.cut.value_or(camera.half_width)),
        farthest_(-camera.half_width),
        pixels_per_radius_(radius / camera.half_width * sights.width() / 2) {}

  Channels colour(int column, int row) {
    const Seen seen = sights_.seen(column, row);
    const int border = std::clamp(static_cast<int>(0.06 * pixels_per_radius_), 1, 4);
    if (seen.height == nowhere) return Channels::Constant(255);
    const Colour flat =
        palette_colour(mixed(seen, line_.colour[seen.piece], line_.colour[seen.piece + 1]));
    const Channels own(flat.red, flat.green, flat.blue);
    if (seen.is_face()) {
      // as wide where the cut meets the surface at a small angle
      const double steep = std::sqrt(std::max(0.0, 1 - seen.normal.z() * seen.normal.z()));
      const double to_surface = (1 - seen.from_axis / radius_) * pixels_per_radius_;
      return to_surface < border * steep ? Channels::Constant(dark) : own;
    }
    Channels lit = Channels::Constant(dark);
    if (!hangs_over(column, row, border)) lit = (own * light(column, row, seen)).min(255);
    const double pale = 0.5 * (nearest_ - seen.height) / (nearest_ - farthest_);
    return lit + std::clamp(pale, 0.0, 0.6) * (255 - lit);
  }

 private:
  template <class T>
  static T mixed(const Seen& seen, const T& first, const T& last) {
    return (1 - seen.share) * first + seen.share * last;
  }
  Vec3 tangent(Index point) const {
    const Index before = std::max<Index>(point - 1, 0);
    const Index after = std::min(point + 1, line_.points.cols() - 1);
    return (line_.points.col(after) - line_.points.col(before)).normalized();
  }
  // At a right angle to the curve on which the pieces lie, so that they cannot be told apart.
  Vec3 normal(const Seen& seen) const {
    const bool at_tip = seen.piece == 0 && seen.share == 0;
    const bool at_inlet = seen.piece + 2 == line_.points.cols() && seen.share == 1;
    if (at_tip || at_inlet) return seen.normal;
    const Vec3 along = mixed(seen, tangent(seen.piece), tangent(seen.piece + 1)).normalized();
    return (seen.normal - seen.normal.dot(along) * along).normalized();
  }
  // Edges of strands in front of others are lines.
  bool hangs_over(int column, int row, int border) const {
    const double limit = sights_.height(column, row) - 0.5 * radius_;
    return sights_.height(column - border, row) < limit ||
           sights_.height(column + border, row) < limit ||
           sights_.height(column, row - border) < limit ||
           sights_.height(column, row + border) < limit;
  }
  double light(int column, int row, const Seen& seen) {
    const Vec3 lamp(-0.36, 0.48, 0.8);
    const double lambert = 0.45 + 0.7 * std::max(0.0, normal(seen).dot(lamp));
    const int reach = static_cast<int>(std::max(2.0, 1.2 * pixels_per_radius_));
    const double depth = heights_.around(column, row, reach) - seen.height;
    return lambert * (1 - 0.5 * std::clamp(depth / (2 * radius_), 0.0, 1.0));
  }

  const Sights& sights_;
  const SmoothLine& line_;
  MeanHeights heights_;
  double radius_, nearest_, farthest_, pixels_per_radius_;
};

Colour rounded(const Channels& c) {
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(x)); };
  return {byte(c[0]), byte(c[1]), byte(c[2])};
}

}  // namespace

Picture wire_picture(const SmoothLine& line, double radius, const Camera& camera, int width) {
  Eigen::Matrix3d axes;
  axes << camera.right.transpose(), camera.up.transpose(),
      camera.right.cross(camera.up).transpose();
  const SmoothLine turned{axes * line.points, line.colour};
  const Sights sights(turned, radius, camera, finer * width);
  Painter painter(sights, camera, turned, radius);
  Picture picture{width, width, {}};
  picture.pixels.reserve(place_of(0, width, width));
  for (int row = 0; row < width; ++row) {
    for (int column = 0; column < width; ++column) {
      Channels sum = Channels::Zero();
      for (int k = 0; k < finer * finer; ++k) {
        sum += painter.colour(finer * column + k % finer, finer * row + k / finer);
      }
      picture.pixels.push_back(rounded(sum / (finer * finer)));
    }
  }
  return picture;
}

Picture blank_picture(int width, int height) {
  return {width, height, std::vector<Colour>(place_of(0, height, width))};
}

void put(Picture& picture, const Picture& part, int left, int top) {
  for (int row = 0; row < part.height; ++row) {
    std::copy_n(part.pixels.begin() + row * part.width, part.width,
                picture.pixels.begin() + (top + row) * picture.width + left);
  }
}

std::string pixmap_header(const Picture& picture) {
  return fmt::format("P6\n{} {}\n255\n", picture.width, picture.height);
}

std::string pixmap(const Picture& picture) {
  std::string bytes = pixmap_header(picture);
  for (const Colour& c : picture.pixels) {
    for (const std::uint8_t channel : {c.red, c.green, c.blue}) bytes += static_cast<char>(channel);
  }
  return bytes;
}

}  // namespace wirepack
