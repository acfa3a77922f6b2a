#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Darboux vector k0 = (k1, k2, k3) of a stress-free shape, in its own material frame, at one arc.
struct DarbouxRow {
  double arc;    ///< [length]
  Vec3 darboux;  ///< bending about the first and second axis, twist [1 / length]
  bool operator==(const DarbouxRow&) const = default;
};

/// Piecewise linear k0(s) along a wire, from arc 0 to its length.
class DarbouxTable {
 public:
  DarbouxTable() = default;
  /// Throws InvalidInput unless there are two rows at least, all finite, with arcs that start at 0
  /// and grow.
  explicit DarbouxTable(std::vector<DarbouxRow> rows);

  bool empty() const { return rows_.empty(); }
  const std::vector<DarbouxRow>& rows() const { return rows_; }
  double length() const { return rows_.empty() ? 0 : rows_.back().arc; }
  /// k0(s) and its integral from 0 to s, for s in [0, length].
  Vec3 darboux(double arc) const;
  Vec3 integral(double arc) const;
  bool operator==(const DarbouxTable& other) const { return rows_ == other.rows_; }

 private:
  std::size_t segment(double arc) const;

  std::vector<DarbouxRow> rows_;
  std::vector<Vec3> integrals_;  // up to each row
};

/// What a wire is beyond the length of its table: the table again, its last k0, or not allowed.
enum class BeyondShape { error, repeat, extend };

/// The stress-free shape of a wire that is neither straight nor a circle. Arc 0 is the tip, which
/// enters a cavity first; a right-handed helix (k3 > 0) stays right-handed whichever end that is.
struct ReferenceShape {
  DarbouxTable table;  ///< empty: the wire has no reference shape
  BeyondShape beyond = BeyondShape::error;

  bool empty() const { return table.empty(); }
  /// k0 at an arc from the tip, and its integral from the tip. Arcs before the tip take its k0,
  /// arcs beyond a table that is not to be exceeded the last one's.
  Vec3 darboux(double arc) const;
  Vec3 integral(double arc) const;
};

}  // namespace wirepack
