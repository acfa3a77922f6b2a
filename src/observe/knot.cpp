#include "wirepack/observe/knot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "wirepack/core/random.hpp"
#include "wirepack/core/rotation.hpp"

#include "alexander.hpp"
#include "polygon_simplification.hpp"

namespace wirepack {

namespace {

constexpr Index largest_diagram = 100000;  // crossings; 70,000 of a loose spool take minutes

/// D(t) D(1/t) at 2 and 3: what no diagram changes but for the sign.
struct Fingerprint {
  std::uint64_t at_two, at_three;
  bool operator==(const Fingerprint&) const = default;
};

std::uint64_t unsigned_product(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t product = a * b % prime;
  return std::min(product, prime - product);
}

Fingerprint operator*(const Fingerprint& a, const Fingerprint& b) {
  return {unsigned_product(a.at_two, b.at_two), unsigned_product(a.at_three, b.at_three)};
}

template <class Polynomial>
Fingerprint fingerprint(Polynomial&& value) {
  return {unsigned_product(value(2), value(inverse(2))),
          unsigned_product(value(3), value(inverse(3)))};
}

struct KnownKnot {
  const char* name;
  std::array<int, 4> half;  // coefficients from the middle one outwards; they are symmetric
};

// Rolfsen's table.
constexpr std::array<KnownKnot, 15> known_knots{{{"unknot", {1, 0, 0, 0}},
                                                 {"3_1", {-1, 1, 0, 0}},
                                                 {"4_1", {-3, 1, 0, 0}},
                                                 {"5_1", {1, -1, 1, 0}},
                                                 {"5_2", {-3, 2, 0, 0}},
                                                 {"6_1", {-5, 2, 0, 0}},
                                                 {"6_2", {3, -3, 1, 0}},
                                                 {"6_3", {5, -3, 1, 0}},
                                                 {"7_1", {-1, 1, -1, 1}},
                                                 {"7_2", {-5, 3, 0, 0}},
                                                 {"7_3", {3, -3, 2, 0}},
                                                 {"7_4", {-7, 4, 0, 0}},
                                                 {"7_5", {5, -4, 2, 0}},
                                                 {"7_6", {7, -5, 1, 0}},
                                                 {"7_7", {9, -5, 1, 0}}}};

Fingerprint fingerprint(const KnownKnot& knot) {
  return fingerprint([&](std::uint64_t t) {
    const auto residue = [](int value) {
      return value < 0 ? prime - static_cast<std::uint64_t>(-value)
                       : static_cast<std::uint64_t>(value);
    };
    const std::uint64_t back = inverse(t);
    std::uint64_t up = 1, down = 1, sum = residue(knot.half[0]);
    for (std::size_t k = 1; k < knot.half.size(); ++k) {
      up = up * t % prime;
      down = down * back % prime;
      sum = (sum + residue(knot.half[k]) * ((up + down) % prime)) % prime;
    }
    return sum;
  });
}

std::string name_of(const Fingerprint& found) {
  for (const KnownKnot& knot : known_knots) {
    if (fingerprint(knot) == found) return knot.name;
  }
  for (std::size_t i = 1; i < known_knots.size(); ++i) {
    for (std::size_t j = i; j < known_knots.size(); ++j) {
      if (fingerprint(known_knots[i]) * fingerprint(known_knots[j]) != found) continue;
      return std::string(known_knots[i].name) + "#" + known_knots[j].name;
    }
  }
  return {};
}

std::vector<Crossing> smallest_diagram(const Points& polygon) {
  Random random(2);
  std::vector<Crossing> best;
  for (int k = 0; k < 12; ++k) {
    const Quat turn(Eigen::Vector4d(random.symmetric(), random.symmetric(), random.symmetric(),
                                    random.symmetric())
                        .normalized());
    std::vector<Crossing> diagram = knot_diagram(turn.toRotationMatrix() * polygon);
    if (k == 0 || diagram.size() < best.size()) best = std::move(diagram);
  }
  return best;
}

}  // namespace

KnotType knot_type(const Points& closed_polygon) {
  const std::vector<Crossing> diagram = smallest_diagram(simplified_polygon(closed_polygon));
  const auto crossings = static_cast<Index>(diagram.size());
  if (crossings > largest_diagram) return {.name = {}, .determinant = 0, .crossings = crossings};
  const auto value = [&](std::uint64_t t) { return alexander_polynomial(diagram, t); };
  return {name_of(fingerprint(value)), static_cast<std::uint32_t>(value(prime - 1)), crossings};
}

Points closed_outside(const Points& nodes) {
  const double far = 3 * nodes.colwise().norm().maxCoeff();
  const auto away = [](const Vec3& r) -> Vec3 {
    return r.norm() > 0 ? r.normalized() : Vec3::UnitX();
  };
  const Vec3 from = away(nodes.col(nodes.cols() - 1)), to = away(nodes.col(0));
  constexpr Index parts = 16;
  const Quat whole = Quat::FromTwoVectors(from, to);
  Points closed(3, nodes.cols() + parts + 1);
  closed.leftCols(nodes.cols()) = nodes;
  for (Index k = 0; k <= parts; ++k) {
    const Quat turn = Quat::Identity().slerp(static_cast<double>(k) / parts, whole);
    closed.col(nodes.cols() + k) = far * (turn * from);
  }
  return closed;
}

}  // namespace wirepack
