#include "wirepack/rod/reference_shape.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

// An arc as whole tables, an arc within the table, and what is left outside of it.
struct PlaceInTable {
  double whole_tables, within, beyond;
};

PlaceInTable place_of(const ReferenceShape& shape, double arc) {
  const double length = shape.table.length();
  if (shape.beyond == BeyondShape::repeat && arc > 0) {
    const double whole = std::floor(arc / length);
    return {whole, std::clamp(arc - whole * length, 0.0, length), 0};
  }
  const double within = std::clamp(arc, 0.0, length);
  return {0, within, arc - within};
}

}  // namespace

DarbouxTable::DarbouxTable(std::vector<DarbouxRow> rows)
    : rows_(std::move(rows)), integrals_(rows_.size(), Vec3::Zero()) {
  if (rows_.size() < 2) throw InvalidInput("k0 needs two rows at least");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto refuse = [i](const std::string& reason) {
      throw InvalidInput("k0, row " + std::to_string(i + 1) + ": " + reason);
    };
    if (!std::isfinite(rows_[i].arc) || !rows_[i].darboux.allFinite()) {
      refuse("all numbers must be finite");
    }
    if (i == 0 && rows_[i].arc != 0) refuse("the first arc must be 0");
    if (i == 0) continue;
    const double step = rows_[i].arc - rows_[i - 1].arc;
    if (!(step > 0)) refuse("arcs must grow from row to row");
    integrals_[i] = integrals_[i - 1] + step / 2 * (rows_[i].darboux + rows_[i - 1].darboux);
  }
}

std::size_t DarbouxTable::segment(double arc) const {
  const auto above = std::upper_bound(rows_.begin() + 1, rows_.end() - 1, arc,
                                      [](double a, const DarbouxRow& row) { return a < row.arc; });
  return static_cast<std::size_t>(above - rows_.begin()) - 1;
}

Vec3 DarbouxTable::darboux(double arc) const {
  const std::size_t i = segment(arc);
  const double u = (arc - rows_[i].arc) / (rows_[i + 1].arc - rows_[i].arc);
  return (1 - u) * rows_[i].darboux + u * rows_[i + 1].darboux;
}

Vec3 DarbouxTable::integral(double arc) const {
  const std::size_t i = segment(arc);
  return integrals_[i] + (arc - rows_[i].arc) / 2 * (rows_[i].darboux + darboux(arc));
}

Vec3 ReferenceShape::darboux(double arc) const {
  return table.darboux(place_of(*this, arc).within);
}

Vec3 ReferenceShape::integral(double arc) const {
  const PlaceInTable place = place_of(*this, arc);
  Vec3 result = table.integral(place.within) + place.beyond * table.darboux(place.within);
  if (place.whole_tables > 0) result += place.whole_tables * table.integral(table.length());
  return result;
}

}  // namespace wirepack
