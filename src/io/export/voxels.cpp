#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/io/export.hpp"

namespace wirepack {

namespace {

constexpr Index most_voxels = 1024;  // to a side: a gigabyte

// The cube about the cavity, cut into voxels; each is probed at 4 x 4 x 4 points, a bit each.
struct Grid {
  double start, size;
  Index count;

  double centre(Index i) const { return start + size * (static_cast<double>(i) + 0.5); }
  Index first(double x) const {
    return std::max<Index>(0, static_cast<Index>(std::floor((x - start) / size)));
  }
  Index last(double x) const {
    return std::min(count - 1, static_cast<Index>(std::floor((x - start) / size)));
  }
  double probe(Index i, int k) const { return centre(i) + size * ((k + 0.5) / 4 - 0.5); }
};

Grid grid_of(const ExportSource& source) {
  const double a = source.scenario.wire.radius;
  const double radius = semi_axes_of(source.scenario.cavity).maxCoeff();
  const double wanted = source.voxel_size.value_or(std::max(a / 4, radius / 128));
  const double count = std::ceil(2 * radius / wanted * (1 - 1e-12));
  if (!(wanted <= 2 * radius && count <= static_cast<double>(most_voxels))) {
    throw InvalidInput(fmt::format(
        "--voxel {}: must be at least {:.4g}, as {} voxels to a side are the most, and at most {}",
        wanted, 2 * radius / most_voxels, most_voxels, 2 * radius));
  }
  return {-radius, 2 * radius / count, static_cast<Index>(count)};
}

// An edge of the wire as a solid: all points within a of it, but none beyond the flat ends of the
// wire where they are near.
class Edge {
 public:
  Edge(const Points& nodes, const Eigen::VectorXd& arc, Index edge, double radius)
      : from(nodes.col(edge)), to(nodes.col(edge + 1)), square_(radius * radius) {
    const Index last = nodes.cols() - 1;
    const auto cut = [&](Index end, Index neighbour, double away) {
      if (away >= 2 * radius) return;
      ends_.push_back({nodes.col(end), nodes.col(neighbour) - nodes.col(end)});
    };
    cut(0, 1, arc[edge]);
    cut(last, last - 1, arc[last] - arc[edge + 1]);
  }

  double square_distance(const Vec3& point) const {
    const Vec3 along = to - from;
    const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - from - t * along).squaredNorm();
  }
  bool is_cut() const { return !ends_.empty(); }
  bool contains(const Vec3& point) const {
    if (square_distance(point) > square_) return false;
    return std::all_of(ends_.begin(), ends_.end(),
                       [&](const End& end) { return (point - end.position).dot(end.inward) >= 0; });
  }

  const Vec3 from, to;

 private:
  struct End {
    Vec3 position, inward;
  };
  double square_;
  std::vector<End> ends_;
};

std::uint64_t probed(const Grid& grid, const Edge& edge, Index x, Index y, Index z,
                     std::uint64_t known) {
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t mask = std::uint64_t{1} << bit;
    if ((known & mask) != 0) continue;
    const Vec3 point(grid.probe(x, bit % 4), grid.probe(y, bit / 4 % 4), grid.probe(z, bit / 16));
    if (edge.contains(point)) known |= mask;
  }
  return known;
}

// Adds an edge to one layer of voxels.
void add_edge(const Grid& grid, const Edge& edge, double radius, Index z,
              std::vector<std::uint64_t>& layer) {
  const double half_diagonal = grid.size * std::sqrt(0.75);
  const double sure = radius - half_diagonal, near = radius + half_diagonal;
  const Vec3 low = edge.from.cwiseMin(edge.to).array() - radius;
  const Vec3 high = edge.from.cwiseMax(edge.to).array() + radius;
  for (Index y = grid.first(low.y()); y <= grid.last(high.y()); ++y) {
    for (Index x = grid.first(low.x()); x <= grid.last(high.x()); ++x) {
      std::uint64_t& voxel = layer[static_cast<std::size_t>(y * grid.count + x)];
      if (voxel == ~std::uint64_t{0}) continue;
      const double square = edge.square_distance({grid.centre(x), grid.centre(y), grid.centre(z)});
      if (square > near * near) continue;
      const bool whole = sure > 0 && square < sure * sure && !edge.is_cut();
      voxel = whole ? ~std::uint64_t{0} : probed(grid, edge, x, y, z, voxel);
    }
  }
}

std::vector<Edge> edges_of(const Points& nodes, double radius) {
  Eigen::VectorXd arc = Eigen::VectorXd::Zero(nodes.cols());
  for (Index i = 1; i < nodes.cols(); ++i) {
    arc[i] = arc[i - 1] + (nodes.col(i) - nodes.col(i - 1)).norm();
  }
  std::vector<Edge> edges;
  for (Index j = 0; j + 1 < nodes.cols(); ++j) edges.emplace_back(nodes, arc, j, radius);
  return edges;
}

std::string solid_fraction(const Grid& grid, const std::vector<Edge>& edges, double radius) {
  std::vector<std::uint64_t> layer(static_cast<std::size_t>(grid.count * grid.count));
  std::string bytes;
  bytes.reserve(layer.size() * static_cast<std::size_t>(grid.count));
  for (Index z = 0; z < grid.count; ++z) {
    std::fill(layer.begin(), layer.end(), 0);
    for (const Edge& edge : edges) {
      const auto [low, high] = std::minmax(edge.from.z(), edge.to.z());
      if (grid.first(low - radius) > z || grid.last(high + radius) < z) continue;
      add_edge(grid, edge, radius, z, layer);
    }
    for (const std::uint64_t voxel : layer) {
      bytes += static_cast<char>(std::lround(std::popcount(voxel) * 255.0 / 64));
    }
  }
  return bytes;
}

}  // namespace

ExportedFiles export_voxels(const ExportSource& source) {
  const double a = source.scenario.wire.radius;
  const Grid grid = grid_of(source);
  std::filesystem::path raw = source.target;
  raw.replace_extension(".raw");
  std::string header = "ObjectType = Image\nNDims = 3\n";
  for (const std::string& line : source.provenance) header += "Comment = " + line + "\n";
  header += fmt::format(
      "Comment = value / 255 is the part of a voxel that the wire fills\n"
      "BinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
      "Offset = {0} {0} {0}\nElementSpacing = {1} {1} {1}\nDimSize = {2} {2} {2}\n"
      "ElementType = MET_UCHAR\nElementDataFile = {3}\n",
      grid.centre(0), grid.size, grid.count, raw.filename().string());
  return {{raw, solid_fraction(grid, edges_of(source.frames.back().rod.nodes, a), a)},
          {source.target, header}};
}

}  // namespace wirepack
